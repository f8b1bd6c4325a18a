"""The picture of curve and hodograph holds both, in planes of their own, with the same arrows."""

from fractions import Fraction as F

import numpy as np
import pytest
from figure_words import assert_words_fit

from bezteach import figures

CURVE = ((0, 0), (1, 2), (3, 2), (3, 0))
CUSP = ((0, 0), (1, 1), (0, 1), (1, 0))
QUARTERS = tuple(F(k, 4) for k in range(5))
ALL = {"curve": lambda: figures.hodograph(CURVE), "cusp": lambda: figures.hodograph(CUSP, QUARTERS)}


def arrows(axes):
    """(start, tip) of each arrow of a panel."""
    return [(note.xyann, note.xy) for note in axes.texts if note.arrow_patch]


def labels(axes):
    return [note for note in axes.texts if note.get_text()]


def holds(axes, points):
    lines = [np.column_stack(line.get_data()) for line in axes.get_lines()]
    return any(line.shape == np.shape(points) and np.allclose(line, np.array(points, dtype=float)) for line in lines)


def test_both_polygons_are_drawn_in_their_planes():
    plane, vectors = ALL["curve"]().axes
    assert holds(plane, CURVE) and not holds(vectors, CURVE)
    assert holds(vectors, [(3, 6), (6, 0), (0, -6)])


def test_the_arrows_start_on_the_curve_with_an_nth_of_their_length_and_at_the_origin_with_all():
    plane, vectors = ALL["curve"]().axes
    assert np.allclose([start for start, _ in arrows(plane)], [(0, 0), (11 / 9, 4 / 3), (22 / 9, 4 / 3), (3, 0)])
    assert np.allclose([tip for _, tip in arrows(vectors)], [(3, 6), (4, 2), (3, -2), (0, -6)])
    for (start, tip), (origin, vector) in zip(arrows(plane), arrows(vectors), strict=True):
        assert np.allclose(origin, 0) and np.allclose(3 * np.subtract(tip, start), vector)


def test_where_the_velocity_is_zero_there_is_a_dot_and_no_arrow():
    plane, vectors = ALL["cusp"]().axes
    assert len(arrows(plane)) == len(arrows(vectors)) == 4
    assert holds(plane, [(1 / 2, 3 / 4)]) and holds(vectors, [(0, 0)])


@pytest.mark.parametrize("name", ALL)
def test_it_says_in_words_and_exactly_what_it_shows(name):
    assert {"curve": "(4, 2) at t = 1/3", "cusp": "(0, 0) at t = 1/2"}[name] in ALL[name]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_labels_lie_inside_and_do_not_overlap(name):
    assert_words_fit(ALL[name]())
