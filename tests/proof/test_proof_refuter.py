"""The refuter: true identities of the course pass, their false twins fail at the smallest point, spelt out."""

from fractions import Fraction as F
from itertools import islice

import pytest
from sympy import (
    Abs,
    Derivative,
    Ge,
    Gt,
    Integral,
    Interval,
    Le,
    Lt,
    Subs,
    Sum,
    Symbol,
    binomial,
    factorial,
    oo,
    sqrt,
)

from bezteach.proof import INVALID, REFUTED, Budget, Undefined, counterexample, prove, statement
from bezteach.proof.exact.walk import integer_points, real_points
from bezteach.symbolic import B, E, b, i, j, k, n, r, step, t, u

c = Symbol("c", real=True)
m, s = (Symbol(name, integer=True, nonnegative=True) for name in "ms")
HALF, THIRD = F(1, 2), F(1, 3)
WITHIN = {i: (0, n)}
FROM_1 = {n: (1, oo), i: (0, n)}
ONE = {n: (1, oo)}
UNIT = {i: (0, n), t: Interval(0, 1)}
CURVE = Sum(B(i, n, t) * b[i], (i, 0, n))


def at_end(order, end):
    return Subs(Derivative(CURVE, (t, order)), t, end)


TRUE = {
    "unity": (Sum(B(i, n, t), (i, 0, n)), 1, None),
    "linear precision": (Sum(i / n * B(i, n, t), (i, 0, n)), t, ONE),
    "second moment": (Sum((i / n) ** 2 * B(i, n, t), (i, 0, n)), t**2 + t * (1 - t) / n, ONE),
    "symmetry": (B(i, n, t), B(n - i, n, 1 - t), None),
    "recursion": (B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, t), ONE),
    "derivative": (Derivative(B(i, n, t), t), n * (B(i - 1, n - 1, t) - B(i, n - 1, t)), ONE),
    "second derivative": (
        Derivative(B(i, n, t), (t, 2)),
        n * (n - 1) * (B(i - 2, n - 2, t) - 2 * B(i - 1, n - 2, t) + B(i, n - 2, t)),
        {n: (2, oo)},
    ),
    "elevation, 1 - t": ((1 - t) * B(i, n, t), (1 - i / (n + 1)) * B(i, n + 1, t), None),
    "elevation, t": (t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t), None),
    "elevation by r": (
        B(i, n, t),
        Sum(binomial(n, i) * binomial(r, k) / binomial(n + r, i + k) * B(i + k, n + r, t), (k, 0, r)),
        WITHIN,
    ),
    "product": (
        B(i, m, t) * B(j, n, t),
        binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * B(i + j, m + n, t),
        {i: (0, m), j: (0, n)},
    ),
    "integral": (Integral(B(i, n, t), (t, 0, 1)), 1 / (n + 1), WITHIN),
    "Gram": (
        Integral(B(i, n, t) * B(j, n, t), (t, 0, 1)),
        binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j) / (2 * n + 1),
        {i: (0, n), j: (0, n)},
    ),
    "power to Bernstein": (t**i, Sum(binomial(j, i) / binomial(n, i) * B(j, n, t), (j, i, n)), WITHIN),
    "Bernstein to power": (
        B(i, n, t),
        Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * t**j, (j, i, n)),
        None,
    ),
    "subdivision": (B(i, n, c * u), Sum(B(i, j, c) * B(j, n, u), (j, 0, n)), None),
    "de Casteljau": (
        Sum(B(i, k, t) * b[i + j], (i, 0, k)),
        Sum(B(i, k - 1, t) * ((1 - t) * b[i + j] + t * b[i + j + 1]), (i, 0, k - 1)),
        {k: (1, oo)},
    ),
    "curve in operator form": (step(t) ** n * b[0], CURVE, None),
    "r-th derivative": (
        Derivative(step(t) ** n, (t, r)),
        factorial(n) / factorial(n - r) * (E - 1) ** r * step(t) ** (n - r),
        {r: (0, n)},
    ),
    "at 0": (
        at_end(r, 0),
        factorial(n) / factorial(n - r) * Sum((-1) ** (r - k) * binomial(r, k) * b[k], (k, 0, r)),
        {r: (0, n)},
    ),
    "at 1": (at_end(1, 1), n * (b[n] - b[n - 1]), ONE),
    "first half": (Sum(B(j, n, u) * step(t) ** j, (j, 0, n)), step(t * u) ** n, None),
    "second half": (Sum(B(j, n, u) * step(t) ** (n - j) * E**j, (j, 0, n)), step(1 - (1 - t) * (1 - u)) ** n, None),
    "elevation of a curve": (
        CURVE,
        Sum(B(i, n + 1, t) * ((n + 1 - i) * b[i] + i * b[i - 1]) / (n + 1), (i, 0, n + 1)),
        None,
    ),
    "differences": ((E - 1) ** r * b[i], Sum((-1) ** k * binomial(r, k) * b[i + r - k], (k, 0, r)), None),
}


