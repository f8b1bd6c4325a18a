"""The exact evaluator: every convention of the project literally, and SymPy written out by hand as a second opinion."""

from fractions import Fraction as F

import pytest
from hypothesis import given, settings
from proof_trees import TREES, built, by_hand
from sympy import (
    Abs,
    Derivative,
    Eq,
    FallingFactorial,
    Function,
    I,
    IndexedBase,
    Integral,
    KroneckerDelta,
    Max,
    Min,
    Piecewise,
    Pow,
    Product,
    Rational,
    RisingFactorial,
    S,
    Subs,
    Sum,
    Symbol,
    binomial,
    ceiling,
    exp,
    expand,
    factorial,
    floor,
    oo,
    pi,
    sin,
    sqrt,
    symbols,
)
from sympy import E as EULER

from bezteach.proof import Budget, InvalidStatement, OutOfTime, Undefined, Unsupported, evaluate, evaluator
from bezteach.proof.exact.polynomial import Polynomial, to_sympy
from bezteach.symbolic import B, E, apply, b, i, j, k, n, step, t, u

x, y = IndexedBase("x"), IndexedBase("y")
m = Symbol("m", integer=True)
HALF = F(1, 2)


def written(expr, **values):
    """The value as SymPy, expanded; the names are those of the symbols."""
    names = {s.name: s for s in expr.free_symbols if isinstance(s, Symbol)}
    return expand(to_sympy(evaluate(expr, {names[name]: value for name, value in values.items()})))


@pytest.mark.parametrize(
    ("degree", "index", "value"),
    [(2, 0, F(4, 9)), (2, 1, F(4, 9)), (2, 2, F(1, 9)), (2, -1, 0), (2, 3, 0), (0, 0, 1), (0, 1, 0)],
)
def test_a_basis_function_is_0_outside_its_degree(degree, index, value):
    assert evaluate(B(i, n, t), {i: index, n: degree, t: F(1, 3)}) == value


def test_a_basis_function_at_the_ends_needs_0_to_the_0():
    assert [evaluate(B(i, n, t), {i: k, n: 2, t: 0}) for k in range(3)] == [1, 0, 0]
    assert [evaluate(B(i, n, t), {i: k, n: 2, t: 1}) for k in range(3)] == [0, 0, 1]


@pytest.mark.parametrize("index", [-1, 0, 1])
def test_a_basis_function_of_negative_degree_is_undefined(index):
    with pytest.raises(Undefined, match="B of degree -1"):
        evaluate(B(i, n, t), {i: index, n: -1, t: HALF})


@pytest.mark.parametrize(("upper", "lower", "value"), [(4, 2, 6), (4, 0, 1), (4, 5, 0), (4, -1, 0), (0, 0, 1)])
def test_a_binomial_is_0_outside_0_to_n(upper, lower, value):
    assert evaluate(binomial(n, k), {n: upper, k: lower}) == value


@pytest.mark.parametrize("lower", [-3, -1, 0, 1])
def test_a_binomial_of_a_negative_number_is_undefined(lower):
    with pytest.raises(Undefined, match=r"C\(-2, "):
        evaluate(binomial(m, k), {m: -2, k: lower})


def test_a_factorial():
    assert evaluate(factorial(n), {n: 5}) == 120
    with pytest.raises(Undefined, match=r"\(-1\)!"):
        evaluate(factorial(m), {m: -1})


def test_powers_with_0():
    assert evaluate(t**n, {t: 0, n: 0}) == 1
    assert evaluate(t**n, {t: 0, n: 3}) == 0
    with pytest.raises(Undefined, match="division by 0"):
        evaluate(t**m, {t: 0, m: -1})
    assert evaluate(t**m, {t: F(2, 3), m: -2}) == F(9, 4)


def test_division_by_0_is_undefined_even_of_0_and_even_times_0():
    for expr in (1 / t, t / (u * t), n / t, u * t**-2):
        with pytest.raises(Undefined):
            evaluate(expr, {t: 0, u: 0, n: 0})


def test_0_times_an_undefined_number_is_undefined_and_so_is_it_beside_what_is_too_large():
    with pytest.raises(Undefined):
        evaluate(n * B(i, n - 1, t), {n: 0, i: 0, t: HALF})
    with pytest.raises(Undefined):
        evaluate(sqrt(t) + 1 / u, {t: 2, u: 0})
    with pytest.raises(Undefined):
        evaluate(1 / u + sqrt(t), {t: 2, u: 0})


def test_an_empty_sum_is_0_and_an_empty_product_1_whatever_the_limits():
    """Where SymPy says Sum(k, (k, 5, 3)) = -4."""
    for low, high in ((1, 0), (5, 3), (0, -7)):
        assert evaluate(Sum(k, (k, i, m)), {i: low, m: high}) == 0
        assert evaluate(Product(k, (k, i, m)), {i: low, m: high}) == 1
    assert evaluate(Sum(1 / t, (k, 1, n)), {n: 0, t: 0}) == 0
    assert evaluate(Product(k, (k, 1, n)), {n: 5}) == 120


