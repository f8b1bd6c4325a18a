"""Exact points all over the range of a statement, and those of them that lie in a part of it."""

from fractions import Fraction
from itertools import islice

from ..budget import Budget
from ..errors import InvalidStatement, OutOfTime, ReplayFailed, Undefined, Unsupported
from ..exact.evaluate import evaluator
from ..exact.walk import integer_points, real_points
from ..ranges import Integers

WIDTHS = (6, 4, 3, 2)
MOST_INTEGER_POINTS, POINTS_OF_A_PART, REAL_POINTS = 120, 6, 2
SECONDS, SECONDS_A_VALUE = 60.0, 0.3


class Grid:
    """The points of a range at which a proof is tried, each a tuple of values of ``symbols``: integers, then reals."""

    def __init__(self, ranges):
        whole = {symbol: found for symbol, found in ranges.items() if isinstance(found, Integers)}
        self.ranges, self.whole, self.budget = whole | ranges, tuple(whole), Budget(SECONDS)
        self.symbols = tuple(self.ranges)
        self.integers = _integers(self.ranges, self.budget)

    def points(self, forms=()):
        """Points where these forms in the integer symbols are >= 0: a few, far from one another."""
        tests = [evaluator(form, self.whole) for form in forms]
        inside = [values for values in self.integers if all(test(values, self.budget) >= 0 for test in tests)]
        chosen = inside[:: max(1, len(inside) // POINTS_OF_A_PART)][:POINTS_OF_A_PART]
        return [point for values in chosen for point in real_points(self.ranges, values, REAL_POINTS, self.budget)]

    def evaluator(self, expr):
        """A function of a point: the exact value there, None if the evaluator cannot name it soon."""
        run = evaluator(expr, self.symbols)

        def value(point):
            try:
                return run(point, Budget(SECONDS_A_VALUE))
            except (Unsupported, OutOfTime):
                return None
            except Undefined as error:
                raise ReplayFailed(f"{expr} has no value at {self.words(point)}: {error}") from None

        return value

    def words(self, point):
        return ", ".join(f"{symbol} = {value}" for symbol, value in zip(self.symbols, point, strict=True)) or "all"

    def check_equal(self, one, other, points, what):
        """``ReplayFailed`` where two expressions differ at one of the points."""
        left, right = self.evaluator(one), self.evaluator(other)
        for point in points:
            values = left(point), right(point)
            if None not in values and values[0] != values[1]:
                raise ReplayFailed(f"{what}: {values[0]} is not {values[1]} at {self.words(point)}")


def _integers(ranges, budget):
    """The integer points of the widest box that has not too many."""
    try:
        for width in WIDTHS:
            points = list(islice(integer_points(ranges, width, budget), MOST_INTEGER_POINTS + 1))
            if len(points) <= MOST_INTEGER_POINTS:
                break
    except InvalidStatement as error:
        raise ReplayFailed(f"the ranges are not ranges: {error}") from None
    return points[:MOST_INTEGER_POINTS]


def sign_at(value):
    """The sign of an exact number; None for what has no sign."""
    return (value > 0) - (value < 0) if isinstance(value, int | Fraction) else None