@pytest.mark.parametrize("name", TRUE)
def test_the_identities_of_the_course_are_not_refuted(name):
    lhs, rhs, given = TRUE[name]
    search = counterexample(statement(lhs, rhs, given), Budget(60))
    assert search.counterexample is None and search.undefined is None
    assert search.complete and search.skipped == 0 and search.checked >= 9


FALSE = [
    (Sum(B(i, n, t), (i, 1, n)), 1, None, {n: 0, t: HALF}, 0, 1),
    (Sum(B(i, n, t), (i, 0, n - 1)), 1, ONE, {n: 1, t: HALF}, HALF, 1),
    (Sum(i / (n + 1) * B(i, n, t), (i, 0, n)), t, ONE, {n: 1, t: HALF}, F(1, 4), HALF),
    (Sum((i / n) ** 2 * B(i, n, t), (i, 0, n)), t**2 + t * (1 + t) / n, ONE, {n: 1, t: HALF}, HALF, 1),
    (B(i, n, t), B(n - i, n, t), WITHIN, {n: 1, i: 0, t: THIRD}, F(2, 3), THIRD),
    (
        B(i, n, t),
        (1 - t) * B(i, n - 1, t) - t * B(i - 1, n - 1, t),
        FROM_1,
        {n: 1, i: 1, t: HALF},
        HALF,
        -HALF,
    ),
    (
        Derivative(B(i, n, t), t),
        (n - 1) * (B(i - 1, n - 1, t) - B(i, n - 1, t)),
        FROM_1,
        {n: 1, i: 0, t: HALF},
        -1,
        0,
    ),
    ((1 - t) * B(i, n, t), (1 + i / (n + 1)) * B(i, n + 1, t), WITHIN, {n: 1, i: 1, t: HALF}, F(1, 4), F(3, 4)),
    (
        B(i, m, t) * B(j, n, t),
        binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * B(i + j, m + n + 1, t),
        {i: (0, m), j: (0, n)},
        {n: 0, m: 0, i: 0, j: 0, t: HALF},
        1,
        HALF,
    ),
    (Integral(B(i, n, t), (t, 0, 1)), 1 / n, FROM_1, {n: 1, i: 0}, HALF, 1),
    (
        Integral(B(i, n, t) * B(j, n, t), (t, 0, 1)),
        binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j) / (2 * n),
        {n: (1, oo), i: (0, n), j: (0, n)},
        {n: 1, i: 0, j: 0},
        THIRD,
        HALF,
    ),
    (
        t**i,
        Sum(binomial(j, i) / binomial(n, i) * B(j, n, t), (j, i + 1, n)),
        WITHIN,
        {n: 0, i: 0, t: HALF},
        1,
        0,
    ),
    (
        B(i, n, t),
        Sum(binomial(n, j) * binomial(j, i) * t**j, (j, i, n)),
        WITHIN,
        {n: 1, i: 0, t: HALF},
        HALF,
        F(3, 2),
    ),
    (
        B(i, n, c * u),
        Sum(B(i, j, c) * B(j, n, u), (j, 0, n - 1)),
        WITHIN,
        {n: 0, i: 0, c: HALF, u: HALF},
        1,
        0,
    ),
]


