"""Inequalities of the course are proved for every n, and no false twin or mutant of them ever is."""

from contextlib import suppress
from fractions import Fraction
from itertools import product
from time import perf_counter

import pytest
from proof_claims import given, mutants
from sympy import (
    Add,
    Derivative,
    Ge,
    Gt,
    Integral,
    Interval,
    Le,
    Lt,
    Mul,
    Rational,
    S,
    Sum,
    Symbol,
    binomial,
    factorial,
    nan,
    oo,
    symbols,
    zoo,
)

from bezteach.bench import judge
from bezteach.proof import (
    Budget,
    InvalidStatement,
    OutOfTime,
    Undefined,
    Unsupported,
    counterexample,
    evaluate,
    statement,
)
from bezteach.proof.inequalities.sign_of import Region, signs
from bezteach.proof.inequalities.sign_sets import ANY
from bezteach.proof.inequalities.signs import by_signs
from bezteach.symbolic import B, i, j, k, n, r, t, u

UNIT, OPEN, LINE = Interval(0, 1), Interval.open(0, 1), Interval(-oo, oo)
HALF, QUARTER = Rational(1, 2), Rational(1, 4)
x = Symbol("x", real=True)
IN = {i: (0, n)}
WITHIN = IN | {t: UNIT}
INSIDE = IN | {t: OPEN}
FROM_1 = {n: (1, "oo")}
ALL, PART, SPREAD = (
    Sum(term, limits)
    for term, limits in ((B(k, n, t), (k, 0, n)), (B(k, n, t), (k, i, n)), ((k - n * t) ** 2 * B(k, n, t), (k, 0, n)))
)

CLAIMS = {
    "not negative": (Ge, B(i, n, t), 0, WITHIN, "signs of the factors"),
    "not negative, any index": (Ge, B(i, n, t), 0, {t: UNIT}, "signs of the factors"),
    "positive inside": (Gt, B(i, n, t), 0, INSIDE, "signs of the factors"),
    "first, before 1": (Gt, B(0, n, t), 0, {t: Interval.Ropen(0, 1)}, "signs of the factors"),
    "at most 1": (Le, B(i, n, t), 1, WITHIN, "bounds"),
    "below 1 inside": (Lt, B(i, n, t), 1, FROM_1 | INSIDE, "bounds"),
    "below 1, no end": (Lt, B(i, n, t), 1, {n: (2, "oo"), i: (1, n - 1), t: UNIT}, "bounds"),
    "product of two": (Le, B(i, n, t) * B(j, n, t), 1, {t: UNIT}, "bounds"),
    "b (1 - b)": (Le, B(i, n, t) * (1 - B(i, n, t)), QUARTER, WITHIN, "bounds"),
    "Bezier's own basis": (Le, PART, 1, WITHIN, "bounds"),
    "term of a sum": (Le, B(i, n, t), ALL, WITHIN, "part of a sum"),
    "part of a sum": (Le, PART, ALL, WITHIN, "part of a sum"),
    "maximum": (Le, B(i, n, t), B(i, n, i / n), FROM_1 | WITHIN, "peak"),
    "maximum inside": (Ge, B(i, n, i / n), B(i, n, t), FROM_1 | INSIDE, "peak"),
    "maximum turned round": (Ge, -B(i, n, t), -B(i, n, i / n), FROM_1 | WITHIN, "peak"),
    "maximum of powers": (
        Le,
        t**i * (1 - t) ** j,
        (i / (i + j)) ** i * (j / (i + j)) ** j,
        {i: (1, "oo"), t: UNIT},
        "peak",
    ),
    "counted": (Ge, binomial(n, i), 1, IN, "signs of the factors"),
    "log-concave": (Ge, binomial(n, i) ** 2, binomial(n, i - 1) * binomial(n, i + 1), IN, "signs of the factors"),
    "spread": (Le, SPREAD, n / 4, {t: UNIT}, "signs of the factors"),
    "spread is no less than 0": (Ge, SPREAD, 0, {t: UNIT}, "signs of the factors"),
    "integral": (Gt, Integral(B(i, n, t), (t, 0, 1)), 0, IN, "signs of the factors"),
    "middle of degree 2": (Le, B(1, 2, t), HALF, {}, "signs of the factors"),
    "middle of degree 3": (Lt, B(1, 3, t), HALF, {t: UNIT}, "signs of the factors"),
    "falls": (Le, Derivative(B(0, n, t), t), 0, {t: UNIT}, "signs of the factors"),
    "higher power": (Le, t ** (n + 1), t**n, {t: UNIT}, "signs of the factors"),
    "Bernoulli": (Ge, (1 + x) ** n, 1 + n * x, {x: Interval(-1, oo)}, "induction"),
    "first against its tangent": (Ge, B(0, n, t), 1 - n * t, {t: UNIT}, "induction"),
}


