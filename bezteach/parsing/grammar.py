"""The grammar: a recursive descent over the tokens that builds SymPy nodes as it goes.

statement  formula, or two formulas with one of = < <= > >= between them
formula    terms with + and - between them
term       factors with *, / or nothing between them
factor     signs, then an atom with its ! and its power
atom       number, letter, point, function call, bracket, LaTeX command
"""

from itertools import pairwise

from sympy import Rational

from . import latex
from .calls import call
from .errors import InvalidAnswer
from .names import FUNCTIONS, INTEGERS, LETTERS, POINTS, about, short
from .nodes import Item, bounded, calculate, expression, factorial_of, negative, number, point, power, relation
from .reader import CLOSING, RELATIONS, Reader

CURVES = "pxyz"  # letters that also name a curve or its coordinates, so that p(1 - t) is not taken for a product


class Grammar(Reader):
    """The rules, each of which reads its tokens and gives their value; ``integers`` names letters without a sign."""

    bare = None  # the letter or point that was read last, if it has neither ! nor a power

    def __init__(self, tokens, integers=frozenset()):
        super().__init__(tokens)
        self.letters = LETTERS | {name: INTEGERS[name] for name in integers}

    def statements(self):
        """One statement, or the tuple of those that commas separate."""
        values = self.items(self.statement, "end")
        self.end()
        return values

    def statement(self):
        first, *others = self.chain()
        if not others:
            return first[1].value
        (sign, second), *more = others
        if more:
            message = "one sign at a time: write the two statements apart, 0 <= t, t <= 1"
            if {sign.text, *(other.text for other, _ in more)} == {"="}:
                message = "one sign at a time: write two statements, or in a derivation each formula on its own line"
            raise InvalidAnswer(message, more[0][0].position)
        self.count(sign.position)
        return relation(sign.text, first[1].value, second.value, sign.position)

    def chain(self):
        """Formulas and the signs between them: pairs of the sign before, and the item."""
        parts = [(None, self.item())]
        while self.sees(*RELATIONS):
            sign = self.advance()
            parts.append((sign, self.item()))
        return parts

    def item(self):
        return self.item_of(self.formula)

    def formula(self):
        value = self.term()
        while self.sees("+", "-"):
            sign = self.advance()
            value = self._joined(sign.text, value, self.item_of(self.term), sign.position)
        return value

    def item_of(self, read, *args):
        position = self.token.position
        return Item(read(*args), position)

    def _joined(self, sign, left, right, position):
        self.count(position)
        return calculate(sign, expression(left, position), expression(*right), position)

    def term(self):
        """A product, from the left to the right as Python calculates it."""
        position, divided = self.token.position, False
        first = value = self.factor()
        while True:
            if self.sees("*", "/"):
                sign = self.advance()
                divided = sign.text == "/"
                value = self._joined(sign.text, value, self.item_of(self.factor), sign.position)
            elif self._begins_factor():
                if divided:
                    message = "is this below the fraction bar or beside it? Write 1/(2*t) or 1/2*t"
                    raise self.wrong(message)
                value = self._beside(value)
            else:
                return value if value is first else bounded(value, position)

    def _begins_factor(self):
        """Whether a factor begins here, with no sign before it."""
        token = self.token
        if token.kind == "number":
            raise InvalidAnswer(f"a sign is missing before {short(token.text)}: write * or ^", token.position)
        word = token.kind == "name" and not latex.is_differential(token)
        return word or token.kind == "command" or self.sees(*CLOSING)

    def _beside(self, value):
        """The product with the factor that stands beside it, where nobody can take it for something else."""
        name, bracket, is_sum = self.bare, self.token, self._sum_in_brackets()
        right = self.item_of(self.factor)
        if isinstance(value, tuple) and isinstance(right.value, tuple):
            raise InvalidAnswer("a comma is missing between two points: write (0, 0), (1, 2)", right.position)
        if name and bracket.text in ("(", "["):
            if bracket.text == "[" and not is_sum:
                message = f"{name} has no index: b[0] is a point, x[0] a coordinate; a product is written {name}*[...]"
                raise InvalidAnswer(message, right.position)
            if name in CURVES or not is_sum:
                message = f"{name}(...) may be a product or a function: write {name}*(...), or the function's formula"
                raise InvalidAnswer(message, right.position)
        return self._joined("*", value, right, right.position)

    def _sum_in_brackets(self):
        """Whether the bracket that begins here, if one does, holds a sum or difference."""
        depth = 0
        for before, token in pairwise(self.tokens[self.index :]):
            depth += (before.text in CLOSING) - (before.text in CLOSING.values())
            if depth == 0:
                return False
            if depth == 1 and token.text in ("+", "-") and before.text not in CLOSING:
                return True
        return False

    def factor(self):
        if not self.sees("+", "-"):
            return self._power()
        sign = self.advance()
        value = expression(self.nested(self.factor), sign.position)
        self.count(sign.position)
        return negative(value, sign.position) if sign.text == "-" else value

    def _power(self):
        start, before = self.token, self.tokens[self.index - 1]
        base = self.atom()
        if start.text == "{" and before.text == "^" and self.sees("!", "^"):
            raise self.wrong("does this belong to the exponent? Write (2^3)! or 2^(3!), and (2^3)^2 or 2^(3^2)")
        if self.sees("!"):
            base = self._factorial(base, start)
        if not self.sees("^"):
            return base
        sign = self.advance()
        if start.text == "b" and self.tokens[self.index - 2].text != "]":
            message = "is this a power or a point on the way? Write b[1]^2 for a power, g(t)^2*b[1] for the point b_1^2"
            raise InvalidAnswer(message, sign.position)
        exponent = self.item_of(self.nested, self.factor)
        self.bare = None
        is_root = isinstance(exponent.value, Rational) and not exponent.value.is_Integer
        self.count(sign.position, is_root)
        return power(expression(base, start.position), expression(*exponent), exponent.position)

    def _factorial(self, value, start):
        position = self.advance().position
        if self.sees("!"):
            raise self.wrong("n!! is not read: write (n!)! or n!*n!")
        self.count(position)
        self.bare = None
        return factorial_of(expression(value, start.position), start.position)

    def atom(self):
        token = self.token
        value = self._atom()
        known = token.kind == "name" and (token.text in LETTERS or token.text in POINTS)
        self.bare = str(value) if known else None
        return value

    def _atom(self):
        token = self.token
        if token.kind == "number":
            self.count(token.position)
            return number(self.advance().text, token.position)
        if token.kind == "command":
            return latex.command(self)
        if token.kind == "name":
            return self._named()
        if self.sees(*CLOSING):
            return self.nested(self.bracket)
        if token.kind == "end":
            raise InvalidAnswer("the formula ends too early: write what is missing here", token.position)
        message = f"something is missing before {short(token.text)}: write a number or a letter there"
        raise InvalidAnswer(message, token.position)

    def _named(self):
        token = self.advance()
        name = token.text
        self.count(token.position)
        if latex.is_derivative(self, token):
            return latex.derivative_as_fraction(self, token)
        if self.sees("_"):
            if name in POINTS:
                return point(name, *latex.script(self, f"{name}_{{i+1}}"))
            if FUNCTIONS.get(name) in ("sum", "integral"):
                return latex.big_operator(self, FUNCTIONS[name], token.position)
            if name in ("B", "C"):
                return latex.indexed_function(self, token)
        if name in POINTS and self.sees("["):
            return point(name, *self.item_of(self.nested, self.bracket))
        if name == "b" and self.token.kind == "number" and self.token.position == token.position + 1:
            return point(name, number(self.token.text, self.token.position), self.advance().position)
        if name in FUNCTIONS and self.sees("("):
            if name == "sqrt":
                self.count(token.position, root=True)
            return call(FUNCTIONS[name], self.nested(self.arguments), token.position)
        if name in LETTERS:
            return self.letters[name]
        if name in FUNCTIONS and name not in ("B", "C", "g"):
            raise InvalidAnswer(f"{name} needs its arguments in brackets: write {name}(...)", token.position)
        raise InvalidAnswer(about(name), token.position)

    def arguments(self):
        """The items in the brackets of a function."""
        value = self.bracket(self.item)
        return [value] if isinstance(value, Item) else list(value)