@pytest.mark.parametrize(("lhs", "rhs", "given", "values", "left", "right"), FALSE)
def test_a_twin_with_one_edge_wrong_is_refuted_at_the_smallest_point(lhs, rhs, given, values, left, right):
    found = counterexample(statement(lhs, rhs, given)).counterexample
    assert tuple(found) == (values, left, right)


def written(found):
    return found.point(), str(found.lhs), str(found.rhs)


@pytest.mark.parametrize(
    ("lhs", "rhs", "given", "expected"),
    [
        (
            step(t) ** n * b[0],
            t * step(t) ** (n - 1) * b[0] + (1 - t) * step(t) ** (n - 1) * b[1],
            ONE,
            ("n = 1, t = 1/3", "2*b[0]/3 + b[1]/3", "b[0]/3 + 2*b[1]/3"),
        ),
        (
            Derivative(step(t) ** n, (t, r)),
            factorial(n) / factorial(n - r) * (E - 1) ** r * step(t) ** (n - r + 1),
            {r: (0, n)},
            ("n = 0, r = 0, t = 1/2", "1", "E/2 + 1/2"),
        ),
        (
            Sum(B(j, n, u) * step(t) ** j, (j, 0, n)),
            step(t * (1 - u)) ** n,
            None,
            ("n = 1, t = 1/2, u = 1/3", "E/6 + 5/6", "E/3 + 2/3"),
        ),
        (
            CURVE,
            Sum(B(i, n + 1, t) * ((n + 1 - i) * b[i] + i * b[i - 1]) / (n + 1), (i, 0, n)),
            None,
            ("n = 0, t = 1/2", "b[0]", "b[0]/2"),
        ),
    ],
)
def test_operators_and_points_are_compared_letter_by_letter(lhs, rhs, given, expected):
    assert written(counterexample(statement(lhs, rhs, given)).counterexample) == expected


@pytest.mark.parametrize(
    ("lhs", "rhs", "given", "expected"),
    [
        # games, "degree elevation": the index of B on the right is not raised
        (t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t), WITHIN, ("n = 0, i = 0, t = 1/3", "1/3", "2/3")),
        # games, "recursion": the last argument should be t
        (
            B(i, n, t),
            (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, 1 - t),
            FROM_1,
            ("n = 2, i = 1, t = 1/3", "4/9", "1/3"),
        ),
        # games, "end points": the edge is turned round
        (at_end(1, 1), n * (b[n - 1] - b[n]), ONE, ("n = 1", "-b[0] + b[1]", "b[0] - b[1]")),
        # games, "derivative": a minus sign is lost
        (
            Derivative(B(i, n, t), t),
            n * B(i - 1, n - 1, t) * B(i, n - 1, t),
            FROM_1,
            ("n = 1, i = 0, t = 1/2", "-1", "0"),
        ),
        # games, "positive weights": the sum begins at 1;  "end points": B_n(0) for B_n(1)
        (Sum(B(i, n, t), (i, 1, n)), 1, ONE, ("n = 1, t = 1/2", "1/2", "1")),
        (B(n, n, 0), 1, ONE, ("n = 1", "0", "1")),
        # deck, derivatives of any order at 1: the sign goes with the wrong end
        (
            at_end(k, 1),
            factorial(n) / factorial(n - k) * Sum((-1) ** (k - i) * binomial(k, i) * b[n - i], (i, 0, k)),
            {k: (0, n)},
            ("n = 1, k = 1", "-b[0] + b[1]", "b[0] - b[1]"),
        ),
        # deck, third derivative: a sign;  notes, second difference: an index
        (
            (E - 1) ** 3 * b[0],
            b[3] - 3 * b[2] + 3 * b[1] + b[0],
            None,
            ("as it stands", "-b[0] + 3*b[1] - 3*b[2] + b[3]", "b[0] + 3*b[1] - 3*b[2] + b[3]"),
        ),
        ((E - 1) ** 2 * b[i], b[i + 1] - 2 * b[i + 1] + b[i], None, ("i = 0", "b[0] - 2*b[1] + b[2]", "b[0] - b[1]")),
        # deck, a quartic with a convex curve: (1 - x^2) for (1 - x)^2
        (
            B(1, 4, t) / 4 + c * B(2, 4, t) + B(3, 4, t) / 4,
            (1 - t) ** 3 * t + 6 * c * (1 - t**2) * t**2 + (1 - t) * t**3,
            None,
            ("c = 1/2, t = 1/2", "5/16", "11/16"),
        ),
    ],
)
def test_misprints_of_the_sources_are_refuted(lhs, rhs, given, expected):
    assert written(counterexample(statement(lhs, rhs, given)).counterexample) == expected


