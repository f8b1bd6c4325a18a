"""What a statement is, where its symbols range, and what is said of one that is none."""

from fractions import Fraction as F

import pytest
from sympy import (
    Add,
    And,
    Derivative,
    Eq,
    Function,
    Ge,
    Gt,
    I,
    Integral,
    Interval,
    Le,
    Lt,
    Matrix,
    Ne,
    Pow,
    Rational,
    S,
    Subs,
    Sum,
    Symbol,
    binomial,
    factorial,
    nan,
    oo,
    sin,
    symbols,
)

from bezteach.proof import INVALID, InvalidStatement, prove, statement
from bezteach.proof.ranges import Integers
from bezteach.symbolic import B, E, b, i, j, k, n, r, step, t, u

NATURAL = Integers(S(0), oo)
REAL = Interval(-oo, oo)
PART, BELOW = Symbol("e", even=True), Symbol("w", negative=True)
plain_n, plain_i, plain_t, plain_x = symbols("n i t x")


def test_two_sides_or_a_relation():
    sides = (B(i, n, t), B(n - i, n, 1 - t))
    assert statement(*sides)[:3] == (sides[0], "=", sides[1])
    assert statement(Eq(*sides, evaluate=False)) == statement(*sides)
    for relation, sign in ((Ge, ">="), (Gt, ">"), (Le, "<="), (Lt, "<")):
        assert statement(relation(*sides, evaluate=False)).relation == sign
    assert statement(t, 0).rhs == 0
    assert statement(t, F(1, 3)).rhs == Rational(1, 3)


def test_integers_are_natural_and_reals_all_real_unless_it_is_given():
    assert statement(B(i, n, t), 0).ranges == {n: NATURAL, i: NATURAL, t: REAL}
    given = {n: (1, oo), i: (0, n), t: Interval.open(0, 1)}
    assert statement(B(i, n, t), 0, given).ranges == {n: Integers(S(1), oo), i: Integers(S(0), n), t: given[t]}
    assert statement(t, 0, {t: (0, 1)}).ranges == {t: Interval(0, 1)}


def test_what_is_assumed_of_a_symbol_narrows_its_range():
    p, q = Symbol("p", integer=True, positive=True), Symbol("q", positive=True)
    assert statement(p, q).ranges == {p: Integers(S(1), oo), q: Interval.open(0, oo)}


def test_the_walk_begins_with_n_and_no_symbol_comes_before_those_its_range_needs():
    expr = B(i, n, t) + B(j, k, u) + b[r]
    assert list(statement(expr, 0).ranges) == [n, i, j, k, r, t, u]
    assert list(statement(expr, 0, {i: (j, k), j: (0, n), t: Interval(0, u)}).ranges) == [n, k, r, j, i, u, t]


@pytest.mark.parametrize(
    "expr",
    [
        B(plain_n, 3, t),
        B(0, plain_n, t),
        b[plain_n - 1],
        t**plain_n,
        t ** (2 * plain_n - 1),
        binomial(3, plain_n),
        factorial(plain_n + 1),
        Sum(k, (k, 0, plain_n)),
        Derivative(t**3, (t, plain_n)),
        E**plain_n,
        t ** (1 / plain_n),
    ],
)
def test_a_symbol_without_assumptions_is_an_integer_where_a_whole_number_must_stand(expr):
    assert statement(expr, 0).ranges[plain_n] == NATURAL


@pytest.mark.parametrize(
    "expr", [B(2, 3, plain_x), plain_x**2, 1 / plain_x, b[0] * plain_x, Derivative(plain_x, plain_x)]
)
def test_a_symbol_without_assumptions_is_real_elsewhere(expr):
    assert statement(expr, 0).ranges[plain_x] == REAL


def test_one_use_as_a_degree_decides_for_the_whole_statement():
    assert statement(plain_i / plain_n, Sum(k, (k, plain_i, plain_n))).ranges == {plain_n: NATURAL, plain_i: NATURAL}


def test_the_symbols_of_a_range_belong_to_the_statement():
    assert statement(b[i], 0, {i: (0, n)}).ranges == {n: NATURAL, i: Integers(S(0), n)}


def test_neither_the_operator_nor_the_name_of_the_points_nor_a_bound_index_is_a_symbol_of_the_statement():
    assert statement(Sum(E**i * b[0], (i, 0, 3)), Integral(t, (t, 0, 1))).ranges == {}