def claim(relation, lhs, rhs, ranges):
    return statement(relation(lhs, rhs, evaluate=False), given=given_ranges(ranges))


def given_ranges(ranges):
    return {s: r if isinstance(r, Interval) else given({s: r})[s] for s, r in ranges.items()}


@pytest.mark.parametrize("name", CLAIMS)
def test_proved_for_every_n(name):
    *parts, method = CLAIMS[name]
    found = by_signs(claim(*parts), Budget(20))
    assert found is not None and (found.status, found.method) == ("PROVED", method) and found.steps


def steps_of(name):
    return [str(step) for step in by_signs(claim(*CLAIMS[name][:4]), Budget(20)).steps]


def test_the_steps_of_the_maximum_name_the_derivative_its_root_and_where_it_lies():
    steps = steps_of("maximum")
    assert steps[0].startswith("Derivative(B(i, n, t), t) = ") and "(i - n*t)*B(i, n, t)" in steps[0]
    assert steps[1].startswith("t = i/n ")
    assert "i/n >= 0" in steps[2] and "i/n <= 1" in steps[3] and "B(i, n, t) <= B(i, n, i/n)" in steps[4]


def test_the_steps_of_the_bound_quote_the_sum_of_all():
    steps = steps_of("at most 1")
    assert steps[0].startswith("Sum(B(k, n, t), (k, 0, n)) = 1 ") and "binomial theorem" in steps[0]
    assert "B(i, n, t) <= 1" in steps[2]


FALSE = {
    "positive on the closed interval": (Gt, B(i, n, t), 0, WITHIN),
    "positive, index outside": (Gt, B(i, n, t), 0, {t: OPEN}),
    "negative argument": (Ge, B(i, n, t), 0, IN | {t: Interval(-1, 1)}),
    "beyond 1": (Ge, B(i, n, t), 0, IN | {t: Interval(0, 2)}),
    "all reals": (Ge, B(i, n, t), 0, IN),
    "turned round": (Le, B(i, n, t), 0, WITHIN),
    "first, at 1": (Gt, B(0, n, t), 0, {t: UNIT}),
    "bound 1/2": (Le, B(i, n, t), HALF, WITHIN),
    "strict bound on the closed interval": (Lt, B(i, n, t), 1, FROM_1 | WITHIN),
    "strict bound from degree 0": (Lt, B(i, n, t), 1, INSIDE),
    "strict bound with an end": (Lt, B(i, n, t), 1, {n: (2, "oo"), i: (1, n), t: UNIT}),
    "bound beyond 1": (Le, B(i, n, t), 1, IN | {t: Interval(0, 2)}),
    "at least 1": (Ge, B(i, n, t), 1, WITHIN),
    "b (1 - b), strict": (Lt, B(i, n, t) * (1 - B(i, n, t)), QUARTER, WITHIN),
    "b (1 - b), less": (Le, B(i, n, t) * (1 - B(i, n, t)), Rational(1, 5), WITHIN),
    "tail, strict": (Lt, PART, 1, WITHIN),
    "term of a sum from 1": (Le, B(i, n, t), Sum(B(k, n, t), (k, 1, n)), WITHIN),
    "term of a sum, strict": (Lt, B(i, n, t), ALL, WITHIN),
    "sum within its part": (Ge, PART, ALL, WITHIN),
    "part of a signed sum": (Le, B(i, n, t), ALL, IN | {t: Interval(-1, 1)}),
    "maximum, n + 1": (Le, B(i, n, t), B(i, n, i / (n + 1)), FROM_1 | WITHIN),
    "maximum, i + 1": (Le, B(i, n, t), B(i, n, (i + 1) / n), FROM_1 | WITHIN),
    "maximum, strict": (Lt, B(i, n, t), B(i, n, i / n), FROM_1 | WITHIN),
    "minimum": (Ge, B(i, n, t), B(i, n, i / n), FROM_1 | WITHIN),
    "maximum on all reals": (Le, B(i, n, t), B(i, n, i / n), FROM_1 | IN),
    "maximum beyond 1": (Le, B(i, n, t), B(i, n, i / n), FROM_1 | IN | {t: Interval(0, 3)}),
    "maximum from degree 0": (Le, B(i, n, t), B(i, n, i / n), WITHIN),
    "maximum of another index": (Le, B(i, n, t), B(j, n, j / n), FROM_1 | WITHIN | {j: (0, n)}),
    "counted outside": (Ge, binomial(n, i), 1, {}),
    "counted, strict": (Gt, binomial(n, i), 1, IN),
    "log-concave, strict and shifted": (Gt, binomial(n, i), binomial(n, i - 1), FROM_1 | IN),
    "spread, strict": (Lt, SPREAD, n / 4, {t: UNIT}),
    "spread, smaller": (Le, SPREAD, n / 5, {t: UNIT}),
    "middle of degree 2, strict": (Lt, B(1, 2, t), HALF, {t: UNIT}),
    "middle of degree 3, 2/5": (Le, B(1, 3, t), Rational(2, 5), {t: UNIT}),
    "rises": (Ge, Derivative(B(0, n, t), t), 0, {t: UNIT}),
    "falls, strict": (Lt, Derivative(B(0, n, t), t), 0, {t: UNIT}),
    "higher power, beyond 1": (Le, t ** (n + 1), t**n, {t: Interval(0, 2)}),
    "higher power, strict": (Lt, t ** (n + 1), t**n, {t: UNIT}),
    "Bernoulli, strict": (Gt, (1 + x) ** n, 1 + n * x, {x: Interval(-1, oo)}),
    "Bernoulli, too far left": (Ge, (1 + x) ** n, 1 + n * x, {x: Interval(-5, oo)}),
    "Bernoulli, turned round": (Le, (1 + x) ** n, 1 + n * x, {x: Interval(-1, oo)}),
    "an index that is caught": (Ge, Sum(B(i, n, t) / i, (i, 0, n)) * i, 0, FROM_1 | {i: (1, n), t: UNIT}),
    "a letter that is caught": (Le, Integral(B(i, n, t), (t, 0, 5)) * t, 5, WITHIN),
    "square root of 0": (Ge, t ** (i - HALF), 0, {t: UNIT}),
}


