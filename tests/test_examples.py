"""Each worked example, computed anew from the definitions with SymPy alone, and the sources' slips found again."""

from fractions import Fraction
from itertools import pairwise
from math import comb

import pytest
from sympy import Poly, Rational, diff, expand, roots, symbols

from bezteach.examples import EXAMPLES

t, w = symbols("t w")


def example(name):
    return EXAMPLES[name].given, EXAMPLES[name].answer


def sympified(value):
    return Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else value


def bernstein(n, i):
    return comb(n, i) * t**i * (1 - t) ** (n - i)


def coefficients(polynomial, length=0):
    found = tuple(Poly(polynomial, t).all_coeffs()[::-1])
    return found + (0,) * (length - len(found))


def curve(points):
    """The coordinates of a Bézier curve as polynomials in t."""
    n = len(points) - 1
    return [expand(sum(bernstein(n, i) * sympified(p[c]) for i, p in enumerate(points))) for c in range(len(points[0]))]


def triangle(points, at):
    levels = [tuple(tuple(map(Fraction, point)) for point in points)]
    while len(levels[-1]) > 1:
        between = [tuple((1 - at) * x + at * y for x, y in zip(p, q, strict=True)) for p, q in pairwise(levels[-1])]
        levels.append(tuple(between))
    return tuple(levels)


def control_points(coordinates, start, end):
    """Control points of the part of a cubic over [start, end] from its power coefficients: no triangle is used."""
    columns = []
    for polynomial in coordinates:
        part = polynomial.subs(t, (1 - t) * sympified(start) + t * sympified(end))
        powers = [Fraction(int(c.p), int(c.q)) for c in map(Rational, coefficients(part, 4))]
        columns.append([sum(Fraction(comb(j, k), comb(3, k)) * powers[k] for k in range(j + 1)) for j in range(4)])
    return tuple(zip(*columns, strict=True))


def leaves(value):
    return [leaf for part in value for leaf in leaves(part)] if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("name", EXAMPLES)
def test_data_are_exact_and_say_where_they_stand(name):
    item = EXAMPLES[name]
    assert item.source in ("deck", "games", "notes", "transcript")
    assert item.place and item.about and item.given
    for data in (item.given, item.printed, item.corrected):
        assert all(type(leaf) in (int, Fraction) or leaf in (None, "w") for leaf in leaves(tuple(data.values())))


def test_corrections_differ_from_what_is_printed():
    for item in EXAMPLES.values():
        assert item.corrected.keys() <= item.printed.keys()
        assert all(item.printed[name] != truth for name, truth in item.corrected.items())


@pytest.mark.parametrize(
    ("name", "degree"), [("deck/bernstein-cubic", 3), ("notes/matrix", 3), ("deck/quadratic-by-steps", 2)]
)
def test_bernstein_bases(name, degree):
    _, answer = example(name)
    assert answer["basis"] == tuple(coefficients(bernstein(degree, i), degree + 1) for i in range(degree + 1))


@pytest.mark.parametrize("name", ["games/low-degrees", "transcript/low-degrees"])
def test_bases_of_low_degree(name):
    given, answer = example(name)
    expected = [[coefficients(bernstein(n, i), n + 1) for i in range(n + 1)] for n in given["degrees"]]
    assert answer["bases"] == tuple(map(tuple, expected))


def test_matrices_hold_the_basis_in_their_columns():
    rows = tuple(zip(*[coefficients(bernstein(3, i), 4) for i in range(4)], strict=True))
    assert example("deck/bernstein-cubic")[1]["matrix"] == rows
    assert example("notes/matrix")[1]["matrix_descending"] == rows[::-1]
    tangent = tuple(coefficients(diff(t**power, t)) for power in (3, 2, 1, 0))
    assert example("notes/matrix")[1]["tangent_row"] == tangent


def test_bezier_s_own_basis_is_the_tail_sums():
    _, answer = example("deck/bezier-basis")
    assert answer["basis"] == tuple(coefficients(expand(sum(bernstein(3, j) for j in range(i, 4)))) for i in range(4))


def test_recursion_of_the_quadratic_basis():
    _, answer = example("deck/recursion")
    for i, (stay, move) in enumerate(zip(answer["stay"], answer["move"], strict=True)):
        parts = [factor * bernstein(1, index) for factor, index in ((1 - t, stay), (t, move)) if index is not None]
        assert expand(sum(parts) - bernstein(2, i)) == 0


def quartic():
    given, answer = example("deck/quartic")
    return *curve([(px, w if py == "w" else py) for px, py in given["points"]]), answer


