"""Sums that stop before the end, deltas and quotients are proved for every n, and nothing false is."""

from fractions import Fraction as F

import pytest
from proof_claims import m, some_mutants
from sum_claims import ALTERNATING, CLAIMS, DIVIDED, TAIL
from sympy import (
    Derivative,
    Integral,
    Interval,
    KroneckerDelta,
    S,
    Subs,
    Sum,
    Symbol,
    binomial,
    expand,
    factorial,
    nan,
    zoo,
)

from bezteach.proof import Budget, InvalidStatement, counterexample, evaluate, prove, statement
from bezteach.proof.equations.algebra import by_algebra
from bezteach.proof.equations.induction import by_induction
from bezteach.proof.terms.defined import check_defined
from bezteach.proof.terms.differences import difference
from bezteach.proof.terms.exchange import exchanged
from bezteach.proof.terms.linear import least
from bezteach.proof.terms.normal import POINT, Edge, normal
from bezteach.proof.terms.terms import Failure, written
from bezteach.symbolic import B, E, b, i, j, k, n, r, t, u

ALL = CLAIMS | DIVIDED


def either(claim):
    return by_algebra(claim, Budget(10)) or by_induction(claim, Budget(10))


@pytest.mark.parametrize("name", ALL)
def test_proved_for_every_n(name):
    lhs, rhs, ranges, _ = ALL[name]
    verdict = prove(lhs, rhs, given=ranges)
    assert verdict.status == "PROVED" and verdict.seconds < 5
    assert verdict.method in ("ratio of terms", "binomial theorem", "induction")
    assert verdict.steps[-1].expression == 0


@pytest.mark.parametrize("name", ALL)
def test_false_twins_are_refuted(name):
    lhs, _, ranges, twins = ALL[name]
    for twin in twins:
        kept = {s: ends for s, ends in ranges.items() if s in lhs.free_symbols | twin.free_symbols}
        assert prove(lhs, twin, given=kept).status == "REFUTED", twin
        assert either(statement(lhs, twin, kept)) is None, twin


@pytest.mark.parametrize("name", ALL)
def test_no_false_mutant_is_proved(name):
    """What is proved of every third mutant is judged by the exact evaluator, which knows nothing of the provers."""
    lhs, rhs, ranges, _ = ALL[name]
    tried = 0
    for left, right in some_mutants(lhs, rhs, name, 3):
        occurring = left.free_symbols | right.free_symbols
        try:
            claim = statement(left, right, {s: ends for s, ends in ranges.items() if s in occurring})
        except InvalidStatement:
            continue
        assert not left.has(nan, zoo) and not right.has(nan, zoo)
        tried += 1
        if either(claim) is not None:
            judged = counterexample(claim, Budget(1))
            assert judged.counterexample is None and judged.undefined is None, claim
    assert tried >= 2


def test_small_cases_written_out():
    """The quadratic: B_1 + B_2 = 2t - t^2, and the others as one writes them by hand."""
    values = {n: 2, i: 1, t: F(1, 3)}
    lhs, rhs, *_ = CLAIMS["tail sums"]
    assert evaluate(lhs, values) == evaluate(rhs, values) == 2 * F(1, 3) - F(1, 3) ** 2
    lhs, rhs, *_ = CLAIMS["by steps of the polygon"]
    by_hand = b[0] + (2 * t - t**2) * (b[1] - b[0]) + t**2 * (b[2] - b[1])
    at = {t: F(1, 3)}
    assert evaluate(lhs, {n: 2} | at) == evaluate(rhs, {n: 2} | at) == evaluate(by_hand, at)
    square = [[evaluate(Sum(ALTERNATING, (j, 0, k)), {k: row, i: column}) for column in range(3)] for row in range(3)]
    assert square == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert [evaluate(B(i, n, 1), {i: value, n: 2}) for value in range(4)] == [0, 0, 1, 0]
    lhs, rhs, *_ = CLAIMS["divided by the next"]
    assert evaluate(lhs, {n: 2}) == evaluate(rhs, {n: 2}) == 1 + F(2, 2) + F(1, 3)


