"""What ranges say for all values together: where the refuter does not go, what a range may not be is known from it."""

from dataclasses import replace

import pytest
from sympy import Abs, Interval, KroneckerDelta, Rational, Sum, Symbol, binomial, oo

from bezteach.proof import INVALID, PROVED, REFUTED, prove
from bezteach.proof.derivations import check_derivation
from bezteach.proof.errors import ReplayFailed
from bezteach.proof.ranges import Integers
from bezteach.proof.regions import has_values
from bezteach.symbolic import k, n

m, q, s, z = (Symbol(name, integer=True) for name in "mqsz")
HALF = Rational(1, 2)


def test_a_range_may_not_end_above_what_is_assumed():
    """At m = 21 the range of w, which is no positive number, ends at 1; SymPy makes 0 of delta(w, 1) at once."""
    w = Symbol("w", integer=True, nonpositive=True)
    sides = Sum(KroneckerDelta(w, k), (k, 1, 1)) + m, m
    verdict = prove(*sides, given={w: (-oo, m - 20)})
    assert (verdict.status, verdict.note) == (INVALID, "the range of w may go beyond what is assumed of it")
    assert prove(*sides, given={m: (0, 20), w: (-oo, m - 20)}).status == PROVED


def test_half_of_a_whole_number_is_not_rounded_up_to_what_is_assumed():
    """At n = 40, m = q = -1 the range of w, which is not negative, begins at -1/2; SymPy makes w of |w| at once."""
    w = Symbol("w", nonnegative=True)
    near = {n: (0, oo), m: (39 - n, oo), q: (n - 41, m)}
    verdict = prove(Abs(w) + n * q, w + n * q, given=near | {w: Interval(m / 2, oo)})
    assert (verdict.status, verdict.note) == (INVALID, "the range of w may go beyond what is assumed of it")
    assert prove(Abs(w) + n * q, w + n * q, given=near | {w: Interval(m / 2 + HALF, oo)}).status == PROVED


def test_from_a_half_on_there_need_be_no_whole_number():
    """No z is there for q = 0, so that nothing is said of it: neither of n, m, s = 30, 0, 0, where the ends differ."""
    given = {n: (0, oo), m: (n - 30, oo), q: (m, oo), s: (30 - n, q), z: (HALF, q)}
    found = check_derivation([s, s + binomial(z - 1, q), s + KroneckerDelta(q, 0)], given=given)
    assert found.ends.status == PROVED
    assert z in found.ends.statement.ranges
    without = {symbol: values for symbol, values in found.ends.statement.ranges.items() if symbol != z}
    with pytest.raises(ReplayFailed, match="for some values z, which is in a part of the proof only, has none"):
        replace(found.ends, statement=found.ends.statement._replace(ranges=without)).replay()


def test_between_two_ends_that_an_interval_leaves_out_there_need_be_none():
    """No x is there for n = 0, so that nothing is said of it, where the lines without x differ."""
    x = Symbol("x", real=True)
    lines = [n, n + KroneckerDelta(n, 0), n + (x + 1) ** 2 - x**2 - 2 * x - 1]
    found = check_derivation(lines, given={x: Interval.open(0, n)})
    assert REFUTED not in {verdict.status for line in found.lines[1:] for verdict in (line.step, line.whole)}
    assert check_derivation(lines, given={x: Interval(-1, n)}).first_wrong == 2


def test_which_ranges_are_known_to_hold_a_value():
    known = {n: Integers(0 * n, oo)}
    assert all(has_values(values, known) for values in (Integers(-oo, n), Integers(n, oo), Integers(-n, n)))
    assert not any(has_values(values, known) for values in (Integers(HALF, n), Integers(0 * n, n - HALF)))
    assert not has_values(Interval.open(0, n), known)