def test_the_quartic_with_its_height():
    x, y, answer = quartic()
    second = diff(y, t, 2)
    assert coefficients(x) == answer["x"]
    assert coefficients(y.subs(w, 0)) == answer["y_plain"]
    assert coefficients(diff(y, w)) == answer["y_beside_w"]
    assert coefficients(second.subs(w, 0)) == answer["second_plain"]
    assert coefficients(diff(second, w)) == answer["second_beside_w"]


def test_the_quartic_is_convex_on_exactly_the_printed_range():
    """Sign changes of the second derivative in (0, 1), by its exact roots: none in the range, two just outside it."""
    _, y, answer = quartic()
    low, high = map(sympified, answer["convex_for_w"])

    def changes_of_sign(height):
        second = Poly(diff(y, t, 2).subs(w, height), t)
        return sum(multiplicity % 2 for root, multiplicity in roots(second).items() if root.is_real and 0 < root < 1)

    tiny = Rational(1, 10**6)
    assert [changes_of_sign(height) for height in (low, tiny, Rational(1, 4), high - tiny, high)] == [0] * 5
    assert [changes_of_sign(height) for height in (low - tiny, Rational(-1), high + tiny, Rational(2))] == [2] * 4


def test_split_at_one_third():
    given, answer = example("deck/split")
    assert answer["triangle"] == triangle(given["points"], given["t"])
    coordinates = curve(given["points"])
    assert tuple(c.subs(t, Rational(1, 3)) for c in coordinates) == tuple(map(sympified, answer["point"]))
    assert answer["left"] == control_points(coordinates, 0, Fraction(1, 3))
    assert answer["right"] == control_points(coordinates, Fraction(1, 3), 1)


def test_part_from_a_quarter_to_three_quarters():
    given, answer = example("deck/segment")
    coordinates, start, end = curve(given["points"]), given["start"], given["end"]
    assert answer["first_triangle"] == triangle(given["points"], end)
    assert answer["front"] == control_points(coordinates, 0, end)
    assert answer["local_parameter"] == start / end
    assert answer["second_triangle"] == triangle(answer["front"], answer["local_parameter"])
    assert answer["part"] == control_points(coordinates, start, end)


def test_the_other_order_of_cuts_needs_another_local_parameter_than_the_deck_prints():
    given, answer = example("deck/segment")
    back = control_points(curve(given["points"]), given["start"], 1)

    def front_of(local):
        return tuple(level[0] for level in triangle(back, local))

    assert front_of(answer["scheme_2_local_parameter"]) == answer["part"]
    assert front_of(EXAMPLES["deck/segment"].printed["scheme_2_local_parameter"]) != answer["part"]


def test_derivatives_from_the_triangle():
    """The points of a level, weighted, times the factor: the first three derivatives of a cubic with any points."""
    _, answer = example("deck/derivatives")
    levels = [symbols("p0:4")]
    for _ in range(3):
        levels.append([(1 - t) * p + t * q for p, q in pairwise(levels[-1])])
    for r, (factor, weights) in enumerate(zip(answer["factors"], answer["weights"], strict=True), 1):
        formula = factor * sum(weight * point for weight, point in zip(weights, levels[3 - r], strict=True))
        assert expand(formula - diff(levels[3][0], t, r)) == 0


def test_parabola_in_both_bases():
    given, answer = example("games/parabola")
    powers = [sum(point[c] * t**k for k, point in enumerate(given["coefficients"])) for c in (0, 1)]
    assert curve(answer["points"]) == [expand(p) for p in powers]


def test_second_difference():
    given, answer = example("notes/second-difference")
    assert answer["weights"] == tuple((-1) ** k * comb(given["order"], k) for k in range(3))


def test_end_tangent_and_the_one_sixth_rule():
    """The end tangent is three edges long; a sixth of the neighbours' chord makes it half that chord."""
    _, answer = example("transcript/end-tangent")
    p = symbols("p0:4")
    tangent = diff(sum(bernstein(3, i) * p[i] for i in range(4)), t).subs(t, 0)
    assert expand(tangent - answer["factor"] * (p[1] - p[0])) == 0
    _, answer = example("transcript/one-sixth")
    before, here, after = symbols("d0 d1 d2")
    rule = {p[0]: here, p[1]: here + sympified(answer["factor"]) * (after - before)}
    assert expand(tangent.subs(rule) - (after - before) / 2) == 0


def test_knots():
    given, answer = example("transcript/uniform-knots")
    assert answer["knots"] == tuple(given["first"] + given["step"] * k for k in range(given["length"]))
    given, answer = example("transcript/clamped-knots")
    knots, degree, count = answer["knots"], given["degree"], given["count"]
    assert len(knots) == count + degree + 1
    assert knots == tuple(min(max(k - degree, 0), count - degree) for k in range(len(knots)))
    given, answer = example("transcript/bezier-knots")
    assert answer["knots"] == (0,) * (given["degree"] + 1) + (1,) * (given["degree"] + 1)