@pytest.mark.parametrize(
    ("lhs", "rhs", "ranges"),
    [
        pytest.param(Sum(k, (k, i, 10)), 55 - i * (i - 1) / 2, {}, id="an empty sum is 0, from i = 12 on"),
        pytest.param(Sum(k, (k, 20, n)) + n * (n + 1) / 2, n * (n + 1), {}, id="a sum that is empty up to 19"),
        pytest.param(
            Sum(Sum(B(j, m, u) * (binomial(n, k) * binomial(k, i) + 1), (j, 0, m)), (k, 0, n)),
            binomial(n, i) * 2 ** (n - i) + n - i + 1,
            {i: (0, n)},
            id="one of two terms is 0 for k < i, and not the other",
        ),
        pytest.param(Sum(B(j, n, t), (j, i, n)), 1, {}, id="how many terms are missing is not known"),
        pytest.param(Sum(b[j + 1] - b[j], (j, i, n)), b[n + 1] - b[i], {}, id="empty, and not b[n+1] - b[i]"),
        pytest.param(Integral(2**r, (r, 0, 1)), 2**r, {}, id="a real exponent"),
        pytest.param(
            Integral(2 ** Symbol("x"), (Symbol("x"), 0, 1)), 2 ** Symbol("x"), {}, id="an exponent of two uses"
        ),
        pytest.param(Subs(1 / t, t, 0), 1, {}, id="a value at a pole"),
        pytest.param(Derivative(1 / u, u) * u**2, -1, {u: Interval.open(0, 1)}, id="no polynomial to differentiate"),
        pytest.param(t ** (i - n) * t ** (n - i), 1 + 0 * t, {i: (0, n), t: Interval(0, 1)}, id="0 to the power -1"),
        pytest.param(B(i, n, t) / t, B(i, n, t) / t, {i: (0, n), t: Interval(0, 1)}, id="undefined at 0"),
        pytest.param(1 / (2 * t - 1), 1 / (2 * t - 1), {t: Interval.open(0, 1)}, id="undefined inside"),
        pytest.param(0**n, 0, {}, id="0^0 is 1"),
        pytest.param(KroneckerDelta(i, j) * KroneckerDelta(j, k), KroneckerDelta(i, k), {}, id="through another"),
        pytest.param(Sum(KroneckerDelta(2 * k, n), (k, 0, n)), 1, {}, id="a delta that only even n meet"),
        pytest.param(Sum(KroneckerDelta(k, i), (k, 0, n)), 1, {}, id="a delta beyond the sum"),
        pytest.param(Sum(b[j + 1] - b[j], (j, 0, n / 2)), b[n / 2 + 1] - b[0], {}, id="half a sum"),
    ],
)
def test_known_holes_stay_closed(lhs, rhs, ranges):
    try:
        claim = statement(lhs, rhs, {s: ends for s, ends in ranges.items() if s in (lhs - rhs).free_symbols | {t, u}})
    except InvalidStatement:
        return
    assert either(claim) is None


def test_a_delta_counts_whole_numbers():
    assert [evaluate(KroneckerDelta(i, n), {i: value, n: 3}) for value in (2, 3, 4)] == [0, 1, 0]
    assert evaluate(Sum(KroneckerDelta(k, 2) * k**2, (k, 0, 5)), {}) == 4
    assert prove(KroneckerDelta(t, 0), 0).status == "INVALID"
    assert prove(KroneckerDelta(i, j, (2, 5)), KroneckerDelta(i, j)).status == "INVALID"
    x = Symbol("x")
    assert prove(KroneckerDelta(x, 0) * x, 0).status == "PROVED"
    assert prove(KroneckerDelta(i, j) / binomial(i, j), KroneckerDelta(i, j)).status == "REFUTED"


def test_a_gain_over_shifted_ranges_is_the_common_range_and_the_ends():
    for low, high in ((i, n), (i - 2, n), (0, i), (i, i + n), (-i, n - i), (0, n)):
        side = Sum(k**2 * i + 1, (k, low, high))
        gain = difference(side, i, [i, n - i - 3])
        for values in ({i: 0, n: 3}, {i: 1, n: 4}, {i: 2, n: 7}):
            now, after = (evaluate(side, {**values, i: values[i] + up}) for up in (0, 1))
            assert evaluate(gain, values) == after - now


def test_a_sum_that_may_be_empty_gains_nothing_that_is_not_there():
    assert difference(Sum(k, (k, i, n)), i, [i, n]).has(Sum)
    assert difference(Sum(k, (k, i, n)), i, [i, n - i]) == -i


@pytest.mark.parametrize(
    ("inner", "outer", "conditions"),
    [
        ((j, i, n), (i, 0, n), []),
        ((j, i + 1, n), (i, 0, n), []),
        ((j, i + 2, n), (i, 1, n + 3), []),
        ((j, 0, i), (i, 0, n), []),
        ((j, 2, i), (i, 1, n), []),
        ((j, k, i + k), (i, 0, n), [k]),
    ],
)
def test_an_exchange_of_sums_keeps_the_value(inner, outer, conditions):
    limits = tuple(map(S, outer))
    turned = exchanged(i**2 * Sum(j + i * j**2, inner), limits, [n, *conditions])
    for values in [{n: degree, k: start} for degree in range(5) for start in range(3)]:
        assert evaluate(turned, values) == evaluate(Sum(i**2 * Sum(j + i * j**2, inner), outer), values)


