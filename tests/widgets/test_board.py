"""The board without a browser: what it takes, what it refuses, what it paints and says."""

import re
from fractions import Fraction as F
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull
from sympy import Rational

from bezteach import numeric
from bezteach.numeric import sign_changes
from bezteach.numeric.hull import hull
from bezteach.widgets import Board
from bezteach.widgets.board import LAYERS, svg
from bezteach.widgets.board.counting import roots_inside
from bezteach.widgets.board.export import page
from bezteach.widgets.board.scene import end_circle, scene
from bezteach.widgets.board.state import State, exact, from_json, state_of, to_json

CUBIC = ((0, 0), (1, 3), (2, 1), (3, 3))
TWO_CUBICS = (*CUBIC, (4, 4), (6, 4), (7, 0))
COORDINATE = st.fractions(-(10**9), 10**9)
SVG = "{http://www.w3.org/2000/svg}"

# What it takes


@pytest.mark.parametrize(
    ("given", "number"),
    [(2, 2), (0.5, F(1, 2)), (1 / 3, F(1, 3)), ("-5/3", F(-5, 3)), (np.int64(4), 4), (np.float64(0.25), F(1, 4))],
)
def test_numbers_are_read_exactly(given, number):
    assert exact(given, "x") == number and isinstance(exact(given, "x"), F)


def test_a_number_of_sympy_is_read_exactly():
    assert exact(Rational(2, 7), "x") == F(2, 7)


@pytest.mark.parametrize(
    ("settings", "problem"),
    [
        ({"points": [(0, 0)]}, "a board shows 2 to 20 control points, and here are 1"),
        ({"points": [(k, 0) for k in range(60)]}, "2 to 20 control points, and here are 60"),
        ({"points": 5}, "the control points are 5, not a list"),
        ({"points": [(0, 0), (1, float("nan"))]}, "a coordinate of control point b_1 is nan"),
        ({"points": [(0, 0), (1, float("inf"))]}, "a coordinate of control point b_1 is inf"),
        ({"points": [(0, 0, 0), (1, 1, 1)]}, "control point b_0 has 3 coordinates, and the board is a plane"),
        ({"points": [(0, 0), "12"]}, "control point b_1 has 1 coordinates"),
        ({"points": [(0, 0), (1, "x")]}, "a coordinate of control point b_1 is 'x', not a number like 2, -5/3 or 0.25"),
        ({"points": [(0, 0), (1, True)]}, "a coordinate of control point b_1 is True, not a number"),
        ({"points": [(0, 0), (1, "1/0")]}, "a division by 0"),
        ({"points": [(0, 0), (1, "1" * 301)]}, "not a number like 2, -5/3 or 0.25"),
        ({"points": [(0, 0), (1, "1e10000000")]}, "not a number like"),
        ({"points": [(0, 0), (1, -(10**9) - 1)]}, "b_1 is larger than 1000000000: too far away"),
        ({"points": [(0, 0), (1, 0.1234567)]}, "0.1234567, which is no fraction with a denominator up to 1000"),
        ({"t": F(5, 4)}, "t = 5/4 lies outside"),
        ({"t": -0.5}, "t = -1/2 lies outside"),
        ({"a": 2}, "a = 2 lies outside"),
        ({"show": ("curve", "shadow")}, "there is no layer 'shadow' of a Bézier curve: there are hull, polygon"),
        ({"offer": "shadow"}, "there is no layer 'shadow'"),
        ({"line": ((1, 1), (1, 1))}, "a line goes through two different points"),
        ({"depth": 7}, "depth is 7, not a whole number from 0 to 6"),
        ({"raised": 1.5}, "raised is 1.5, not a whole number"),
        ({"end": True}, "end is True"),
        ({"level": 4}, "level is 4, not a whole number from 0 to 3"),
        ({"grid": 0}, "the grid's step is 0, and must be positive"),
    ],
)
def test_what_a_board_cannot_show_is_refused_in_one_line(settings, problem):
    with pytest.raises(ValueError) as refused:
        Board(**{"points": CUBIC} | settings)
    assert problem in str(refused.value) and "\n" not in str(refused.value)


