"""The pictures of elevation hold the polygons of the degrees they name, over the curve."""

import numpy as np
import pytest
from figure_words import assert_words_fit

from bezteach import figures
from bezteach.numeric import elevate

PARABOLA = ((0, 1), (1, 1), (0, 2))
CUBIC = ((0, 0), (1, 3), (2, 1), (3, 3))
ALL = {
    "elevated": lambda: figures.elevated(PARABOLA),
    "elevated cubic": lambda: figures.elevated(CUBIC),
    "raised": lambda: figures.raised(CUBIC),
    "raised thrice": lambda: figures.raised(CUBIC, (0, 2, 5)),
    "two_ways": lambda: figures.two_ways(CUBIC),
    "lowered": lambda: figures.lowered(CUBIC),
}
SAID = {
    "elevated": "(2/3, 1) divides its edge 2 : 1, (2/3, 4/3) divides its edge 1 : 2",
    "elevated cubic": "(3/4, 9/4) divides its edge 3 : 1",
    "raised": "degrees 4, 6, 12, 30",
    "raised thrice": "degrees 3, 5, 8",
    "two_ways": "3 to 96",
    "lowered": "(0, 9/20), (3/2, 9/4), (3, 51/20)",
}


def holds(axes, points):
    lines = [np.column_stack(line.get_data()) for line in axes.get_lines()]
    return any(line.shape == np.shape(points) and np.allclose(line, np.array(points, dtype=float)) for line in lines)


def test_both_polygons_and_the_names_of_all_points():
    (axes,) = ALL["elevated"]().axes
    assert holds(axes, PARABOLA) and holds(axes, [(0, 1), (2 / 3, 1), (2 / 3, 4 / 3), (0, 2)])
    names = {text.get_text() for text in axes.texts}
    assert names == {"$b_{0} = c_{0}$", "$b_{1}$", "$b_{2} = c_{3}$", "$c_{1}$  2 : 1", "$c_{2}$  1 : 2"}


def test_a_panel_a_degree():
    panels = ALL["raised thrice"]().axes
    for axes, r in zip(panels, (0, 2, 5), strict=False):
        assert holds(axes, elevate(CUBIC, r)) and axes.get_title() == f"degree {3 + r}"
    assert not panels[3].axison


def test_the_two_ways_start_at_one_place_and_part():
    (axes,) = ALL["two_ways"]().axes
    degree, halves = (line.get_ydata() for line in axes.get_lines())
    assert degree[:2] == pytest.approx([4 / 3, 3 / 8]) == halves[:2]
    assert degree[-1] / degree[-2] == pytest.approx(1 / 2, abs=0.02)
    assert halves[-1] / halves[-2] == pytest.approx(1 / 4, abs=0.01)


def test_the_nearest_curve_has_its_own_polygon():
    (axes,) = ALL["lowered"]().axes
    assert holds(axes, CUBIC) and holds(axes, [(0, 0.45), (1.5, 2.25), (3, 2.55)])


@pytest.mark.parametrize("name", ALL)
def test_it_says_in_words_what_it_shows(name):
    assert SAID[name] in ALL[name]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_labels_lie_inside_and_do_not_overlap(name):
    assert_words_fit(ALL[name]())