@pytest.mark.parametrize("name", FALSE)
def test_no_false_twin_is_proved_and_small_values_refute_it(name):
    try:
        twin = claim(*FALSE[name])
    except InvalidStatement:
        return
    assert by_signs(twin, Budget(20)) is None
    try:
        found = counterexample(twin, Budget(5))
    except InvalidStatement:
        return
    assert found.counterexample is not None or found.undefined is not None


def variants(relation, lhs, rhs, ranges):
    """One edit of a side, of the relation, or of a range."""
    lhs, rhs = S(lhs), S(rhs)
    yield from ((relation, left, rhs, ranges) for left in mutants(lhs))
    yield from ((relation, lhs, right, ranges) for right in mutants(rhs))
    yield from ((other, lhs, rhs, ranges) for other in (Ge, Gt, Le, Lt) if other != relation)
    for symbol, found in ranges.items():
        if isinstance(found, Interval):
            others = [Interval(found.start, found.end), Interval.open(found.start, found.end)]
            others += [Interval(found.start - 1, found.end), Interval(found.start, found.end + 1), LINE]
        else:
            low, high = given({symbol: found})[symbol]
            others = [(low + step, high) for step in (1, -1)] + [(low, high + step) for step in (1, -1) if high != oo]
        yield from ((relation, lhs, rhs, ranges | {symbol: other}) for other in others if other != found)
        yield relation, lhs, rhs, {s: r for s, r in ranges.items() if s != symbol}


def valid_variants(*parts):
    for relation, left, right, ranges in variants(*parts):
        letters = left.free_symbols | right.free_symbols
        if not left.has(nan, zoo, oo) and not right.has(nan, zoo, oo):
            with suppress(InvalidStatement):
                yield claim(relation, left, right, {s: r for s, r in ranges.items() if s in letters})


SAME_SHAPE = {"maximum inside", "maximum turned round", "part of a sum", "spread is no less than 0"}


