"""Curves fitted to data by least squares, judged by definitions that share nothing with the package."""

from fractions import Fraction as F

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import few_fractions, value, weight

from bezteach.numeric import fit

law = settings(deadline=None, max_examples=30, database=None)
numbers = few_fractions(-4, 4, 3)
MEASURED = [[15, 1], [11, -1], [4, 4], [-1, 11], [1, 15]]


@st.composite
def tasks(draw, most=5):
    """Data points, a degree and parameters with as many different ones among them as the degree needs."""
    degree, d = draw(st.integers(0, most)), draw(st.integers(1, 3))
    inside = few_fractions(-1, 2, 8)
    t = draw(st.lists(inside, min_size=degree + 1, max_size=degree + 1, unique=True))
    t += draw(st.lists(st.one_of(inside, st.sampled_from(t)), max_size=5))
    data = draw(st.lists(st.lists(numbers, min_size=d, max_size=d), min_size=len(t), max_size=len(t)))
    return data, degree, draw(st.permutations(t))


def misses(points, data, parameters):
    """p(t_i) - D_i, row by row."""
    pairs = zip(data, parameters, strict=True)
    return [[x - y for x, y in zip(value(points, t), place, strict=True)] for place, t in pairs]


def squares(rows):
    return sum(x * x for row in rows for x in row)


# Written out


def test_a_line_through_three_heights():
    """0, 3, 3 at t = 0, 1/2, 1: the mean is 2, the slope (3 - 0)/1 = 3, so the line is 1/2 + 3t."""
    found = fit([0, 3, 3], 1)
    assert found.tolist() == [F(1, 2), F(7, 2)] and all(type(x) is F for x in found)


def test_a_parabola_out_of_five_measured_points():
    """16 (1-t)^2 and 16 t^2 at the quarters are 16, 9, 4, 1, 0; the errors -1, 2, 0, -2, 1 cancel in the equations."""
    assert fit(MEASURED, 2).tolist() == [[16, 0], [0, 0], [0, 16]]
    errors = [-1, 2, 0, -2, 1]
    assert [x - e for (x, _), e in zip(MEASURED, errors, strict=True)] == [16, 9, 4, 1, 0]
    assert all(sum(e * i**k for i, e in enumerate(errors)) == 0 for k in range(3))


def test_degree_0_is_the_mean_of_the_data_and_one_point_is_itself():
    assert fit([[1, 0], [2, 5], [6, 1]], 0).tolist() == [[3, 2]]
    assert fit([[7, 8]], 0).tolist() == [[7, 8]]


def test_other_parameters_give_another_curve():
    """A line through heights 0, 0, 4 at t = 0, 1/4, 1: sums 3, 5/4, 17/16 and 4, 4 give the slope 56/13."""
    assert fit([0, 0, 4], 1, [0, F(1, 4), 1]).tolist() == [F(-6, 13), F(50, 13)]
    assert fit([0, 0, 4], 1).tolist() == [F(-2, 3), F(10, 3)]


def test_a_parameter_may_come_twice():
    """Two measurements at t = 1 count as their mean, twice: with only two different parameters the line hits both."""
    assert fit([0, 1, 3], 1, [0, 1, 1]).tolist() == [0, 2]


# Against other ways to compute it


@law
@given(tasks())
def test_it_is_the_curve_of_the_normal_equations_in_powers_by_sympy(task):
    data, degree, parameters = task
    powers = sympy.Matrix(
        [[sympy.Rational(t.numerator, t.denominator) ** k for k in range(degree + 1)] for t in parameters]
    )
    places = sympy.Matrix([[sympy.Rational(x.numerator, x.denominator) for x in row] for row in data])
    coefficients = (powers.T * powers).LUsolve(powers.T * places)
    points = fit(data, degree, parameters).tolist()
    for t in (F(-1), F(0), F(1, 3), F(2)):
        ours = value(points, t)
        theirs = (
            sympy.Matrix([[sympy.Rational(t.numerator, t.denominator) ** k for k in range(degree + 1)]]) * coefficients
        )
        assert [F(int(x.p), int(x.q)) for x in theirs] == ours


@pytest.mark.parametrize("degree", [0, 1, 3, 6])
def test_floats_give_the_polynomial_of_numpy(degree):
    random = np.random.default_rng(7)
    t = np.sort(random.random(30))
    heights = np.sin(5 * t) + random.random(30)
    theirs = np.polyval(np.polyfit(t, heights, degree), t)
    ours = np.array([value([[x] for x in fit(heights, degree, t)], s)[0] for s in t])
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-12)


@pytest.mark.parametrize("degree", [1, 5, 10])
def test_floats_are_near_the_exact_ones(degree):
    data = [[F(k * k % 23, 1 + k % 4), k % 7] for k in range(40)]
    exactly = fit(data, degree)
    rounded = fit(np.array(data, float), degree)
    assert rounded.dtype == float and rounded.shape == (degree + 1, 2)
    np.testing.assert_allclose(rounded, exactly.astype(float), rtol=0, atol=1e-9)


def test_one_large_fit():
    """60 data points, degree 9: each miss times each function sums to 0 exactly."""
    data = [[F(k * k % 23, 1 + k % 4), k % 7] for k in range(60)]
    parameters = [F(k, 59) for k in range(60)]
    points = fit(data, 9).tolist()
    rest = misses(points, data, parameters)
    for i in range(10):
        column = [weight(9, i, t) for t in parameters]
        assert [sum(w * row[c] for w, row in zip(column, rest, strict=True)) for c in range(2)] == [0, 0]


# Laws


