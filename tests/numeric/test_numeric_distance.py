"""How far a control polygon is from its curve, point by point."""

from fractions import Fraction

import numpy as np
import pytest
from sympy import symbols

from bezteach.numeric import elevate, polygon_gap, subdivide


def test_the_middle_point_of_a_parabola_is_half_its_height_away():
    """p(1/2) of (0,0) (1,2) (2,0) is (1, 1)."""
    assert polygon_gap([(0, 0), (1, 2), (2, 0)]) == 1


def test_the_slide_s_cubic():
    """p(1/3) = (1, 5/3) and p(2/3) = (2, 2): b_1 is 4/3 above, b_2 is 1 below."""
    assert polygon_gap([(0, 0), (1, 3), (2, 1), (3, 3)]) == pytest.approx(4 / 3, rel=1e-15)


@pytest.mark.parametrize("points", [[5], [(1, 2)], [(0, 0), (7, 3)], [(0, 0), (1, 1), (2, 2), (3, 3)]])
def test_a_straight_evenly_divided_polygon_is_its_curve(points):
    assert polygon_gap(points) == 0


def test_each_halving_leaves_a_quarter_in_the_end_and_exactly_for_a_parabola():
    parabola = [(Fraction(0), 0), (1, 3), (2, 1)]
    gaps = [polygon_gap(subdivide(parabola, depth)).max() for depth in range(6)]
    assert [one / two for one, two in zip(gaps[1:], gaps, strict=False)] == [1 / 4] * 5
    cubic = np.array([(0, 0), (1, 3), (2, 1), (3, 3)])
    assert polygon_gap(subdivide(cubic, 9)).max() / polygon_gap(subdivide(cubic, 8)).max() == pytest.approx(
        1 / 4, abs=1e-3
    )


def test_elevation_brings_the_polygon_nearer_and_a_batch_gives_one_number_a_curve():
    cubic = np.array([(0.0, 0.0), (1.0, 3.0), (2.0, 1.0), (3.0, 3.0)])
    assert 0 < polygon_gap(elevate(cubic)) < polygon_gap(cubic)
    assert polygon_gap(np.stack([cubic, 2 * cubic])).tolist() == [polygon_gap(cubic), 2 * polygon_gap(cubic)]


def test_symbols_have_no_distance():
    with pytest.raises(ValueError, match="must hold no symbols"):
        polygon_gap(symbols("x0:3"))
