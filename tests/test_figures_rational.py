"""Pictures of rational curves: what is drawn lies where exact arithmetic says, and their words tell it."""

from fractions import Fraction as F

import numpy as np
import pytest
from figure_words import assert_words_fit

from bezteach import figures
from bezteach.figures.rational import OBLIQUE

QUARTER, ROUND = ((1, 0), (1, 1), (0, 1)), (1, 1, 2)
ARCH = ((0, 0), (2, 4), (4, 0))
SQUARE = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0))
LOADS, KNOTS = (1, 1, 2, 1, 1, 1, 2, 1, 1), (0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4)


def lines(figure):
    return [np.column_stack(line.get_data()) for line in figure.axes[0].get_lines()]


def named(figure, label):
    (line,) = [line for line in figure.axes[0].get_lines() if line.get_label() == label]
    return np.column_stack(line.get_data())


@pytest.mark.parametrize("weights", [ROUND, (1, -1, 2)])
def test_the_weighted_curve_is_on_the_circle_and_the_other_is_not(weights):
    figure = figures.quarter(QUARTER, weights)
    assert_words_fit(figure)
    curve = named(figure, f"weights {', '.join(map(str, weights))}")
    assert np.hypot(*curve.T) == pytest.approx(1) and np.allclose(curve[[0, -1]], [(1, 0), (0, 1)])
    assert np.hypot(*named(figure, "equal weights").T).max() > 1.05
    assert "lies on the unit circle" in figure.get_label()


def test_dots_stand_at_equal_steps_of_t():
    figure = figures.quarter(QUARTER, ROUND)
    dots, diamonds = lines(figure)[-2:]
    assert np.allclose(dots, [(1, 0), (15 / 17, 8 / 17), (3 / 5, 4 / 5), (7 / 25, 24 / 25), (0, 1)])
    assert np.allclose(diamonds[2], (3 / 4, 3 / 4))
    assert "(3/5, 4/5) at t = 1/2" in figure.get_label()
    assert "dotted the unit circle" in figures.quarter(QUARTER, (1, 3, 1)).get_label()


def test_each_ray_leads_from_the_origin_through_a_point_and_what_is_seen_of_it():
    figure = figures.projection(QUARTER, ROUND)
    assert_words_fit(figure)
    rays = [row for row in lines(figure) if len(row) == 2 and not row[0].any()]
    tips = np.array([(1, 0, 1), (1, 1, 1), (0, 2, 2), (3 / 4, 1, 5 / 4)]) @ OBLIQUE
    assert np.allclose([ray[1] for ray in rays], tips)
    seen = np.array([(0, 1, 1), (3 / 5, 4 / 5, 1)]) @ OBLIQUE
    for (x, y), (u, v) in zip(seen, tips[2:], strict=True):
        assert x * v == pytest.approx(y * u)
    assert "(3/4, 1, 5/4) at t = 1/2 is seen on the plane at (3/5, 4/5)" in figure.get_label()


def test_a_ray_goes_on_to_the_plane_if_its_point_is_below():
    figure = figures.projection(QUARTER, (1, F(1, 2), 1))
    tips = [row[1] for row in lines(figure) if len(row) == 2 and not row[0].any()]
    assert np.allclose(tips[1], np.array((1, 1, 1)) @ OBLIQUE)


def test_the_point_at_t_goes_straight_to_the_control_point():
    figure = figures.pulled(ARCH, (1, 1, 1), 1, (0, F(1, 3), 1, 3, 9))
    assert_words_fit(figure)
    way = next(row for row in lines(figure) if len(row) == 6)
    assert np.allclose(way, [(2, 0), (2, 1), (2, 2), (2, 3), (2, 18 / 5), (2, 4)])
    assert np.allclose(named(figure, "0")[:, 1], 0) and named(figure, "3")[48] == pytest.approx((2, 3))
    assert "(2, 1) for 1/3, (2, 2) for 1" in figure.get_label()
    with pytest.raises(ValueError, match="6 values of one weight: at most 5"):
        figures.pulled(ARCH, (1, 1, 1), 1, range(6))


def test_the_whole_circle_has_its_knots_at_the_quarters():
    figure = figures.nurbs(SQUARE, LOADS, KNOTS)
    assert_words_fit(figure)
    polygon, curve, joins = lines(figure)
    assert np.allclose(polygon, SQUARE) and np.hypot(*curve.T) == pytest.approx(1)
    assert np.allclose(joins, [(1, 0), (0, 1), (-1, 0), (0, -1)])
    assert "degree 2" in figure.get_label() and "meet at (1, 0), (0, 1), (-1, 0), (0, -1)" in figure.get_label()
