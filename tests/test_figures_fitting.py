"""The pictures of the lesson on bases hold the curve and the numbers that they speak of; labels stay apart."""

from fractions import Fraction as F

import numpy as np
import pytest
from figure_words import assert_words_fit

from bezteach import figures
from bezteach.numeric import fit

PARABOLA = ((1, 0), (0, 0), (0, 1))
UNEVEN = ((0, 1), (1, 1), (0, 2))
SAMPLES = ((15, 1), (11, -1), (4, 4), (-1, 11), (1, 15))
ZIGZAG = (0, 1, 0, 1, 0, 1, 0)
ALL = {
    "two bases": lambda: figures.two_bases(PARABOLA),
    "clock": lambda: figures.clock(UNEVEN),
    "fitted": lambda: figures.fitted(SAMPLES, fit(SAMPLES, 2)),
    "fitted through all": lambda: figures.fitted(SAMPLES, fit(SAMPLES, 4)),
    "nudged": lambda: figures.nudged(ZIGZAG),
}
SAID = {
    "two bases": "powers as points, (1, 0), (-2, 0), (1, 1). Right with its control points, (1, 0), (0, 0), (0, 1)",
    "clock": "(3/8, 17/16) at t = 1/4, (15/32, 73/64) at t = 3/8, (1/2, 5/4) at t = 1/2",
    "fitted": "5 samples as crosses, and the curve of degree 2 with the control points (16, 0), (0, 0), (0, 16)",
    "fitted through all": "The largest distance of a sample from its point of the curve is 0.",
    "nudged": "1 percent: the graph moves by up to 1.2, most at t = 1.",
}


def lines(axes):
    return [np.column_stack(line.get_data()).astype(float) for line in axes.get_lines()]


def holds(axes, points):
    return any(line.shape == np.shape(points) and np.allclose(line, np.array(points, float)) for line in lines(axes))


@pytest.mark.parametrize("name", ALL)
def test_it_says_in_words_and_exactly_what_it_shows(name):
    assert SAID[name] in ALL[name]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_labels_lie_inside_and_do_not_overlap(name):
    assert_words_fit(ALL[name]())


def test_the_two_bases_stand_on_their_sides_with_the_same_curve():
    powers, control = ALL["two bases"]().axes
    assert holds(powers, [(1, 0), (-2, 0), (1, 1)]) and not holds(powers, PARABOLA)
    assert holds(control, PARABOLA) and not holds(control, [(1, 0), (-2, 0), (1, 1)])
    assert np.allclose(lines(powers)[1], lines(control)[1])


def test_the_clock_has_a_dot_at_each_step():
    (axes,) = ALL["clock"]().axes
    assert holds(axes, [(2 * t - 2 * t * t, 1 + t * t) for t in (F(k, 8) for k in range(9))])


def test_each_sample_is_joined_to_its_point_of_the_curve():
    (axes,) = ALL["fitted"]().axes
    assert holds(axes, SAMPLES)
    for sample, place in zip(SAMPLES, [(16, 0), (9, 1), (4, 4), (1, 9), (0, 16)], strict=True):
        assert holds(axes, [sample, place])


def test_the_samples_are_joined_at_their_own_parameters():
    (axes,) = figures.fitted([(0, 0), (2, 0), (4, 0)], [(0, 0), (4, 0)], [0, F(1, 4), 1]).axes
    assert holds(axes, [(2, 0), (1, 0)])


def test_a_changed_coefficient_moves_the_end_and_a_changed_height_almost_nothing():
    powers, heights = ALL["nudged"]().axes
    *changed, original = lines(powers)
    ends = sorted(line[-1, 1] for line in changed)
    assert np.allclose(ends, [-1.2, -0.32, -0.3, 0.06, 0.8, 0.96]) and np.isclose(original[-1, 1], 0)
    *changed, original = lines(heights)
    assert len(changed) == 7
    assert max(np.abs(line - original).max() for line in changed) == pytest.approx(1 / 100)
