"""The refuter: walks through allowed points from the smallest on, and evaluates both sides exactly.

A point where the relation fails, or where exactly one side has a value, refutes. A point where neither has one makes
the statement invalid. A point that the evaluator cannot decide is passed over, and counted.
"""

from collections.abc import Iterator
from operator import eq, ge, gt, le, lt
from typing import NamedTuple

from bezteach.symbolic import text

from ..budget import Budget
from ..errors import OutOfTime, Undefined, Unsupported
from .evaluate import evaluator
from .polynomial import Polynomial, to_sympy
from .roots import roots
from .walk import real_points, widest

COMPARE = {"=": eq, ">=": ge, ">": gt, "<=": le, "<": lt}
DEFAULT_SECONDS = 4.0


class Counterexample(NamedTuple):
    """The values of the symbols, and what both sides are there: a number, a polynomial, or why there is no value."""

    values: dict
    lhs: object
    rhs: object

    def __repr__(self):
        return f"{self.point()}: {shown(self.lhs)} on the left, {shown(self.rhs)} on the right"

    def point(self):
        """The values in words."""
        return ", ".join(f"{symbol} = {value}" for symbol, value in self.values.items()) or "as it stands"


def shown(value):
    """A value in words."""
    return f"undefined ({value})" if isinstance(value, Undefined) else text(to_sympy(value))


class Search(NamedTuple):
    """What the refuter found: a counterexample, or a point where neither side has a value, or nothing so far."""

    counterexample: Counterexample | None = None
    undefined: Counterexample | None = None
    checked: int = 0
    skipped: int = 0
    reason: str = ""
    complete: bool = True

    def __repr__(self):
        words = f"{self.checked} point{'s' * (self.checked != 1)} checked"
        words += f", {self.skipped} passed over ({self.reason})" if self.skipped else ""
        return words + ("" if self.complete else ", out of time")


def counterexample(statement, budget=None):
    """Look for the smallest counterexample: n from the lower end of its range, then the other integers, then the reals.

    After the walk, the points at which a divisor vanishes.

    >>> from bezteach.symbolic import B, i, n, t
    >>> from bezteach.proof.statement import statement
    >>> counterexample(statement(t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t))).counterexample
    n = 0, i = 0, t = 1/3: 1/3 on the left, 2/3 on the right
    """
    budget = budget or Budget(DEFAULT_SECONDS)
    return search(prober(statement), walk(statement, budget), budget)


def counterexample_at(statement, integers, budget, count):
    """The same with the values of the integer symbols fixed, and as many as ``count`` values of the reals."""
    return search(prober(statement), real_points(statement.ranges, integers, count, budget), budget)


def walk(statement, budget):
    """The points that are tried, tuples of values in the order of the ranges."""
    first = []
    for integers in widest(statement.ranges, budget):
        for values in real_points(statement.ranges, integers, None, budget):
            if len(first) < 2:
                first.append(values)
            yield values
    yield from roots(statement, first, budget)


def search(probe, points: Iterator, budget):
    """The first of these points at which the probe finds something."""
    checked, skipped, reason = 0, 0, ""
    try:
        for values in points:
            budget.spend()
            try:
                found = probe(values, budget)
            except Unsupported as error:
                skipped, reason = skipped + 1, reason or str(error)
                continue
            checked += 1
            if found is not None:
                kind = "undefined" if all(isinstance(side, Undefined) for side in found[1:]) else "counterexample"
                return Search(**{kind: found}, checked=checked, skipped=skipped, reason=reason)
    except OutOfTime:
        return Search(checked=checked, skipped=skipped, reason=reason, complete=False)
    except Unsupported as error:
        return Search(checked=checked, skipped=skipped + 1, reason=str(error))
    return Search(checked=checked, skipped=skipped, reason=reason)


def prober(statement):
    """A function of (values, budget): a ``Counterexample`` where the statement fails or has no value, else None."""
    symbols, compare = tuple(statement.ranges), COMPARE[statement.relation]
    sides = [evaluator(side, symbols) for side in (statement.lhs, statement.rhs)]

    def probe(values, budget=None):
        left, right = (_value(side, values, budget) for side in sides)
        undefined = isinstance(left, Undefined) or isinstance(right, Undefined)
        if not undefined and compare is not eq and (isinstance(left, Polynomial) or isinstance(right, Polynomial)):
            raise Unsupported("an order of polynomials")
        if not undefined and compare(left, right):
            return None
        return Counterexample(dict(zip(symbols, values, strict=True)), left, right)

    return probe


def _value(side, values, budget):
    try:
        return side(values, budget)
    except Undefined as error:
        return error