@law
@given(tasks(), st.data())
def test_data_of_a_curve_of_the_degree_give_it_back(task, draw):
    _, degree, parameters = task
    curve = draw.draw(st.lists(st.lists(numbers, min_size=2, max_size=2), min_size=degree + 1, max_size=degree + 1))
    assert fit([value(curve, t) for t in parameters], degree, parameters).tolist() == curve


@law
@given(tasks())
def test_what_is_left_over_is_orthogonal_to_the_basis(task):
    data, degree, parameters = task
    rest = misses(fit(data, degree, parameters).tolist(), data, parameters)
    for i in range(degree + 1):
        for c in range(len(data[0])):
            assert sum(weight(degree, i, t) * row[c] for t, row in zip(parameters, rest, strict=True)) == 0


@law
@given(tasks(), st.data())
def test_no_other_curve_is_nearer(task, draw):
    data, degree, parameters = task
    points = fit(data, degree, parameters).tolist()
    other = [[x + draw.draw(numbers) for x in row] for row in points]
    nearest, another = (squares(misses(some, data, parameters)) for some in (points, other))
    assert nearest <= another and (nearest < another or other == points)


@law
@given(tasks())
def test_as_many_data_as_control_points_are_all_passed(task):
    data, degree, parameters = task
    first = list(dict.fromkeys(parameters))[: degree + 1]
    chosen = [data[parameters.index(t)] for t in first]
    assert squares(misses(fit(chosen, degree, first).tolist(), chosen, first)) == 0


@law
@given(tasks())
def test_order_reversal_and_affine_maps_commute_with_the_fit(task):
    data, degree, parameters = task
    points = fit(data, degree, parameters)
    assert (fit(data[::-1], degree, parameters[::-1]) == points).all()
    assert (fit(data, degree, [1 - t for t in parameters]) == points[::-1]).all()
    assert (fit(np.array(data) * 3 + 2, degree, parameters) == points * 3 + 2).all()


# Shapes and numbers


def test_flat_data_and_batches():
    assert fit([15, 11, 4, -1, 1], 2).tolist() == [16, 0, 0]
    batch = fit([MEASURED, MEASURED[::-1]], 2)
    assert batch.shape == (2, 3, 2)
    assert batch[0].tolist() == fit(MEASURED, 2).tolist() == batch[1][::-1].tolist()
    floats = fit(np.array([MEASURED, MEASURED[::-1]], float), 2)
    np.testing.assert_allclose(floats, batch.astype(float), rtol=0, atol=1e-13)


def test_a_float_anywhere_makes_floats_and_nothing_given_is_changed():
    data, parameters = np.array(MEASURED), [0, 0.25, 0.5, 0.75, 1]
    assert fit(data, 2, parameters).dtype == float and fit([1, 2.5, 3], 1).dtype == float
    assert fit(data, 2).dtype == object and data.tolist() == MEASURED
    mine = np.array(MEASURED, float)
    fit(mine, 2)
    assert (mine == MEASURED).all()


def test_symbols_in_the_data_and_in_the_parameters():
    a, b, c, s = sympy.symbols("a b c s", real=True)
    assert [sympy.expand(x) for x in fit([a, b, c], 1)] == [5 * a / 6 + b / 3 - c / 6, -a / 6 + b / 3 + 5 * c / 6]
    middle = fit([a, b, c], 2, [0, s, 1])[1]
    assert sympy.simplify(middle - (b - (1 - s) ** 2 * a - s**2 * c) / (2 * s * (1 - s))) == 0


# Bad input


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([1, 2], 2), "data points: 2, and degree 2 needs at least 3"),
        (([1, 2, 3], 2, [0, 1, 1]), "different parameters: 2, and degree 2 needs at least 3"),
        (([1.0, 2, 3], 2, [0, 1, 1]), "different parameters: 2, and degree 2 needs at least 3"),
        (([1, 2, 3], 1, [0, 1]), "parameters of shape (2,): 3 numbers are needed, one for each data point"),
        (([1, 2, 3], 1, 5), "parameters of shape (): 3 numbers are needed, one for each data point"),
        (([1, 2, 3], 1, [0, None, 1]), "parameter t[1] is None: a finite real number is needed"),
        (([1, float("nan"), 3], 1), "data point D_1 has coordinate nan: a finite real number is needed"),
        (([[1, 2], [3]], 1), "data point D: ragged, the entry [1] has not the length of the first"),
        (([], 0), "data point D: empty, nested too deep, or a list that holds itself"),
        (([1, 2, 3], -1), "degree is -1: it must be between 0 and 100000000"),
        (([1, 2, 3], 1.5), "degree is 1.5: a whole number is needed"),
        (
            ([1.0, 2, 3], 1, [0, 1e-200, 2e-200]),
            "parameters too close together for float64: give data and parameters as int or Fraction",
        ),
        (([1e308, -1e308, 1e308], 2), "the result is too large for float64: give the numbers as int or Fraction"),
        (([1.0, 2, 3], 2, [0, 1e200, 1]), "the result is too large for float64: give the numbers as int or Fraction"),
    ],
)
def test_bad_input_is_named_in_one_line(arguments, message):
    with pytest.raises(ValueError) as caught:
        fit(*arguments)
    assert str(caught.value) == message


def test_two_formulas_for_one_parameter_are_found_out():
    s = sympy.Symbol("s", real=True)
    with pytest.raises(ValueError, match="different parameters: 2, and degree 2 needs at least 3"):
        fit([1, 2, 3], 2, [0, (s + 1) ** 2, s**2 + 2 * s + 1])
