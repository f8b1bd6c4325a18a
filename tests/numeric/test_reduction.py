"""Down by a degree: exact where it can be, and else orthogonal to all of lower degree, by integrals of SymPy's."""

from fractions import Fraction as F
from math import comb

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import error, few_fractions, powers
from sympy import Poly, Rational, binomial, expand, integrate, symbols

from bezteach.numeric import elevate, evaluate, lower

DECK = [[0, 0], [1, 3], [2, 1], [3, 3]]

law = settings(deadline=None, max_examples=25, database=None)
numbers = few_fractions(-5, 5, 7)
curves = st.integers(1, 3).flatmap(
    lambda d: st.lists(st.lists(numbers, min_size=d, max_size=d), min_size=2, max_size=8)
)
s = symbols("s")


def polynomial(heights):
    """The definition, by SymPy."""
    n = len(heights) - 1
    return expand(sum(binomial(n, i) * s**i * (1 - s) ** (n - i) * sympy.sympify(h) for i, h in enumerate(heights)))


def nearest(heights):
    """The Bernstein coefficients of the nearest polynomial of lower degree: the normal equations, solved by SymPy."""
    n = len(heights) - 1
    unknown = symbols(f"c0:{n}")
    apart = polynomial(heights) - polynomial(unknown)
    equations = [integrate(expand(apart * s**k), (s, 0, 1)) for k in range(n)]
    (solution,) = sympy.linsolve(equations, unknown)
    return [F(int(x.p), int(x.q)) for x in solution]


def test_written_out():
    assert lower([0, 2, 3, 3]).tolist() == [0, 3, 3]
    assert lower([0, 0, 1]).tolist() == [F(-1, 6), F(5, 6)]  # t - 1/6 is nearest to t^2
    assert lower([0, 0, 0, 1]).tolist() == [F(1, 20), F(-1, 4), F(19, 20)]
    assert lower(DECK).tolist() == [[0, F(9, 20)], [F(3, 2), F(9, 4)], [3, F(51, 20)]]
    assert lower([[0, 1], [F(2, 3), 1], [F(2, 3), F(4, 3)], [0, 2]]).tolist() == [[0, 1], [1, 1], [0, 2]]
    assert lower([3, 8]).tolist() == [F(11, 2)]


@pytest.mark.parametrize(
    "heights", [[1, 5], [0, 1, 0], [2, -1, 3, 5], [0, 3, -2, 1, 1], [1, 0, 0, 0, 0, 1, 7], [F(1, 3), 0, 2, F(-5, 7)]]
)
def test_the_normal_equations_say_the_same(heights):
    assert lower(heights).tolist() == nearest([Rational(x) for x in heights])


@law
@given(curves)
def test_it_undoes_elevation(points):
    assert lower(elevate(points)).tolist() == points
    assert lower(lower(elevate(points, 2))).tolist() == points


@law
@given(curves)
def test_what_is_lost_is_orthogonal_to_all_of_lower_degree(points):
    """Coefficient k of a power integrates against t^m to 1/(k + m + 1)."""
    n = len(points) - 1
    lost = powers((np.array(points, dtype=object) - elevate(lower(points))).tolist())
    for m in range(n):
        assert all(sum(row[c] * F(1, k + m + 1) for k, row in enumerate(lost)) == 0 for c in range(len(points[0])))
    assert lost[n] == powers(points)[n]


@law
@given(curves)
def test_what_is_lost_is_an_alternating_row_of_pascal_and_largest_at_the_ends(points):
    n = len(points) - 1
    top = np.array(powers(points)[n], dtype=object)
    lost = np.array(points, dtype=object) - elevate(lower(points))
    assert lost.tolist() == [((-1) ** (n - i) * comb(n, i) * top * F(1, comb(2 * n, n))).tolist() for i in range(n + 1)]
    ends, inside = abs(lost[0]), abs(evaluate(lost, [F(k, 12) for k in range(13)]))
    assert (ends == abs(lost[-1])).all() and (inside <= ends).all()


@law
@given(curves)
def test_it_commutes_with_running_backwards_and_with_affine_maps(points):
    assert lower(points[::-1]).tolist() == lower(points)[::-1].tolist()
    assert (lower(3 * np.array(points, dtype=object) + 5) == 3 * lower(points) + 5).all()


def test_one_large_case_exact_and_in_float64():
    points = [[F(i * i - 40 * i, 3), F((-1) ** i * i, 7)] for i in range(61)]
    assert lower(elevate(points)).tolist() == points
    exact = lower(points).tolist()
    floats = lower([[float(x) for x in row] for row in points])
    assert floats.dtype == float and error(floats, exact) < 60 * 1e-14


@pytest.mark.parametrize("n", [1, 2, 3, 7, 20, 50, 100])
def test_float64_is_close_to_fractions(n):
    points = np.random.default_rng(n).uniform(-1, 1, (n + 1, 2))
    exact = lower([[F(x) for x in row] for row in points.tolist()]).tolist()
    assert error(lower(points), exact) < 1e-14 * (n + 1)


def test_float64_of_a_degree_whose_binomials_are_beyond_it():
    points = np.random.default_rng(5).uniform(-1, 1, 2001)
    assert np.allclose(lower(elevate(points)), points, rtol=0, atol=1e-12)


def test_shapes_and_kinds():
    curve = np.array(DECK)
    assert lower([0, 3, 1, 3]).shape == (3,) and lower(curve).shape == (3, 2)
    batch = np.stack([curve, curve[::-1], 2 * curve])
    assert lower(batch).tolist() == [lower(one).tolist() for one in batch]
    assert lower(batch.astype(float)).shape == (3, 3, 2)
    assert lower(batch.astype(float)).dtype == float and lower(curve).dtype == object
    assert all(type(x) is F for x in lower(curve).ravel())
    whole = np.array([2**62, -(2**62), 2**62, 5])
    assert lower(whole).tolist() == lower([int(x) for x in whole]).tolist()


def test_the_points_given_stay_as_they_are():
    points = np.array(DECK, dtype=float)
    lower(points)[:] = 7
    assert (points == DECK).all()


@pytest.mark.parametrize("n", range(1, 7))
def test_on_symbols(n):
    heights = symbols(f"b0:{n + 1}")
    lost = polynomial(heights) - polynomial(lower(heights))
    for k in range(n):
        assert expand(integrate(expand(lost * s**k), (s, 0, 1))) == 0
    assert [expand(x) for x in lower(elevate(heights))] == list(heights)
    assert Poly(polynomial(lower(heights)), s).degree() == n - 1


@pytest.mark.parametrize(
    ("points", "problem"),
    [
        ([5], "one control point has degree 0"),
        ([[1, 2]], "one control point has degree 0"),
        ([], "control point b: empty"),
        ([[0, 0], [1, float("nan")]], "control point b_1 has coordinate nan"),
        ([[0, 0], [1]], "ragged"),
        ([0, None], "control point b_1"),
        (np.zeros((2, 2, 2, 2)), "4 axes"),
        ([1e308, -1e308, 1e308, -1e308], "too large for float64"),
    ],
)
def test_bad_points_are_named_in_one_line(points, problem):
    with pytest.raises(ValueError) as caught:
        lower(points)
    assert type(caught.value) is ValueError and problem in str(caught.value) and "\n" not in str(caught.value)