def test_a_wrong_change_changes_nothing():
    board = Board(CUBIC)
    before = board.state
    for wrong in ({"t": 2}, {"points": [(0, 0)]}, {"t": F(1, 2), "depth": 99}):
        with pytest.raises(ValueError):
            board.change(**wrong)
    with pytest.raises(ValueError):
        board.points = [(0, 0, 0)] * 3
    assert board.state is before


@given(st.lists(st.tuples(COORDINATE, COORDINATE), min_size=2, max_size=20), st.fractions(0, 1))
def test_a_state_survives_the_way_to_the_browser_and_back(points, t):
    state = state_of(points, t=t, show=tuple(LAYERS))
    assert from_json(to_json(state)) == state


@pytest.mark.parametrize("x", [10**9, -(10**9), 0])
def test_the_line_beside_points_above_each_other_is_no_farther_away_than_they_may_be(x):
    (p, q) = state_of([(x, 0), (x, 2)]).line
    assert p == (x, 1) and q[1] == 1 and abs(q[0] - x) == 1 and abs(q[0]) <= 10**9


def test_what_no_browser_of_ours_sends_is_refused():
    sent = to_json(state_of(CUBIC))
    for wrong in (5, {}, sent | {"more": 1}, sent | {"t": "7/3"}, sent | {"points": [["0", "0"]]}):
        with pytest.raises(ValueError):
            from_json(wrong)


def test_layers_are_kept_in_the_order_in_which_they_are_painted():
    assert state_of(CUBIC, show=("halves", "polygon")).show == ("polygon", "halves")


# What it does


def test_points_and_t_are_read_and_set_exactly():
    board = Board(CUBIC, t=1 / 3, show=("curve", "levels"))
    assert board.t == F(1, 3) and board.points == CUBIC
    board.points = [(0, 0), (1, 1), (2, 0)]
    board.t = F(1, 2)
    assert board.state == State(((0, 0), (1, 1), (2, 0)), t=F(1, 2), line=board.state.line, show=("curve", "levels"))
    assert "(1, 1/2)" in board.text and "(1, 1/2)" in board.answer["html"]
    assert board.answer["state"] == to_json(board.state)


def test_the_grid_is_fine_enough_for_the_points():
    assert (
        Board([(-9, 0), (9, 0)]).grid == "1" and Board(CUBIC).grid == "1/4" and Board([(0, 0), (1, 1)]).grid == "1/12"
    )


def test_the_last_level_counts_as_all_of_them():
    board = Board(CUBIC, level=3)
    assert board.state.level is None
    board.change(level=1)
    board.points = [(0, 0), (1, 1)]
    assert board.state.level is None


def test_a_stored_notebook_shows_words_and_picture():
    board = Board(CUBIC, show=("polygon", "curve", "halves"))
    data, _ = board._repr_mimebundle_()
    assert data["text/plain"] == board.text == repr(board)
    stored = ElementTree.fromstring(data["text/html"].replace('">', '"/>'))
    assert stored.tag == "img" and stored.attrib["alt"] == board.text
    assert unquote(stored.attrib["src"]) == f"data:image/svg+xml,{board.svg}"
    tree = ElementTree.fromstring(board.svg)
    assert tree.attrib["aria-label"] == board.text and tree.attrib["role"] == "img"
    assert "application/vnd.jupyter.widget-view+json" in data


def test_a_page_of_its_own_is_small_and_alone():
    text = page(Board(CUBIC), "Cubic <1>")
    assert "Cubic &lt;1&gt;" in text and len(text.encode()) < 60_000
    assert not re.findall(r"https?://(?!www\.w3\.org/2000/svg)|<link|<img| src=|import\s", text)


def test_a_handout_has_the_same_words():
    board = Board(CUBIC, show=tuple(LAYERS))
    figure = board.figure()
    assert figure.get_label() == board.text and len(figure.axes) == 2
    assert len(Board(CUBIC).figure().axes) == 1


# What it paints