@pytest.mark.parametrize(
    ("sides", "given", "what"),
    [
        ((S.true,), None, "already made it True"),
        ((False,), None, "already made it False"),
        ((Ne(t, 1),), None, "not a statement"),
        ((And(t > 0, t < 1),), None, "not a statement"),
        ((t,), None, "not a statement"),
        (("t = t",), None, "not a statement"),
        (("t", t), None, "not an expression"),
        ((Matrix([1]), Matrix([1])), None, "not an expression"),
        ((t, 0.5), None, "not an expression"),
        ((t / 2.0, 1), None, "float"),
        ((sin(t), t), None, "sin"),
        ((Function("p")(t), t), None, r"p\(t\)"),
        ((Symbol("z", complex=True, real=False), 1), None, "declared not real"),
        ((Symbol("q", commutative=False), 1), None, "noncommutative"),
        ((B(t, 3, t), 0), None, "t stands where a whole number must stand"),
        ((t**u, 0), None, "u stands where a whole number must stand"),
        ((B(0, Symbol("m", even=True), t), 0), None, "even"),
        ((Symbol("s", real=True, nonzero=True), 0), None, "nonzero"),
        ((Symbol("s", real=True, integer=False), 0), None, "declared not an integer"),
        ((Symbol("s", rational=True), 0), None, "rational"),
        ((Symbol("s", infinite=True), 0), None, "infinite"),
        ((Subs(t**PART, PART, 2), 0), None, "declared even"),
        ((B(i, n, t), B(plain_i, n, t)), None, "two different symbols are called i"),
        ((Sum(b[plain_i], (i, 0, 2)), 0), None, "two different symbols are called i"),
        ((Symbol("E", real=True), 0), None, "a symbol is called E"),
        ((Symbol("u + 1", real=True), 0), None, r"a symbol is called 'u \+ 1', which is no name"),
        ((b[n], 0), {n: (0, Add(oo, -oo, evaluate=False))}, "which is no real number"),
        ((t, t), {u: (0, 1)}, "given for u, which does not occur"),
        ((Sum(B(i, n, t), (i, 0, n)), 1), {i: (0, n)}, "given for i, which does not occur, except as the variable"),
        ((b[n], 0), {plain_n: (0, 1)}, "two different symbols are called n"),
        ((t, t), {"t": (0, 1)}, "not a symbol"),
        ((t, t), [t], "not a dict"),
        ((t, t), {t: 3}, r"not \(low, high\)"),
        ((b[n], 0), {n: (3, 2)}, "range of n is empty"),
        ((b[n], 0), {n: (Rational(1, 3), Rational(1, 2))}, "range of n is empty"),
        ((t, t), {t: Interval.open(1, 1)}, "range of t is empty"),
        ((b[n], 0), {n: (oo, oo)}, "range of n is empty"),
        ((b[n] - b[i], 0), {n: (0, i), i: (0, n)}, "in a circle"),
        ((b[n], 0), {n: (0, n)}, "in a circle"),
        ((b[n], 0), {n: (-1, 3)}, "beyond what is assumed"),
        ((Symbol("q", positive=True), 0), {Symbol("q", positive=True): Interval(0, 1)}, "beyond what is assumed"),
        ((BELOW, 0), {BELOW: Interval(-1, 0)}, "beyond what is assumed"),
        ((b[n], 0), {n: (nan, oo)}, "ends at nan, which is no real number"),
        ((b[n], 0), {n: (0, I)}, "ends at I, which is no real number"),
        ((b[n], 0), {n: (0, E)}, "ends at E, which is no real number"),
        ((t, t), {t: Interval(0, b[0])}, r"ends at b\[0\], which is no real number"),
        ((n * t, 0), {n: (0, B(0, 3, t))}, "range of n, an integer, has an end with t, which is real"),
        ((b[n], 0), {n: Interval(0, 1)}, r"give its range as \(low, high\)"),
        ((b[n], 0), {n: (0, 2.5)}, "not an expression"),
        ((Integral(t, t), 0), None, "no limits"),
        ((Sum(k, (k, 0, Rational(1, 2))), 0), None, "limit 1/2, which is not an integer"),
        ((Sum(k, (k, 0, t)), 0), None, "t stands where"),
        ((Integral(n, (n, 0, 1)), 0), None, "n is declared integer"),
        ((Derivative(b[n] * n, n), 0), None, "differentiates by n, which is an integer"),
        ((Ge(E, 1),), None, ">= between operators or points"),
        ((Lt(b[0], b[1]),), None, "< between operators or points"),
        ((step(t) ** n, Sum(B(i, n, t) * b[i], (i, 0, n))), None, "operator on one side and points on the other"),
        ((E * b[0] + E, b[1] + E), None, "an operator and a point cannot be added"),
    ],
)
def test_what_is_no_statement_says_why(sides, given, what):
    with pytest.raises(InvalidStatement, match=what):
        statement(*sides, given=given)
    verdict = prove(*sides, given=given)
    assert verdict.status == INVALID and verdict.note and verdict.counterexample is None


def test_an_expression_too_deep_to_follow_is_no_statement():
    expr = t
    for _ in range(130):
        expr = Pow(Add(1, expr, evaluate=False), -1, evaluate=False)
    assert "nested" in prove(expr, 0).note


def test_a_statement_shows_itself_as_the_course_writes_it():
    claim = statement(Ge(t * B(i, n, t), 0, evaluate=False))
    assert repr(claim) == "t*B(i, n, t) >= 0"
    assert claim.latex() == r"t B_{i,n}(t) \ge 0"
    assert claim._repr_latex_() == r"$\displaystyle t B_{i,n}(t) \ge 0$"