def test_sums_with_limits_in_each_other_the_last_limit_outermost():
    assert evaluate(Sum(i * j, (i, 0, j), (j, 0, n)), {n: 3}) == sum(p * q for q in range(4) for p in range(q + 1))
    assert evaluate(Sum(Sum(i * j, (i, j, n)), (j, 0, n)), {n: 3}) == sum(p * q for q in range(4) for p in range(q, 4))


def test_a_bound_index_hides_a_free_one_only_inside():
    assert evaluate(k * Sum(k, (k, 1, n)) + k, {n: 3, k: 10}) == 70
    assert evaluate(Sum(k * Sum(k, (k, 1, k)), (k, 1, 3)), {}) == 1 * 1 + 2 * 3 + 3 * 6


def test_points_are_letters_and_coordinates_may_be_multiplied():
    assert written(Sum(B(i, n, t) * b[i], (i, 0, n)), n=1, t=F(1, 3)) == Rational(2, 3) * b[0] + b[1] / 3
    assert written(x[i] * y[i + 1] - x[i + 1] * y[i], i=0) == x[0] * y[1] - x[1] * y[0]
    assert evaluate((b[k] - b[i]) * t, {k: 2, i: 2, t: HALF}) == 0
    assert written(b[i, j] + b[j, i], i=0, j=1) == b[0, 1] + b[1, 0]


def test_operators_are_laurent_polynomials_and_act_on_the_point_beside_them():
    assert written(step(t) ** n, n=2, t=HALF) == expand((1 + E) ** 2 / 4)
    assert written(E**m, m=-2) == E**-2
    assert written(E**m * b[i], m=-2, i=1) == b[-1]
    assert written((E - 1) ** n * b[k], n=2, k=3) == b[5] - 2 * b[4] + b[3]
    assert written(step(t) ** n * b[0], n=3, t=F(1, 3)) == expand(apply(step(Rational(1, 3)) ** 3))
    assert written(t * Derivative(E**n, E) * b[0], n=3, t=1) == 3 * b[2]
    assert written(Subs(Derivative(step(t) ** n, E), E, 1), n=3, t=F(1, 3)) == 1


@pytest.mark.parametrize(
    "expr", [E * x[0] * y[1], E + b[0], 1 / b[0], 1 / (1 + E), Abs(b[0]), t ** b[0], b[n / 2], E**t]
)
def test_what_an_operator_or_a_point_cannot_do_is_unsupported(expr):
    with pytest.raises(Unsupported):
        evaluate(expr, {symbol: HALF if symbol == t else 1 for symbol in (n, t)})


def test_derivatives_are_taken_of_polynomials_and_then_the_value_is_put_in():
    assert evaluate(Derivative(t**n, t), {n: 3, t: 2}) == 12
    assert evaluate(Derivative(t**n, (t, k)), {n: 3, t: 2, k: 2}) == 12
    assert evaluate(Derivative(t**n, (t, k)), {n: 3, t: 2, k: 0}) == 8
    assert evaluate(Derivative(t**n, (t, k)), {n: 3, t: 2, k: 4}) == 0
    assert evaluate(Derivative(t**2 * u**3, t, (u, 2)), {t: 5, u: 7}) == 2 * 5 * 6 * 7
    assert evaluate(Derivative(t * Derivative(t**3, t), t), {t: 2}) == 36
    assert evaluate(Subs(Derivative(B(i, n, t), t), t, 1), {i: 2, n: 2}) == 2
    assert evaluate(Subs(Subs(t - u, t, 1 - t), u, 3), {t: 5}) == -7
    assert written(Derivative(step(t) ** n * b[0], t), n=1, t=0) == b[1] - b[0]
    with pytest.raises(Undefined):
        evaluate(Derivative(t**3, (t, m)), {t: 1, m: -1})


@pytest.mark.parametrize("expr", [Subs(Subs(t, t, 0), t, 1), Subs(Subs(t * u, t, u), u, 3), Subs(t, (t, u), (u, t))])
def test_values_whose_order_matters_are_not_put_in(expr):
    """SymPy makes one Subs of two, the inner one first, and that is not to put in all values at once."""
    with pytest.raises(InvalidStatement, match="it matters which value is put in first"):
        evaluate(expr, {t: 1, u: 2})


def test_integrals_between_any_limits():
    assert evaluate(Integral(B(i, n, t), (t, 0, 1)), {i: 1, n: 3}) == F(1, 4)
    assert evaluate(Integral(t**n, (t, 1, 0)), {n: 1}) == -HALF
    assert evaluate(Integral(t * u, (t, 0, u), (u, 0, 1)), {}) == F(1, 8)
    assert evaluate(Derivative(Integral(t, (t, 0, u)), u), {u: 3}) == 3
    assert written(Integral(step(t) ** n, (t, 0, 1)), n=1) == (1 + E) / 2


