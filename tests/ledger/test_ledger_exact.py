"""The exact tools of the arguments, against what is known and against other ways to compute it."""

from fractions import Fraction as F
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Poly
from sympy.abc import t

from bezteach.ledger import planar, signs
from bezteach.numeric import bernstein, evaluate

SMALL = st.integers(-3, 3)
POINTS = st.lists(st.tuples(SMALL, SMALL), min_size=1, max_size=5)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(POINTS, st.fractions(0, 1, max_denominator=7))
def test_points_and_values_along_the_curve_are_those_of_the_mirror(points, at):
    place = planar.curve_point(points, at)
    assert list(place) == list(evaluate(points, at))
    assert [signs.along_curve([p[axis] for p in points]).eval(at) for axis in (0, 1)] == list(place)
    assert planar.in_hull(points, place)
    assert [signs.bernstein(j, len(points) - 1, at) for j in range(len(points))] == list(bernstein(len(points) - 1, at))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(POINTS, st.tuples(SMALL, SMALL))
def test_a_point_is_in_the_hull_if_no_line_parts_it_from_the_points(points, point):
    """Integer points that are parted are parted in a direction across two of them, or along or across that."""
    places = [*points, point]
    ways = [(p[0] - q[0], p[1] - q[1]) for p in places for q in places] + [(1, 0), (0, 1)]
    normals = {turned for x, y in ways for turned in ((x, y), (-x, -y), (-y, x), (y, -x))}
    parted = any(
        all(a * x + b * y < a * point[0] + b * point[1] for x, y in points) for a, b in normals if (a, b) != (0, 0)
    )
    assert planar.in_hull(points, point) is not parted


@pytest.mark.parametrize(
    ("polynomial", "found"),
    [
        (t, []),
        (1 - t, []),
        (t * (1 - t) * (2 * t - 1), [1]),
        ((2 * t - 1) ** 2 * (3 * t - 1) * (3 * t - 5), [1, 2]),
        ((t**2 - 2) * (2 * t**2 - 1), [1]),
        (t**2 + 1, []),
        (7, []),
    ],
)
def test_roots_between_0_and_1_with_their_multiplicities(polynomial, found):
    assert sorted(signs.roots_inside(Poly(polynomial, t), 0, 1)) == found


def test_the_zero_polynomial_has_no_count_of_roots():
    with pytest.raises(ValueError, match="every number"):
        signs.roots_inside(Poly(0, t), 0, 1)


def test_minors_are_determinants():
    entries = [[1, 2, 3], [0, F(1, 2), 5], [7, -1, 4]]
    found = signs.minors(entries)
    assert len(found) == 20 and found[-1] == Matrix(entries).det() and set(entries[2]) <= set(found)


def test_sign_changes_pass_over_zeros():
    assert [signs.sign_changes(values) for values in ([], [0, 0], [1, 0, 1], [0, -1, 0, 2, -3])] == [0, 0, 0, 2]


def test_places_of_a_polygon_on_a_line():
    zigzag = [(0, -1), (1, 1), (2, -1), (2, 0)]
    assert planar.polygon_places(zigzag, (0, 1, 0)) == {(F(1, 2), 0), (F(3, 2), 0), (2, 0)}
    assert planar.polygon_places(zigzag, (0, 1, 5)) == set()
    with pytest.raises(ValueError, match="lies in the line"):
        planar.polygon_places(zigzag, (1, 0, 2))


def test_a_grid_of_values_has_no_more_roots_than_sign_changes():
    for values in product((-2, 1, 3), repeat=4):
        assert sum(signs.roots_inside(signs.along_curve(values), 0, 1)) <= signs.sign_changes(values)