def marks(kind, **settings):
    return [mark for mark in scene(state_of(CUBIC, **settings)) if mark.kind == kind]


def test_every_layer_adds_marks():
    plain = scene(state_of(TWO_CUBICS, show=()))
    for layer in LAYERS:
        assert len(scene(state_of(TWO_CUBICS, show=layer))) > len(plain), layer


def test_levels_are_shown_as_far_as_asked():
    assert [len(m.points) for m in marks("line", show="levels")] == [3, 2]
    assert [len(m.points) for m in marks("line", show="levels", level=1)] == [3]
    assert marks("line", show="levels", level=0) == []


def test_halves_meet_on_the_curve():
    left, right = marks("curve", show="halves", t=F(1, 3))
    assert left.points[-1] == pytest.approx((1, 5 / 3)) == right.points[0]
    assert left.points[0] == (0, 0) and right.points[-1] == (3, 3)


def test_the_vector_of_the_hodograph_is_the_derivative():
    tip = next(m for m in marks("line", show="hodograph", t=F(1, 4)) if m.frame and m.points[0] == (0, 0)).points[1]
    assert tip == pytest.approx(tuple(map(float, numeric.derivative(CUBIC, F(1, 4)))))


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=12))
def test_the_hull_is_scipy_s(points):
    rows = np.array(points, dtype=float)
    if np.linalg.matrix_rank(rows - rows[0]) < 2:
        return
    assert set(hull(rows)) == {tuple(rows[i]) for i in ConvexHull(rows).vertices}


@pytest.mark.parametrize("points", [CUBIC, ((0, 0), (1, 1), (3, 0)), ((0, 0), (2, 1), (1, 3), (0, 2), (5, 5))])
def test_the_circle_has_the_curvature_of_the_end(points):
    for rows, t in ((points, 0), (points[::-1], 1)):
        centre, rim = end_circle(np.array(rows, dtype=float))
        kappa = numeric.curvature(points, float(t))
        assert np.hypot(*(centre - rim)) == pytest.approx(1 / abs(kappa))
        edge = np.array(points[1 - t] if t == 0 else points[-1], dtype=float)
        edge -= np.array(points[0] if t == 0 else points[-2], dtype=float)
        turn = edge[0] * (centre - rim)[1] - edge[1] * (centre - rim)[0]
        assert np.sign(turn) == np.sign(kappa)


@given(
    st.tuples(st.fractions(-9, 9), st.fractions(-9, 9)),
    st.tuples(st.fractions(-9, 9), st.fractions(-9, 9)),
    st.fractions(-3, 3),
    st.fractions(0, 1),
)
def test_exact_numbers_decide_what_is_straight_and_what_rests(p, q, s, t):
    """Three points on a line have no circle, and where the last level is one point there is no tangent."""
    between = tuple(a + s * (b - a) for a, b in zip(p, q, strict=True))
    straight = [mark.kind for mark in scene(state_of([p, q, between], show="circle"))]
    assert "circle" not in straight
    turned = tuple(2 * a - b if t else b for a, b in zip(p, q, strict=True))
    rest = scene(state_of([p, p, p, turned], t=0, show="tangents"))
    assert sum(mark.kind == "whole" for mark in rest) == (p != turned)


@pytest.mark.parametrize(
    ("heights", "squares"), [((1, 0, 0, -1), 1), ((0, 1, -1), 2), ((1, 0, 1), 1), ((0, 0, 0), 0), ((1, 2, 0), 1)]
)
def test_edges_on_the_line_are_met_once(heights, squares):
    points = [(F(x, 7), F(y, 3)) for x, y in enumerate(heights)]
    found = [m for m in scene(state_of(points, show="line", line=((0, 0), (F(1, 3), 0)))) if m.kind == "squares"]
    assert sum(len(mark.points) for mark in found) == squares


def test_three_points_on_a_line_have_no_circle():
    assert end_circle(np.array([(0, 0), (1, 1), (2, 2), (3, 0)], dtype=float)) is None
    assert end_circle(np.array([(0, 0), (1, 1)], dtype=float)) is None


