"""The ranges of letters, written as inequalities: what the ``given`` of ``proof.prove`` takes."""

from sympy import Integer, Interval, Rational, expand, oo, together

from .errors import InvalidAnswer
from .grammar import Grammar
from .names import INTEGERS, LETTERS, WHOLE
from .nodes import MAX_FACTORIAL, whole_formula
from .undefined import risks

_LETTERS = frozenset([*LETTERS.values(), *INTEGERS.values()]) - {LETTERS["E"]}
_TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "=": "="}


def ranges(tokens, integers=frozenset()):
    """The dictionary of ranges that the tokens of inequalities give; ``integers`` names letters without a sign."""
    commas = [t._replace(kind="sign", text=",") if t.kind == "name" and t.text == "and" else t for t in tokens]
    grammar = Grammar(commas, integers)
    chains = grammar.items(grammar.chain, "end")
    grammar.end()
    limits = {}
    for chain in chains if isinstance(chains, tuple) else [chains]:
        for letter, sign, limit in _limits_in(chain, commas):
            _narrow(limits.setdefault(letter, {}), letter, sign, limit)
    result = {letter: _range(letter, **found) for letter, found in limits.items()}
    _refuse_circles(result)
    return result


def _limits_in(chain, tokens):
    """Letter, sign and limit of each inequality of a chain, the letter on the left of the sign."""
    items = [item for _, item in chain]
    signs = [sign for sign, _ in chain[1:]]
    if not signs:
        raise InvalidAnswer("a range has a sign: write one such as n >= 1 or 0 <= t <= 1", items[0].position)
    if len(signs) == 1:
        left, right = items
        if left.value in _LETTERS:
            return [(left.value, signs[0].text, right)]
        if right.value in _LETTERS:
            return [(right.value, _TURNED[signs[0].text], left)]
        raise InvalidAnswer("a range belongs to one letter: write one such as n >= 1", left.position)
    if len(signs) > 2:
        raise InvalidAnswer("too many signs: write the ranges apart, 0 <= i <= j, j <= n", signs[2].position)
    low, middle, high = items
    alone = any(token.position == middle.position and token.kind == "name" for token in tokens)
    if not (alone and middle.value in _LETTERS):  # n >= 1 i >= 2 would be read as n >= 1*i >= 2
        message = "in the middle stands one letter: write 0 <= i <= n, and a comma between two ranges"
        raise InvalidAnswer(message, middle.position)
    if len({sign.text[0] for sign in signs}) == 2 or "=" in [sign.text for sign in signs]:
        raise InvalidAnswer("the two signs point in different directions: write 0 <= i <= n", signs[1].position)
    return [(middle.value, _TURNED[signs[0].text], low), (middle.value, signs[1].text, high)]


def _narrow(found, letter, sign, limit):
    """Add one limit to those found: the entries lower and upper, each with whether the limit itself is left out."""
    if isinstance(limit.value, tuple):
        raise InvalidAnswer("a limit is a number or a short formula: write 0 <= t <= 1", limit.position)
    value, position = limit
    if letter in WHOLE:
        whole_formula(value, f"a limit of {letter}", MAX_FACTORIAL, position)
        if value.has(letter):
            raise InvalidAnswer(f"the limit contains {letter} itself: take another letter", position)
        if sign in ("<", ">"):
            value = _nearest_inside(value, letter, sign, position)
        if value.is_Integer and value < 0 and sign != "<":
            raise InvalidAnswer(f"{letter} is never below 0: write a limit from 0 on", position)
    elif not value.is_Rational:
        raise InvalidAnswer(f"the limits of {letter} are numbers: write 0 <= {letter} <= 1", position)
    left_out = letter not in WHOLE and sign in ("<", ">")
    for side, signs, better in (("lower", (">", ">=", "="), 1), ("upper", ("<", "<=", "="), -1)):
        if sign in signs:
            found[side] = _tighter(found.get(side), (value, left_out, position), better, letter)


def _nearest_inside(value, letter, sign, position):
    """The limit itself left out: of whole numbers, those beyond p/q with whole p, q are those from (p -+ 1)/q on."""
    above, below = together(value).as_numer_denom()
    if not below.is_Integer or risks(value):
        raise InvalidAnswer(f"{letter} {sign} a quotient by letters is not read: write {sign}= here", position)
    return expand((above + {"<": -1, ">": 1}[sign]) / below)


def _tighter(old, new, better, letter):
    if old is None or old[0] == new[0]:
        return new if old is None or new[1] else old
    if not (isinstance(old[0], Rational) and isinstance(new[0], Rational)):
        raise InvalidAnswer(f"{letter} has two limits on this side: write only one", new[2])
    return new if (new[0] - old[0]) * better > 0 else old


def _range(letter, lower=None, upper=None):
    low, low_out, _ = lower or (Integer(0) if letter in WHOLE else -oo, False, 0)
    high, high_out, _ = upper or (oo, False, 0)
    position = max(limit[2] for limit in (lower, upper) if limit)
    if low.is_number and high.is_number and (low > high or low == high and (low_out or high_out)):
        raise InvalidAnswer(f"no {letter} is in this range: write the lower limit first", position)
    if letter in WHOLE:
        return low, high
    if low == high:
        raise InvalidAnswer(f"{letter} is only {low}: write this number in the place of {letter}", position)
    return Interval(low, high, low_out, high_out)


def _refuse_circles(result):
    """A prover runs through the letters one after another, so the limits of one must come before it."""
    whole = {letter: found for letter, found in result.items() if letter in WHOLE}
    left = {letter: low.free_symbols | high.free_symbols for letter, (low, high) in whole.items()}
    while left:
        free = [letter for letter, needs in left.items() if not needs & left.keys()]
        if not free:
            names = " and ".join(sorted(map(str, left)))
            raise InvalidAnswer(f"the limits of {names} depend on each other: write each limit once, 0 <= i <= n", 1)
        for letter in free:
            del left[letter]