def test_no_exchange_where_the_range_is_no_triangle():
    for inner, outer in (((j, i, n), (i, 0, k)), ((j, 0, 2 * i), (i, 0, n)), ((j, i, i + 1), (i, 0, n))):
        assert exchanged(Sum(i * j, inner), tuple(map(S, outer)), [n, k]) is None
    assert exchanged(Sum(i, (j, i, n)) * Sum(j, (j, i, n)), (i, S.Zero, n), [n]) is None


def test_what_divides_on_an_interval():
    unit, open_unit = {t: Interval(0, 1)}, {t: Interval.open(0, 1)}
    for expr in (1 / t, 1 / (1 - t), 1 / (t - t**2), t ** (i - n), 1 / B(1, 2, t), 1 / (n + t), 1 / (t**2 + 1)):
        check_defined(expr, [i, n], open_unit)
    for expr, ranges in ((1 / t, unit), (1 / t, {}), (1 / (1 - 2 * t), open_unit), (1 / (t + u), open_unit)):
        with pytest.raises(Failure):
            check_defined(expr, [], ranges)
    with pytest.raises(Failure):
        check_defined(Integral(1 / t, (t, 0, 1)), [], open_unit)


PIECES = [
    Sum(B(k, n, t) * (k + 1), (k, i, n)),
    Sum(binomial(n, k) * t**k / (k + 1), (k, 0, n - 2)),
    Sum(B(k - 1, n, t) * E**k * POINT, (k, 2, n)),
    Sum(binomial(k, i) * B(k, n, t) - B(k, n, t), (k, 1, n)),
    Sum(t**k / factorial(k - 1) / factorial(n + 1 - k), (k, 2, n)),
    Sum(KroneckerDelta(k, i) * binomial(n, k), (k, 1, n)),
    Sum(Sum((-1) ** (k + j) * binomial(k, j) * binomial(j, i), (j, i, k)) * B(k, n, t), (k, i, n)),
    Sum(Sum(B(j, n, t), (j, k, n)) * B(k, n, u), (k, 0, n)),
]


@pytest.mark.parametrize("expr", PIECES)
def test_in_each_case_the_terms_have_the_value_of_the_expression(expr):
    """The terms against the evaluator, at every case the edges lead to."""
    whole, values = frozenset([n, i]), {t: F(2, 7), u: F(3, 5), POINT: F(5, 3)}

    def cases(conditions, depth):
        if depth == 0 or least(S.Zero, conditions) != 0:
            return
        try:
            yield conditions, sum((written(term) for term in normal(expr, whole, conditions)), S.Zero)
        except Edge as edge:
            yield from cases([*conditions, edge.form], depth - 1)
            yield from cases([*conditions, expand(-edge.form - 1)], depth - 1)
        except Failure:
            return

    for conditions, total in cases([i, n - i, n - 1], 6):
        for point in [{n: degree, i: index} for degree in range(1, 7) for index in range(degree + 1)]:
            if all(condition.subs(point) >= 0 for condition in conditions):
                assert evaluate(expr, point | values) == evaluate(total, point | values), (conditions, point)


def test_the_steps_of_an_induction_begin_with_its_first_case():
    lhs, rhs, ranges, _ = CLAIMS["tail sums"]
    verdict = prove(lhs, rhs, given=ranges)
    assert (verdict.method, verdict.note) == ("induction", "on i, from 1")
    assert TAIL.has(Sum) and verdict.certificate.symbol == i


def test_a_derivative_of_negative_order_is_not_dropped_beside_a_factor_0():
    """C(k, -1) = 0, but there is no derivative of order -1, and 0 times nothing is nothing."""
    curve = Sum(B(j, n, t) * b[j], (j, 0, n))
    line = Sum(binomial(k, r) * factorial(n - r) / factorial(n) * Subs(Derivative(curve, (t, r)), t, 0), (r, 0, k))
    assert prove(b[k], line, given={k: (0, n)}).status == "PROVED"
    false = line.func(line.function, (r, -1, k))
    assert by_algebra(statement(b[k], false, {k: (0, n)}), Budget(5)) is None
    assert prove(b[k], false, given={k: (0, n)}).status == "REFUTED"
