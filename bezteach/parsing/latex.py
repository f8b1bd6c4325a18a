r"""What is written as in LaTeX or on paper: \frac \binom \sqrt \sum_{i=0}^n, \int_0^1 .. dt, B_{i,n}(t), \frac{d}{dt}.

Each function reads from a ``grammar.Grammar`` and gives the SymPy node.
"""

from sympy import Integer, Rational

from .calls import basis, derivative_by, integral_over, sum_over
from .errors import InvalidAnswer
from .names import ADVICE, LETTERS
from .nodes import Item, binomial_of, calculate, expression, power


def command(grammar):
    """A LaTeX command and its arguments."""
    token = grammar.advance()
    grammar.count(token.position)
    if token.text in ("sum", "integral"):
        return big_operator(grammar, token.text, token.position)
    if token.text == "sqrt":
        grammar.count(token.position, root=True)
        if grammar.sees("["):
            raise grammar.wrong("only square roots are written so: write t^(1/3) for others")
        in_brackets = grammar.sees("{", "(")
        value, position = _argument(grammar, token.text, split=False)
        if not in_brackets and grammar.sees("^", "!"):
            raise grammar.wrong("is this below the root or beside it? Write sqrt(t^2) or sqrt(t)^2")
        return power(value, Rational(1, 2), position)
    if token.text == "frac" and grammar.sees("{") and grammar.tokens[grammar.index + 1].text == "d":
        grammar.advance()
        return _derivative(grammar, grammar.advance(), "}", "{")
    upper, lower = (_argument(grammar, token.text) for _ in range(2))
    if token.text == "binom":
        return binomial_of(upper, lower)
    return calculate("/", upper.value, lower.value, lower.position)


def _argument(grammar, name, split=True):
    r"""One group in braces, one letter or, as in \frac12, one digit."""
    token = grammar.token
    if split and token.kind == "number" and token.text.isdigit() and len(token.text) > 1:
        rest = token._replace(text=token.text[1:], position=token.position + 1)
        grammar.tokens[grammar.index] = rest
        grammar.count(token.position)
        return Item(Integer(int(token.text[0])), token.position)
    brackets = ("{",) if split else ("{", "(")
    if token.kind not in ("number", "name", "command") and not grammar.sees(*brackets):
        braces = "{2}" if name == "sqrt" else "{1}{2}" if name == "frac" else "{n}{i}"
        raise InvalidAnswer(rf"braces are missing here: write \{name}{braces}", token.position)
    return _group(grammar)


def script(grammar, example):
    """What is written below or above: one letter or number, or a group in braces."""
    grammar.advance()
    token = grammar.token
    if token.kind not in ("number", "name") and not grammar.sees("{", "("):
        raise InvalidAnswer(f"braces are missing here: write {example}", token.position)
    return _group(grammar)


def _group(grammar):
    """A bracket, or one thing without brackets."""
    brackets = grammar.sees("{", "(")
    value, position = grammar.item_of(grammar.atom) if brackets else grammar.item_of(grammar.nested, grammar.atom)
    return Item(expression(value, position), position)


def big_operator(grammar, rule, position):
    r"""\sum_{i=0}^{n} with the term that follows, or \int_0^1 with all up to dt."""
    example = r"\sum_{i=0}^{n} i^2" if rule == "sum" else r"\int_0^1 t^2 dt"
    lower = upper = None
    while grammar.sees("_", "^"):
        if grammar.sees("^"):
            upper = script(grammar, example)
        else:
            lower = _first_index(grammar, example) if rule == "sum" else [script(grammar, example)]
    if lower is None or upper is None:
        raise InvalidAnswer(f"the limits are missing: write {example}", position)
    if grammar.sees("+", "-"):
        raise grammar.wrong("put what follows the sign of the sum or integral in brackets")
    if rule == "sum":
        return sum_over(position, expression(*grammar.item_of(grammar.nested, grammar.term)), [[*lower, upper]])
    body = grammar.nested(grammar.item)
    if not is_differential(grammar.token):
        raise grammar.wrong(f"dt is missing at the end of the integral: write {example}")
    letter = _differential(grammar, example)
    if grammar.sees("^", "!"):
        raise grammar.wrong("does this belong to the integral? Put all of it in brackets, up to dt")
    return integral_over(position, expression(*body), [[letter, *lower, upper]])


