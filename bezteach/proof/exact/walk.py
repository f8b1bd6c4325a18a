"""The order in which the refuter walks: n from the lower end of its range, other integers, then t = 1/2, 1/3, 2, ...

The integers are walked through in a box that is as wide as the number of its points allows; in a range that is wider
than the box, both its ends are visited. A real range that excludes some of the usual values is filled up with inner
fractions and its closed ends.
"""

from fractions import Fraction
from functools import lru_cache
from itertools import count as counting
from itertools import islice, product

from sympy import oo

from ..errors import InvalidStatement, Undefined
from ..ranges import Integers, assumed, ends
from .arithmetic import number
from .evaluate import evaluator

WIDTHS = (8, 6, 5, 4, 3, 2)
MOST_INTEGER_POINTS = 600
VALUES = tuple(Fraction(*pair) for pair in ((1, 2), (1, 3), (2, 1), (0, 1), (1, 1), (-1, 1), (3, 4), (3, 1), (-5, 2)))
SHARES = VALUES[:2] + tuple(Fraction(*pair) for pair in ((2, 3), (1, 4), (3, 4), (1, 5), (1, 100), (99, 100)))
MOST_REAL_POINTS = {0: 1, 1: 9, 2: 24}


def widest(ranges, budget, most=MOST_INTEGER_POINTS):
    """The points of the widest box that has at most so many; of the narrowest one, at least the first ones."""
    finite = not any(isinstance(found, Integers) and {-oo, oo} & set(found) for found in ranges.values())
    for width in (None, *WIDTHS) if finite else WIDTHS:
        points = list(islice(integer_points(ranges, width, budget), most + 1))
        if len(points) <= most:
            return points
    return points[:most]


def integer_points(ranges, width, budget):
    """All values of the integer symbols, smallest first; ``width`` None walks through whole ranges, finite or not.

    >>> from bezteach.proof.budget import Budget
    >>> from sympy import S
    >>> from sympy.abc import i, n
    >>> list(integer_points({n: Integers(S(1), S(2)), i: Integers(S(0), n)}, None, Budget(1)))
    [(1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]
    """
    spans = [_span(symbol, found, tuple(ranges)[:place]) for place, (symbol, found) in enumerate(ranges.items())]
    count = sum(isinstance(found, Integers) for found in ranges.values())

    def walk(values):
        budget.spend()
        if len(values) == count:
            yield values
            return
        for value in _between(*spans[len(values)](values, budget), width):
            yield from walk((*values, value))

    return walk(())


def _span(symbol, found, before):
    """A function of the values of the symbols before this one: the ends of its range, None where there is none."""
    functions = [None if end in (oo, -oo) else evaluator(end, before) for end in ends(found)]
    least, greatest = (None if end in (oo, -oo) else int(end) for end in assumed(symbol, isinstance(found, Integers)))

    def span(values, budget):
        try:
            low, high = (f and number(f(values, budget), f"an end of the range of {symbol}") for f in functions)
        except Undefined as error:
            raise InvalidStatement(f"at {_where(before, values)} the range of {symbol} has no end: {error}") from None
        empty = None not in (low, high) and low > high
        below = None not in (low, least) and low < least
        above = None not in (high, greatest) and high > greatest
        if (below or above) and not empty:
            raise InvalidStatement(
                f"at {_where(before, values)} the range of {symbol} goes beyond what is assumed of it"
            )
        return low, high

    return span


def is_allowed(values, ranges, budget):
    """Whether a point is in the ranges, and a whole number wherever one must be."""
    symbols = tuple(ranges)
    for place, (symbol, found) in enumerate(ranges.items()):
        low, high = _span(symbol, found, symbols[:place])(values[:place], budget)
        open_ends = (False, False) if isinstance(found, Integers) else (found.left_open, found.right_open)
        if isinstance(found, Integers) and values[place] != int(values[place]):
            return False
        if not _fits(values[place], low, high, *open_ends):
            return False
    return True


def _fits(value, low, high, left_open, right_open):
    above = low is None or value > low or (value == low and not left_open)
    return above and (high is None or value < high or (value == high and not right_open))


def _where(symbols, values):
    return ", ".join(f"{symbol} = {value}" for symbol, value in zip(symbols, values, strict=True))


def _between(low, high, width):
    low, high = (None if low is None else -(-low // 1)), (None if high is None else high // 1)
    if low is None:
        start = 0 if high is None or high >= 0 else high
        places = (start + sign * step for step in counting() for sign in ((1, -1) if step else (1,)))
        inside = (place for place in places if high is None or place <= high)
        return inside if width is None else islice(inside, width + 1)
    if width is None or (high is not None and high - low <= width):
        return counting(low) if high is None else range(low, high + 1)
    if high is None:
        return range(low, low + width + 1)
    return [*range(low, low + width - 1), high - 1, high]


def real_points(ranges, integers, most, budget):
    """These integers with values of the real symbols: the plainest first, then two that differ, and so on."""
    reals = list(ranges.items())[len(integers) :]
    symbols = tuple(ranges)
    spans = [_span(symbol, found, symbols[: len(integers) + place]) for place, (symbol, found) in enumerate(reals)]
    most = MOST_REAL_POINTS.get(len(reals), 40) if most is None else most
    return islice(_combined(reals, spans, integers, most, budget), most)


def _combined(reals, spans, integers, most, budget):
    options = {}
    for choice in _choices(len(reals), most):
        budget.spend()
        values = integers
        for place, (_, interval), span in zip(choice, reals, spans, strict=True):
            key = (len(values), *span(values, budget))
            if key not in options:
                options[key] = list(islice(_inside(*key[1:], interval.left_open, interval.right_open), most))
            if place >= len(options[key]):
                break
            values = (*values, options[key][place])
        else:
            yield values


@lru_cache
def _choices(letters, most):
    """Which of its values each letter takes: by the sum of the places, so that no letter waits for another."""
    if letters > 10:
        return [[(place + turn) % 3 for place in range(letters)] for turn in range(3)]
    wide = min(most, int(4000 ** (1 / max(letters, 1))))
    return sorted(product(range(wide), repeat=letters), key=lambda places: (sum(places), places))


def _inside(low, high, left_open, right_open):
    """Rational numbers of an interval, the usual ones first, without end unless the interval is one point."""
    seen = set()
    for value in _proposed(low, high):
        if _fits(value, low, high, left_open, right_open) and value not in seen:
            seen.add(value)
            yield value


def _proposed(low, high):
    if low is not None and high is not None and low > high:
        return
    yield from VALUES
    if low is None and high is None:
        yield from (Fraction(place, 7) for place in counting(1))
    elif low is None or high is None:
        yield from (low + share if high is None else high - share for share in (*SHARES, 0))
        yield from (low + place if high is None else high - place for place in counting(1))
    elif low == high:
        yield low
    else:
        yield from (low + (high - low) * share for share in (*SHARES, 0, 1))
        yield from (low + (high - low) * Fraction(place, place + 11) for place in counting(1))