@pytest.mark.parametrize("name", [name for name in CLAIMS if name not in SAME_SHAPE])
def test_no_false_mutant_is_proved(name):
    """What the prover proves of the mutants is judged by the exact evaluator, which knows nothing of the prover.

    Every fifth mutant is tried, the same ones each time, from another start for each claim.
    """
    sample = list(valid_variants(*CLAIMS[name][:4]))[list(CLAIMS).index(name) % 5 :: 5]
    for mutant in sample:
        if by_signs(mutant, Budget(10)) is not None:
            judged = counterexample(mutant, Budget(1))
            assert judged.counterexample is None and judged.undefined is None, mutant
    assert len(sample) >= 2


def test_an_integral_whose_limit_is_undefined_far_away_has_no_sign_there():
    """1/(n - 20) is no limit for n = 20, where neither side has a value; the refuter does not go that far."""
    far = Integral(x, (x, 0, 1 / (n - 20)))
    assert by_signs(claim(Ge, far + t, far, {t: UNIT}), Budget(5)) is None
    assert by_signs(claim(Ge, far * B(n + 1, n, t), 0, {t: UNIT}), Budget(5)) is None


def test_an_index_that_only_seems_to_move_sums_no_part_of_all():
    """k - (k - i) is i, so that from 50 to n = 70 the sum is 21 B(25, 70, t), which is 2 in the middle."""
    still, turned = Add(k, Mul(-1, k - i, evaluate=False), evaluate=False), n + i - k
    ranges = {n: (50, oo), i: (20, 25), t: UNIT}
    assert by_signs(claim(Le, Sum(B(still, n, t), (k, 50, n)), 1, ranges), Budget(5)) is None
    assert by_signs(claim(Le, Sum(B(turned, n, t), (k, 50, n)), 1, ranges), Budget(5)).method == "bounds"


def test_what_may_have_any_sign_is_shown_beside_a_factor_that_is_0():
    """The limits of the integral are not numbers: nothing is said of its sign, and nothing need be."""
    proof = by_signs(claim(Ge, B(n + 1, n, t) * Integral(x, (x, 0, n)), 0, {t: UNIT}), Budget(5))
    assert proof.status == "PROVED"
    assert "it may have any sign" in [step.reason for step in proof.steps]


def test_sums_over_other_ranges_are_not_the_same_at_the_peak():
    """The limits (k, 0, j) and (r, 0, j) cannot be subtracted: the sides are not alike, and that is all."""
    one, other = Sum(j, (k, 0, j)), Sum(j, (r, 0, j))
    assert by_signs(claim(Le, B(i, n, t) * one, B(i, n, i / n) * other, FROM_1 | WITHIN), Budget(5)) is None
    assert by_signs(claim(Le, B(i, n, t) * one, B(i, n, i / n) * one, FROM_1 | WITHIN), Budget(5)).method == "peak"


def test_what_is_too_large_to_factor_or_cancel_is_left_alone():
    """SymPy cannot be interrupted while it factors or cancels: without a bound each of these takes minutes."""
    large = (t - 1) ** 400 + (t + 1) ** 300
    peak = claim(Le, B(i, n, t) * large, B(i, n, i / n) * 3**300, FROM_1 | WITHIN)
    growth = claim(Ge, factorial(n) * (n + t) ** 400, t**40 / 1000, {t: UNIT})
    step = claim(Ge, 2**n * ((n + 1) ** 120 + 1), n, {n: (1, oo)})
    for each in (peak, growth, step):
        with suppress(OutOfTime):
            assert by_signs(each, Budget(1)) is None


def test_an_equation_is_left_to_others():
    assert by_signs(statement(ALL, 1), Budget(5)) is None


def test_ranges_that_are_empty_prove_nothing():
    assert by_signs(claim(Ge, B(i, n, t), 2, {i: (n + 1, n), t: UNIT}), Budget(5)) is None