def test_the_recursion_needs_a_degree_of_1_because_one_side_is_undefined_at_0():
    lhs, rhs, _ = TRUE["recursion"]
    for sides in ((lhs, rhs), (rhs, lhs)):
        found = counterexample(statement(*sides, WITHIN)).counterexample
        assert found.values == {n: 0, i: 0, t: HALF}
        assert [isinstance(side, Undefined) for side in (found.lhs, found.rhs)] == [side == rhs for side in sides]
    assert repr(found) == "n = 0, i = 0, t = 1/2: undefined (B of degree -1) on the left, 1 on the right"


@pytest.mark.parametrize(
    ("lhs", "rhs", "given", "point"),
    [
        (B(i, n, t) / B(0, n, t), binomial(n, i) * (t / (1 - t)) ** i, WITHIN, "n = 0, i = 0, t = 1"),
        ((t**n - 1) / (t - 1), Sum(t**k, (k, 0, n - 1)), None, "n = 0, t = 1"),
        (B(i, n, t) / t, binomial(n, i) * t ** (i - 1) * (1 - t) ** (n - i), FROM_1, None),
        (t * (t ** (i - 1)), t**i, None, "i = 0, t = 0"),
        (u * (t ** (m - 1)), u * t**m / t, None, None),
        (binomial(i - 1, i - 1), 1, None, "i = 0"),
        (
            Derivative(step(t) ** n, (t, r)),
            factorial(n) / factorial(n - r) * (E - 1) ** r * step(t) ** (n - r),
            None,
            "n = 0, r = 1, t = 1/2",
        ),
    ],
)
def test_a_value_on_one_side_only_refutes(lhs, rhs, given, point):
    found = counterexample(statement(lhs, rhs, given))
    assert (found.counterexample and found.counterexample.point()) == point


def test_no_value_on_either_side_makes_it_invalid():
    verdict = prove(t / n, u / n)
    assert (verdict.status, verdict.note) == (
        INVALID,
        "neither side has a value at n = 0, t = 1/2, u = 1/2: division by 0",
    )
    verdict = prove(B(i, n, t) / t, binomial(n, i) * t ** (i - 1) * (1 - t) ** (n - i), given=FROM_1)
    assert (verdict.status, verdict.note[:47]) == (INVALID, "neither side has a value at n = 1, i = 0, t = 0")
    assert prove(B(i, n - 1, t), B(n - 1 - i, n - 1, 1 - t), given=WITHIN).status == INVALID


def test_an_earlier_point_decides():
    """At n = 0 both sides of the first have no value; the second already fails at n = 0, i = 0."""
    assert prove(B(i, n - 1, t), B(i, n - 1, 1 - t)).status == INVALID
    assert prove(B(i, n, t), 2 + 1 / (n - 3)).status == REFUTED


def test_shifted_edges_of_sums():
    """For n = 0 the sums are empty; SymPy's own convention would make the first true and the second false."""
    found = counterexample(statement(Sum(k, (k, 3, n)), (n - 2) * (n + 3) / 2)).counterexample
    assert (found.values, found.lhs, found.rhs) == ({n: 0}, 0, -3)
    assert counterexample(statement(Sum(k, (k, n + 2, n)), 0)).counterexample is None


