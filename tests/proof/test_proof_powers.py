"""Powers of quotients, products and powers with letters in the exponents, and what stands in them unevaluated."""

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Add, Integer, Interval, Mul, Pow, Rational, oo, powsimp

from bezteach.bench import judge
from bezteach.proof import Undefined, evaluate, prove
from bezteach.symbolic import i, n, t, u


@pytest.mark.parametrize(
    ("text", "given", "twin"),
    [
        ("1/(1/t) = t", "t > 0", "1/(1/t) = 1/t"),
        ("(1/t)^0 = 1", "t > 0", "(1/t)^0 = 0"),
        ("1/(1-t)^(i-j) = (1-t)^(j-i)", "0 < t < 1", "1/(1-t)^(i-j) = (1-t)^(i-j)"),
        ("(t^(n-i))^2 = t^(2n-2i)", "0 <= i <= n", "(t^(n-i))^2 = t^(2n-i)"),
        ("(1/t^i)^(-2) = t^(2i)", "t > 0", "(1/t^i)^(-2) = t^(-2i)"),
        ("(t/(1-t))^(i-j) = t^(i-j)/(1-t)^(i-j)", "0 < t < 1", "(t/(1-t))^(i-j) = t^(i-j)/(1-t)^(j-i)"),
        ("C(n,i) (1-t)^n (t/(1-t))^i = B(i,n,t)", "0 <= i <= n, 0 <= t < 1", "C(n,i) (1-t)^n (t/(1-t))^i = B(n-i,n,t)"),
        ("(2t)^i/(1+t)^i = (2t/(1+t))^i", "t >= 0", "(2t)^i/(1+t)^i = 2t^i/(1+t)^i"),
        ("sum(C(n,i) (t/(1-t))^i, i, 0, n) = 1/(1-t)^n", "0 <= t < 1", "sum(C(n,i) (t/(1-t))^i, i, 0, n) = 1/(1-t)^i"),
        (
            "sum(B(i,n,t) (u/v)^i, i, 0, n) = (1 - t + t*u/v)^n",
            "v > 0",
            "sum(B(i,n,t) (u/v)^i, i, 0, n) = (1 - t + t*v/u)^n",
        ),
        ("(n/(n+1))^2 (n+1)^2 = n^2", "", "(n/(n+1))^2 (n+1)^2 = n"),
        ("(1/t)^n b_0 = t^(-n) b_0", "t > 0", "(1/t)^n b_0 = t^n b_0"),
    ],
)
def test_powers_are_taken_apart(text, given, twin):
    verdict = judge(text, given)
    assert verdict.status == "PROVED"
    verdict.replay()
    assert judge(twin, given).status == "REFUTED"


@pytest.mark.parametrize("text", ["(t^i)^n = (t^n)^i", "((1/t)^i)^n = t^(-i*n)"])
def test_an_exponent_that_is_not_linear_is_left_alone(text):
    assert judge(text, "t > 0").status in ("CHECKED", "UNDECIDED")


LEAVES = st.sampled_from([t, 1 - t, u, 1 + t, 2 * t, t - u, Integer(2), Integer(0), Rational(1, 2)])
EXPONENTS = st.sampled_from([i, n, n - i, i - n, -i, i - 1, *map(Integer, (-2, -1, 0, 2))])
RANGES = {t: Interval.open(0, 1), u: Interval.open(0, oo), i: (0, n), n: (0, oo)}
REALS = (("1/2", 2), ("1/3", "1/3"), ("3/4", 1))
PLACES = [(low, high, *reals) for high in range(4) for low in range(high + 1) for reals in REALS]


def unevaluated(tree):
    return st.one_of(
        st.builds(lambda x, e: Pow(x, e, evaluate=False), tree, EXPONENTS),
        st.builds(lambda x, y: Mul(x, y, evaluate=False), tree, tree),
        st.builds(lambda x, y: Add(x, y, evaluate=False), tree, tree),
    )


@settings(max_examples=60)
@given(st.recursive(LEAVES, unevaluated, max_leaves=5), st.booleans())
def test_what_is_proved_of_a_formula_as_it_is_written_holds(formula, wrong):
    """SymPy, told to go by no sign, gives the other side, or a wrong one."""
    try:
        other = powsimp(formula, force=True) * (2 if wrong else 1)
    except (IndexError, ZeroDivisionError):  # of powsimp, where 0**0 or 0 + 0 stands unevaluated
        assume(False)
    letters = formula.free_symbols | other.free_symbols
    ranges = {letter: found for letter, found in RANGES.items() if letter in letters}
    if i in letters:
        ranges[n] = RANGES[n]
    verdict = prove(formula, other, given=ranges, budget=3)
    if verdict.status != "PROVED":
        return
    verdict.replay()
    for place in PLACES:
        values = dict(zip((i, n, t, u), map(Rational, place), strict=True))
        assert value(formula, values) == value(other, values)


def value(formula, values):
    try:
        return evaluate(formula, values)
    except Undefined:
        return "none"