LETTERS = Region(frozenset({i, n}), (i, n - i), {t: UNIT, u: OPEN})
EXPRESSIONS = [
    *(t - Rational(share, 4) for share in range(-1, 6)),
    *(u - Rational(share, 4) for share in range(-1, 6)),
    t**2 - t + QUARTER, t**2 - t + HALF, 2 * t**2 - 1, t**2 - 2,
    t**3 - t, u**3 - u, (2 * t - 1) ** 3, (t - 1) * (t - 2),
    i - n, i - n - 1, n - i + 1, i * (n - i), i**2 - n**2 - 1,
    i - n / 2, n * t - i, n * t - n, n * u - n - 1, t - u, t * u - 1,
    (i - n * t) ** 2, t * u * (1 - t), t + u, t - u - 1, u - t - 1,
    n * t**2 + i, 1 / (n + 1), i / (n + 1) - 1, t / (1 + i) - 1,
    B(i, n, t), B(i, n, u), B(i + 1, n, u), B(i - 1, n, t),
    B(n + 1, n, t), B(0, n, t), B(n, n, t), B(0, n, u), B(i, n, -u),
    B(i, n, 1 + t), B(i, n, 2 * t), B(2 * i, 2 * n, 3 * t), B(i, n, t * u), B(i, n, (t + u) / 2), B(n, i, t),
    t**i, u**i, (t - 1) ** n, (t - 1) ** (2 * n), (-u) ** (2 * i + 1),
    (2 * t - 1) ** i, S(-1) ** (n + i), (t - 1) ** (i + 1),
    binomial(n, i), binomial(n, i + 1), binomial(i, n + 1),
    factorial(n) - 1, 1 - factorial(n), binomial(n, i) * (t - u),
    Sum(B(k, n, t), (k, 0, i)), Sum(B(k, n, u), (k, 1, n)),
    Sum(t**k, (k, i, n)), Sum(k - n, (k, 0, n)), Sum(u**k, (k, n, i)),
    Sum(k * (k - 1), (k, 0, n)), Integral(x - 1, (x, 0, 1)),
    Integral(B(i, n, x), (x, 0, 1)), Integral(x - t, (x, 0, 1)),
    Integral(1 - x**2, (x, -1, 1)), Sum(-B(k, n, u) - 1, (k, i, n - 1)),
]  # fmt: skip
POINTS = [
    {i: a, n: b, t: Fraction(c, 4), u: Fraction(d, 5)}
    for b, c, d in product(range(4), range(5), (1, 2, 4))
    for a in range(b + 1)
]


@pytest.mark.parametrize("expr", EXPRESSIONS, ids=str)
def test_no_sign_is_left_out(expr):
    """Every sign that a value has on a grid is among those that are answered."""
    answer = signs(expr, LETTERS)
    for point in POINTS:
        try:
            value = evaluate(expr, point)
        except (Undefined, Unsupported):
            continue
        assert (value > 0) - (value < 0) in answer


EXACT = {
    t: {0, 1}, u: {1}, t - 1: {-1, 0}, u - 1: {-1}, 1 - t * u: {1}, t**2 - t + HALF: {1}, t**2 - t + QUARTER: {0, 1},
    i - n: {-1, 0}, i - n - 1: {-1}, B(i, n, u): {1}, B(i, n, t): {0, 1}, B(i + 1, n, u): {0, 1}, B(n + 1, n, t): {0},
    (i - n * t) ** 2 + 1: {1}, n**2 - i**2: {0, 1}, 2 * t**2 - 1: ANY, S(-1) ** n: {-1, 1}, Sum(u**k, (k, i, n)): {1},
    Sum(u**k, (k, 1, n)): {0, 1}, Integral(x - 1, (x, 0, 1)): {-1}, 1 / (n + 1) - 1: {-1, 0},
}  # fmt: skip


@pytest.mark.parametrize("expr", EXACT, ids=str)
def test_open_and_closed_ends_are_told_apart(expr):
    assert signs(expr, LETTERS) == EXACT[expr]


def test_many_terms_keep_to_the_budget():
    """A sum of hundreds of terms, each with a line of its own: what takes longer than the budget is given up."""
    a, b, c, d = symbols("a b c d", real=True)
    wide = claim(Ge, (1 + a + b + c + d) ** 9, 1 + a, {letter: Interval(0, oo) for letter in (a, b, c, d)})
    begin = perf_counter()
    with suppress(OutOfTime):
        by_signs(wide, Budget(1))
    assert perf_counter() - begin < 40  # only against hanging


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("(n+400)!*(n+399)! >= 400!*n!^2", "CHECKED"),  # numbers of hundreds of digits would have to be factored
        ("(n+400)!/(n+1)! + (n+399)!/(n+2)! >= 2", "CHECKED"),
        ("(n+30)!/n! + (n+20)!/(n+2)! >= 2", "PROVED"),
    ],
)
def test_factorials_too_far_apart_are_left_alone(text, status):
    assert judge(text).status == status