def test_inequalities():
    assert counterexample(statement(Ge(B(i, n, t), 0), given=UNIT)).counterexample is None
    assert counterexample(statement(Le(B(i, n, t), 1), given=UNIT)).counterexample is None
    assert counterexample(statement(Le(B(i, n, t), B(i, n, i / n)), given={**UNIT, n: (1, oo)})).counterexample is None
    assert written(counterexample(statement(Gt(B(i, n, t), 0), given=UNIT)).counterexample) == (
        "n = 1, i = 0, t = 1",
        "0",
        "0",
    )
    assert counterexample(statement(Gt(B(i, n, t), 0), given={**UNIT, t: Interval.open(0, 1)})).counterexample is None
    assert counterexample(statement(Ge(B(i, n, t), 0))).counterexample.values == {n: 1, i: 0, t: 2}
    assert counterexample(statement(Lt(n, 7))).counterexample.values == {n: 7}


def test_what_cannot_be_evaluated_is_passed_over_and_counted():
    search = counterexample(statement((1 + sqrt(t)) ** 2, 1 + 2 * sqrt(t) + Abs(t), {t: Interval(0, 4)}))
    assert search.counterexample is None and search.checked >= 2 and search.skipped >= 2
    assert repr(search).endswith("passed over (an irrational root)")
    assert counterexample(statement(sqrt(t), t, {t: Interval(0, 8)})).counterexample.values == {t: 4}


def test_a_spent_budget_is_said():
    lhs, rhs, given = TRUE["subdivision"]
    search = counterexample(statement(lhs, rhs, given), Budget(0.002))
    assert search.counterexample is None and not search.complete and "out of time" in repr(search)


def ranges(given, *free):
    return statement(sum(b[x] if x.is_integer else x for x in free), 0, given).ranges


def first_reals(given, *free, count=None):
    return list(real_points(ranges(given, *free), (), count, Budget(10)))


def test_the_walk_through_the_integers():
    walk = list(integer_points(ranges({n: (1, 3), i: (0, n)}, n, i), 8, Budget(10)))
    assert walk == [(1, 0), (1, 1), (2, 0), (2, 1), (2, 2), (3, 0), (3, 1), (3, 2), (3, 3)]
    assert list(integer_points(ranges({n: (20, 22), i: (0, n)}, n, i), 3, Budget(10)))[:4] == [
        (20, 0),
        (20, 1),
        (20, 19),
        (20, 20),
    ]
    everywhere = Symbol("w", integer=True)
    assert list(integer_points(ranges({everywhere: (-oo, oo)}, everywhere), 4, Budget(10))) == [
        (0,),
        (1,),
        (-1,),
        (2,),
        (-2,),
    ]
    assert list(integer_points(ranges({everywhere: (-oo, -3)}, everywhere), 2, Budget(10))) == [(-3,), (-4,), (-5,)]
    assert list(integer_points(ranges({n: (1, 2), i: (n / 2, n)}, n, i), None, Budget(10))) == [(1, 1), (2, 1), (2, 2)]


def test_the_walk_through_the_reals():
    assert [t for (t,) in first_reals(None, t)][:6] == [HALF, THIRD, 2, 0, 1, -1]
    inside = [t for (t,) in first_reals({t: Interval(0, 1)}, t)]
    assert inside[:4] == [HALF, THIRD, 0, 1] and all(0 <= value <= 1 for value in inside)
    inside = [t for (t,) in first_reals({t: Interval.open(5, 6)}, t)]
    assert inside[:2] == [F(11, 2), F(16, 3)] and all(5 < value < 6 for value in inside)
    assert [t for (t,) in first_reals({t: Interval(7, oo)}, t)][:2] == [F(15, 2), F(22, 3)]
    assert first_reals(None, t, u)[:4] == [(HALF, HALF), (HALF, THIRD), (THIRD, HALF), (HALF, 2)]
    assert all(low < high < 1 for low, high in first_reals({t: Interval.open(0, 1), u: Interval.open(t, 1)}, t, u))
    assert len(set(islice(first_reals(None, t, count=300), 300))) == 300