def _first_index(grammar, example):
    """The index and where it starts, from _{i=0}."""
    grammar.advance()
    grammar.expect("{", f"write {example}")
    index = grammar.item_of(grammar.atom)
    grammar.expect("=", f"write {example}")
    start = grammar.item()
    grammar.expect("}", f"write {example}")
    return [index, start]


def indexed_function(grammar, token):
    r"""B_{i,n}(t), B_i^n(t) and C_n^i, after their first letter."""
    first = _pair(grammar) if token.text == "B" else [script(grammar, "C_n^i")]
    if len(first) == 1:
        if not grammar.sees("^"):
            raise grammar.wrong(ADVICE[token.text])
        first.append(script(grammar, "B_i^n(t)" if token.text == "B" else "C_n^i"))
    if token.text == "C":
        return binomial_of(*first)
    if not grammar.sees("("):
        raise grammar.wrong("the parameter of B is missing: write B_{i,n}(t), and a power as B_{i,n}(t)^2")
    at = grammar.nested(grammar.arguments)
    if len(at) != 1:
        raise InvalidAnswer(ADVICE["B"], token.position)
    return basis(token.position, *first, Item(expression(*at[0]), at[0].position))


def _pair(grammar):
    """The one or two items below a B."""
    if grammar.tokens[grammar.index + 1].text != "{":
        return [script(grammar, "B_{i,n}(t)")]
    grammar.advance()
    position = grammar.token.position
    items = grammar.nested(grammar.bracket, grammar.item)
    items = [items] if isinstance(items, Item) else list(items)
    if len(items) > 2:
        raise InvalidAnswer(ADVICE["B"], position)
    return [Item(expression(*item), item.position) for item in items]


def is_differential(token):
    """Whether this is the dt of an integral, or its d alone."""
    text = token.text
    return token.kind == "name" and (text == "d" or len(text) == 2 and text[0] == "d" and text[1] in LETTERS)


def _differential(grammar, example):
    token = grammar.advance()
    if not is_differential(token):
        raise InvalidAnswer(f"dt is missing here: write {example}", token.position)
    letter = (
        token._replace(text=token.text[1:], position=token.position + 1) if token.text != "d" else grammar.advance()
    )
    if letter.text not in LETTERS:
        raise InvalidAnswer(f"after d a letter is missing: write {example}", letter.position)
    return Item(LETTERS[letter.text], letter.position)


def is_derivative(grammar, token):
    """Whether this d begins d/dt or d^2/dt^2."""
    return token.text == "d" and grammar.sees("/", "^")


def derivative_as_fraction(grammar, token):
    return _derivative(grammar, token, "/")


def _derivative(grammar, token, *between):
    """d/dt or d^r/dt^r, after its first d, with the term that follows."""
    example = "diff(t^2, t)"
    one = Item(Integer(1), token.position)
    order = script(grammar, example) if grammar.sees("^") else one
    for sign in between:
        grammar.expect(sign, f"write a derivative as {example}")
    letter = _differential(grammar, example)
    again = script(grammar, example) if grammar.sees("^") else one
    if "}" in between:
        grammar.expect("}", f"write a derivative as {example}")
    if order.value != again.value:
        raise InvalidAnswer("the two orders of the derivative differ: write d^2/dt^2", again.position)
    if grammar.sees("+", "-"):
        raise grammar.wrong("put what follows the derivative in brackets")
    return derivative_by(token.position, expression(*grammar.item_of(grammar.nested, grammar.term)), letter, order)
