"""Pictures of the shape of a curve: they hold what they are said to hold, and say it in words."""

from fractions import Fraction as F

import numpy as np
import pytest
from figure_words import assert_words_fit

from bezteach import figures

EVEN = [(0, 0), (2, 1), (4, 2), (6, 3)]
CROWDED = [(0, 0), (0, 0), (2, 1), (6, 3)]
ARCH = [(-9, 0), (-3, 6), (3, 6), (9, 0)]
ALL = {
    "beads": lambda: figures.beads({"equal steps": EVEN, "crowded": CROWDED}),
    "moved": lambda: figures.moved(ARCH, 1, (3, 6)),
    "heights": lambda: figures.heights({f"w = {w}": [0, F(1, 4), w, F(1, 4), 0] for w in (F(-1, 4), F(1, 8), F(3, 4))}),
}


def holds(axes, points):
    lines = [np.column_stack(line.get_data()) for line in axes.get_lines()]
    return any(line.shape == np.shape(points) and np.allclose(line, np.array(points, dtype=float)) for line in lines)


def arrows(axes):
    return [(note.xyann, note.xy) for note in axes.texts if note.arrow_patch]


def test_beads_are_even_where_the_control_points_are():
    even, crowded = ALL["beads"]().axes
    assert holds(even, [(6 * k / 8, 3 * k / 8) for k in range(9)])
    x = [6 * 3 * t * t * (1 - t) / 3 + 6 * t**3 for t in np.arange(9) / 8]
    assert holds(crowded, [(value, value / 2) for value in x])


def test_every_point_goes_the_same_way_and_as_far_as_the_weight_says():
    (axes,) = ALL["moved"]().axes
    control, *points = arrows(axes)
    assert np.allclose(control, ((-3, 6), (0, 12)))
    for t, (start, tip) in zip((1 / 10, 1 / 3, 3 / 5, 9 / 10), points, strict=True):
        assert np.allclose(np.subtract(tip, start), 3 * t * (1 - t) ** 2 * np.array([3, 6]))


def test_graphs_stand_over_their_polygons():
    first, second, third, empty = ALL["heights"]().axes
    for axes, w in ((first, -1 / 4), (second, 1 / 8), (third, 3 / 4)):
        assert holds(axes, [(0, 0), (1 / 4, 1 / 4), (1 / 2, w), (3 / 4, 1 / 4), (1, 0)])
    assert not empty.axison


@pytest.mark.parametrize(
    ("name", "words"),
    [("beads", "crowded: (3/2, 3/4)"), ("moved", "27/1000 at t = 9/10"), ("heights", "w = 1/8: 0, 1/4, 1/8, 1/4, 0")],
)
def test_it_says_in_words_and_exactly_what_it_shows(name, words):
    assert words in ALL[name]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_words_lie_inside_and_do_not_overlap(name):
    assert_words_fit(ALL[name]())