def test_the_crossings_lie_on_line_and_curve():
    found = {m.style.fill: m.points for m in marks("dots", show="line", line=((0, F(3, 2)), (3, F(3, 2))))}
    (at,) = found["first"]
    (t,) = [root.real for root in np.roots([9, -15, 9, -1.5]) if abs(root.imag) < 1e-9]  # y(t) = 9t^3 - 15t^2 + 9t
    assert at == pytest.approx((3 * t, 1.5), abs=1e-5)
    (crossed,) = marks("squares", show="line", line=((0, F(3, 2)), (3, F(3, 2))))
    assert np.allclose(sorted(crossed.points), [(0.5, 1.5), (1.75, 1.5), (2.25, 1.5)])


DEGENERATE = [
    ((1, 1),) * 4,
    ((0, 0), (1, 0), (2, 0)),
    ((0, 0), (0, 5)),
    ((0, 0), (0, 0), (1, 1)),
    ((2, 2), (1, 1), (2, 2)),
]


@pytest.mark.parametrize("points", [CUBIC, *DEGENERATE])
@pytest.mark.parametrize("t", [F(0), F(1, 24), F(1)])
def test_every_layer_is_painted_also_at_the_ends_and_for_degenerate_points(points, t):
    board = Board(points, t, tuple(LAYERS), a=t, b=t, depth=3, raised=3)
    tree = ElementTree.fromstring(board.svg)
    assert tree.attrib["aria-label"] == board.text
    assert "nan" not in board.svg and "inf" not in board.svg
    board.figure()


def test_the_picture_keeps_ratios_and_puts_up_upwards():
    dots = [
        (float(c.attrib["cx"]), float(c.attrib["cy"]))
        for c in ElementTree.fromstring(Board(CUBIC).svg).iter(f"{SVG}circle")
    ]
    (x0, y0), (x1, y1), (_, y2), (x3, _) = dots
    unit = (x3 - x0) / 3
    assert unit > 0
    assert x1 - x0 == pytest.approx(unit, abs=0.2)
    assert y0 - y1 == pytest.approx(3 * unit, abs=0.2)
    assert y0 - y2 == pytest.approx(unit, abs=0.2)


def test_a_graph_is_stretched_over_its_frame():
    board = Board([(0, 0), (F(1, 2), 100), (1, 0)], vertical=True, view=(0, 0, 1, 100))
    (_, low), (_, high), _ = [
        (float(c.attrib["cx"]), float(c.attrib["cy"])) for c in ElementTree.fromstring(board.svg).iter(f"{SVG}circle")
    ]
    assert low - high == pytest.approx(svg.STEEP * (svg.WIDTH - 2 * svg.MARGIN), abs=1)


@pytest.mark.parametrize("width", [300, 640, 1000])
def test_the_second_frame_stands_beside_the_first_or_under_it(width):
    height, (first, second) = svg.layout(width, (0, 0, 1, 1), True)
    assert (second[0] >= first[2]) if width >= svg.NARROW else (second[1] >= first[3] and second[2] == width)
    assert max(first[1] + first[3], second[1] + second[3]) == height


# What it counts


def test_zeros_do_not_change_a_sign():
    assert [sign_changes(row) for row in ([1, 0, 1], [1, 0, -1], [0, 0], [0, -1, 1, -1])] == [0, 1, 0, 2]


def test_roots_at_the_ends_are_not_inside():
    assert roots_inside([0, 1, 0]) == (0, 0)
    assert roots_inside([F(1, 9), F(-2, 9), F(4, 9)]) == (0, 1)  # (1/3 - t)^2
    assert roots_inside([F(-1, 2), F(1, 2)]) == (1, 0)


@given(st.lists(st.integers(-5, 5), min_size=2, max_size=7))
def test_a_polynomial_changes_its_sign_no_more_often_than_its_coefficients(row):
    found = roots_inside(row)
    assert found is None or (found[0] + 2 * found[1] <= sign_changes(row) and (sign_changes(row) - found[0]) % 2 == 0)