def test_an_integral_or_derivative_of_what_is_no_polynomial_is_unsupported():
    for expr in (
        Integral(1 / t, (t, 1, 2)),
        Derivative(1 / (1 + t), t),
        Derivative(Abs(t), t),
        Integral(t, (t, 0, oo)),
    ):
        with pytest.raises(Unsupported):
            evaluate(expr, {t: 1})


def test_the_small_functions():
    at = {n: 3, t: F(-5, 2)}
    assert evaluate(FallingFactorial(t, n), at) == F(-5, 2) * F(-7, 2) * F(-9, 2)
    assert evaluate(RisingFactorial(t, n), at) == F(-5, 2) * F(-3, 2) * F(-1, 2)
    assert evaluate(FallingFactorial(n, k), {n: 3, k: 5}) == 0
    assert [evaluate(f(t), at) for f in (Abs, floor, ceiling)] == [F(5, 2), -3, -2]
    assert evaluate(Max(t, n) - Min(t, n), at) == F(11, 2)
    assert [evaluate(KroneckerDelta(n, k), {n: 1, k: value}) for value in (0, 1)] == [0, 1]


def test_piecewise_takes_the_first_case_that_holds_and_leaves_the_others_alone():
    cases = Piecewise((1, Eq(i, 0)), (1 / t, t > 0), (2, (t < -1) | Eq(n, 7)))
    assert evaluate(cases, {i: 0, t: 0, n: 0}) == 1
    assert evaluate(cases, {i: 1, t: 2, n: 0}) == HALF
    assert evaluate(cases, {i: 1, t: 0, n: 7}) == 2
    with pytest.raises(Undefined, match="none of the cases"):
        evaluate(cases, {i: 1, t: 0, n: 0})


def test_roots_only_where_they_are_rational():
    assert evaluate(sqrt(t), {t: F(4, 9)}) == F(2, 3)
    assert evaluate(Pow(t, Rational(-2, 3)), {t: F(8, 27)}) == F(9, 4)
    assert evaluate(sqrt(t), {t: 10**60}) == 10**30
    for value in (2, -4, 10**60 + 1):
        with pytest.raises(Unsupported, match="root"):
            evaluate(sqrt(t), {t: value})


@pytest.mark.parametrize(
    "expr",
    [
        t ** (10**n),
        factorial(10**n),
        binomial(10**n, 3),
        B(1, 10**n, t),
        Sum(k, (k, 0, 10**n)),
        Sum(k, (k, 0, oo)),
        (1 + E + E**-1) ** (10**n),
        Product(t**k + 7, (k, 0, 4000)),
        Derivative(t**4, (t, 10**n)),
        binomial(t, 2),
        B(t, 2, t),
    ],
)
def test_what_is_too_large_or_not_whole_is_unsupported_and_soon(expr):
    with pytest.raises(Unsupported):
        evaluate(expr, {n: 9, t: F(1, 3)}, Budget(20))


def test_the_budget_stops_loops_in_loops():
    many = Sum(Sum(Sum(i * j * k, (i, 0, 4000)), (j, 0, 4000)), (k, 0, 4000))
    with pytest.raises(OutOfTime):
        evaluate(many, {}, Budget(0.05))


@pytest.mark.parametrize(
    ("expr", "what"),
    [
        (sin(t), "sin"),
        (exp(t), "exp"),
        (Function("p")(t), "p"),
        (pi * t, "Pi"),
        (I * t, "ImaginaryUnit"),
        (EULER * t, "Euler's number"),
        (t * 0.5, "float"),
        (S.NaN, "NaN"),
        (Integral(t, t), "no limits"),
        (u, "u has no value"),
        (b, "IndexedBase"),
        (Derivative(b[0] ** 2, b[0]), "differentiates by b"),
        (Subs(t**2, 1 - t, 0), "puts a value in for 1 - t, which is no symbol"),
    ],
)
def test_what_the_evaluator_does_not_know_it_names(expr, what):
    with pytest.raises(InvalidStatement, match=what):
        evaluator(expr, (n, t))


def test_no_text_and_no_float_gets_in():
    for bad in ("n + 1", 0.5, True, None, [1]):
        with pytest.raises(InvalidStatement):
            evaluate(bad, {})
    with pytest.raises(TypeError):
        evaluate(t, {t: 0.5})


PLACES = {n: 3, i: 1, t: F(2, 3), u: F(-1, 2)}


@settings(max_examples=250, deadline=None, derandomize=True)
@given(TREES)
def test_random_trees_agree_with_sympy_written_out(node):
    at = {
        name: S(value) if isinstance(value, int) else Rational(*value.as_integer_ratio())
        for name, value in PLACES.items()
    }
    expr = built(node)
    value = evaluate(expr, {name: PLACES[name] for name in PLACES})
    assert expand(by_hand(node, at) - to_sympy(value)) == 0


def test_a_value_that_is_a_number_is_no_polynomial():
    assert not isinstance(evaluate((b[0] + 1) * 2 - 2 * b[i], {i: 0}), Polynomial)
    assert symbols("E") == E
