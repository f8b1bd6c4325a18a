"""Pictures of B-splines: what they draw is what the numbers are, and they say it in words."""

from fractions import Fraction as F

import numpy as np
import pytest
from figure_words import assert_words_fit
from scipy.interpolate import BSpline
from scipy.spatial import ConvexHull

from bezteach import figures
from bezteach.figures.spline_functions import LIGHT
from bezteach.numeric import bspline

POINTS = ((0, 0), (0, 4), (4, 6), (8, 2), (12, 4), (12, 0))
KNOTS = (0, 0, 0, 1, 2, 3, 4, 4, 4)
UNIFORM = tuple(range(6))
DATA = ((0, 0), (2, 5), (6, 6), (8, -1), (12, 0), (14, 5), (18, 6), (20, 1), (24, 2))
ALL = {
    "clamped basis": lambda: figures.spline_basis(KNOTS, 2),
    "uniform basis": lambda: figures.spline_basis(UNIFORM, 2),
    "recursion": lambda: figures.recursion((0, 1, 2, 3)),
    "spans": lambda: figures.spans(POINTS, KNOTS, 4),
    "knot vectors": lambda: figures.knot_vectors(POINTS, {"uniform": tuple(range(9)), "clamped": KNOTS}),
    "inserted": lambda: figures.inserted(POINTS, KNOTS, F(3, 2)),
    "ways": lambda: figures.ways(DATA, 3, (8, 4)),
}


def drawn(axes):
    """The vertices of every line of a panel."""
    return [np.column_stack(line.get_data()) for line in axes.get_lines()]


def thick(axes):
    return [line for line in axes.get_lines() if line.get_linewidth() == 4.5]


@pytest.mark.parametrize("name", ALL)
def test_the_words_fit_and_there_is_a_label(name):
    figure = ALL[name]()
    assert_words_fit(figure)
    assert len(figure.get_label()) > 80 and "$" not in figure.get_label()


@pytest.mark.parametrize("knots", [KNOTS, UNIFORM])
def test_the_functions_are_scipy_s_and_their_sum_is_drawn(knots):
    (axes,) = figures.spline_basis(knots, 2).axes
    count = len(knots) - 3
    graphs = drawn(axes)[: count + 1]
    for i, graph in enumerate(graphs[:count]):
        inside = graph[(graph[:, 0] > knots[0]) & (graph[:, 0] < knots[-1])]
        other = BSpline.basis_element(np.array(knots[i : i + 4], float))(inside[:, 0])
        assert np.allclose(inside[:, 1], other)
        assert graph[[0, -1], 0].tolist() == [knots[i], knots[i + 3]]
    t, total = graphs[count].T
    domain = (t >= knots[2]) & (t <= knots[count])
    assert np.allclose(total[domain], 1)
    assert (total[~domain] < 1).all()


def test_the_domain_is_shaded_and_said():
    figure = figures.spline_basis(UNIFORM, 2)
    (patch,) = figure.axes[0].patches
    assert patch.get_x() == 2 and patch.get_width() == 1
    assert "domain from 2 to 3" in figure.get_label()


def test_the_recursion_is_a_triangle_whose_terms_add_up():
    panels = figures.recursion((0, 1, 2, 3)).axes
    titles = ["N_{0,0}", "N_{1,0}", "N_{2,0}", "N_{0,1}", "N_{1,1}", "N_{0,2}"]
    assert [axes.get_title() for axes in panels] == [f"${title}$" for title in titles]
    for axes in panels[3:]:
        left, right, whole = drawn(axes)
        t = np.array([0.25, 0.75, 1.25, 1.75, 2.25, 2.75])
        left, right = (np.interp(t, *term[~np.isnan(term[:, 1])].T, left=0, right=0) for term in (left, right))
        assert np.allclose(left + right, np.interp(t, *whole.T), atol=1e-3)


def test_a_function_of_degree_0_has_a_gap_where_it_jumps():
    first = drawn(figures.recursion((0, 1, 2)).axes[0])[0]
    assert np.isnan(first).any() and set(first[~np.isnan(first[:, 1]), 1]) == {0, 1}


@pytest.mark.parametrize(("degree", "chosen"), [(2, 4), (3, 4), (3, 5)])
def test_the_shaded_area_is_the_hull_of_the_spans_points(degree, chosen):
    figure = figures.spans(POINTS, bspline.clamped(6, degree), chosen)
    near = np.array(POINTS[chosen - degree : chosen + 1], dtype=float)
    (shaded,) = figure.axes[0].patches
    drawn_corners = set(map(tuple, shaded.get_xy()))
    assert drawn_corners == set(map(tuple, near[ConvexHull(near).vertices]))
    assert f"b_{chosen - degree} to b_{chosen}" in figure.get_label()


def test_the_spans_are_counted_in_words():
    assert "4 spans" in figures.spans(POINTS, KNOTS, 4).get_label()


def test_neighbouring_spans_differ_in_colour_and_dash():
    lines = [line for line in figures.spans(POINTS, KNOTS, 4).axes[0].get_lines() if len(line.get_xdata()) == 24]
    looks = [(line.get_color(), line.get_linestyle()) for line in lines]
    assert len(lines) == 4 and looks[0] == looks[2] and looks[1] == looks[3]
    assert looks[0][0] != looks[1][0] and looks[0][1] != looks[1][1]


def test_each_knot_vector_has_its_curve_and_its_stacks():
    figure = ALL["knot vectors"]()
    above, _, under, other = figure.axes
    assert (above.get_title(), under.get_xlabel()) == ("uniform", "t")
    triangles = [line for line in other.get_lines() if line.get_marker() == "^"]
    assert [len(line.get_xdata()) for line in triangles] == [3, 1, 1, 1, 3]
    assert other.patches[0].get_width() == 4 and under.patches[0].get_width() == 4
    assert "uniform: 0, 1, 2, 3, 4, 5, 6, 7, 8" in figure.get_label()


def test_inserting_keeps_the_curve_and_names_what_is_new():
    figure = ALL["inserted"]()
    curve = BSpline(np.array(KNOTS, float), np.array(POINTS, float), 2)
    after, knots = bspline.insert(POINTS, KNOTS, F(3, 2))
    assert np.allclose(curve(1.25), np.asarray(bspline.evaluate(after, knots, F(5, 4)), float))
    assert [note.get_text() for note in figure.axes[0].texts][-2:] == ["$c_{2}$", "$c_{3}$"]
    assert "c_2 = (3, 11/2), c_3 = (5, 5)" in figure.get_label()


def test_what_moves_is_thick_in_four_ways():
    figure = ALL["ways"]()
    assert [len(thick(axes)) for axes in figure.axes] == [1, 4, 8, 4]
    assert "B-spline: 4 of 6 pieces move" in figure.get_label()
    assert "natural spline: the whole moves" in figure.get_label()


def test_two_of_the_ways_alone():
    figure = figures.ways(POINTS, 2, (4, 9), ("one Bézier curve", "B-spline"), degree=2)
    assert [len(thick(axes)) for axes in figure.axes] == [1, 3]


def test_pictures_are_light_and_in_colours_of_the_house():
    assert LIGHT.startswith("#") and figures.spans(POINTS, KNOTS, 4).axes[0].patches[0].get_facecolor()[3] == 1
