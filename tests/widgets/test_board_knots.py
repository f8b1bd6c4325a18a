"""A board with knots: what it takes, what it refuses, what it says and what it paints."""

from fractions import Fraction as F

import numpy as np
import pytest
from scipy.interpolate import BSpline

from bezteach.numeric import bspline
from bezteach.widgets import Board, explore_bspline
from bezteach.widgets.board.state import OF_KNOTS, from_json, state_of, to_json
from bezteach.widgets.board.words import blocks

POINTS = ((0, 0), (1, 3), (3, 4), (5, 1), (7, 3), (8, 0))
KNOTS = (0, 0, 0, 1, 2, 3, 4, 4, 4)  # the transcript's: degree 2


def said(name, points=POINTS, knots=KNOTS, t=F(3, 2)):
    """The rows of the block of this layer."""
    return blocks(state_of(points, knots=knots, t=t, show=[name]))[-1]


def test_the_start_is_the_middle_of_the_domain():
    board = Board(POINTS, knots=[0, 1, 2, 3, 4, 5, 6, 7, 8, 9])
    assert (board.t, board.state.show) == (F(9, 2), ("polygon", "spline"))
    assert board.knots == tuple(map(F, range(10)))
    assert explore_bspline(POINTS, KNOTS).t == 2


@pytest.mark.parametrize(
    ("settings", "rule"),
    [
        ({"knots": [0, 0, 0, 1, 2]}, "5 knots for 6 control points make degree -2, and a board shows degrees 1 to 5"),
        ({"knots": [*KNOTS, 4, 4, 4, 4]}, "13 knots for 6 control points make degree 6, and a board shows"),
        ({"knots": [0, 0, 0, 2, 1, 3, 4, 4, 4]}, "knot t_4 = 1 is below t_3 = 2: knots must not decrease"),
        ({"knots": [0, 0, 0, 1, 1, 1, 1, 2, 2]}, "knot 1 stands 4 times: at degree 2 it may stand at most 3 times"),
        ({"knots": [0, 0, 0, 1, 2, 3, 4, 4, "x"]}, "knot t_8 is 'x', not a number"),
        ({"knots": 5}, "the knots are 5, not a list"),
        ({"knots": KNOTS, "t": 5}, "t = 5 lies outside [0, 4]"),
        ({"knots": KNOTS, "show": ["curve"]}, "there is no layer 'curve' of a B-spline: there are hull, polygon, span"),
        ({"show": ["deboor"]}, "there is no layer 'deboor' of a Bézier curve: there are hull, polygon, curve"),
    ],
)
def test_what_is_wrong_is_named(settings, rule):
    with pytest.raises(ValueError) as caught:
        Board(POINTS, **settings)
    assert rule in str(caught.value)


def test_a_domain_of_one_point_is_refused():
    with pytest.raises(ValueError, match="domain"):
        Board([(0, 0), (1, 1)], knots=[0, 1, 1, 2])


def test_a_change_that_is_wrong_changes_nothing():
    board = explore_bspline(POINTS, KNOTS, 4)
    with pytest.raises(ValueError, match=r"t = 4 lies outside \[0, 3\]"):
        board.change(knots=(0, 0, 0, 1, 2, 2, 3, 3, 3))
    assert (board.knots, board.t) == (KNOTS, 4)
    board.change(knots=(0, 0, 0, 1, 2, 2, 3, 3, 3), t=3)
    assert board.state.knots[-1] == 3


def test_a_state_goes_to_the_browser_and_back():
    state = state_of(POINTS, knots=(0, 0, 0, F(1, 3), 2, 3, 4, 4, 4), show=OF_KNOTS)
    sent = to_json(state)
    assert sent["knots"][2:5] == ["0", "1/3", "2"]
    assert from_json(sent) == state
    assert to_json(state_of(POINTS))["knots"] is None


def test_the_knots_are_said_with_their_multiplicities():
    (block,) = [one for one in blocks(state_of(POINTS, knots=KNOTS)) if "Knots" in one.title]
    assert block.title == "Knots (节点), degree 2, domain [0, 4]"
    assert [cell for row in block.rows for cell in row] == ["0 (3 times)", "1", "2", "3", "4 (3 times)"]


def test_the_point_and_de_boor_s_triangle():
    assert said("spline").rows == (("(3, 7/2)",),)
    assert said("deboor").rows == (("(1, 3)",), ("(3, 4)", "(5/2, 15/4)"), ("(5, 1)", "(7/2, 13/4)", "(3, 7/2)"))


def test_the_functions_at_t_sum_to_one():
    assert said("functions").rows == (("N₁", "1/8"), ("N₂", "3/4"), ("N₃", "1/8"), ("sum", "1"))


@pytest.mark.parametrize(
    ("t", "title", "names"),
    [
        (F(3, 2), "t = 3/2 is in the span [1, 2], in the hull of", ("b₁", "b₂", "b₃")),
        (1, "t = 1 is in the span [1, 2], in the hull of", ("b₁", "b₂", "b₃")),  # a span begins at its knot
        (4, "t = 4 is in the span [3, 4], in the hull of", ("b₃", "b₄", "b₅")),  # but for the end of the domain
    ],
)
def test_the_span_of_t_and_its_points(t, title, names):
    assert said("span", t=t) == (title, (names,))


def test_a_single_knot_of_a_quadratic_keeps_the_tangent():
    assert said("breaks").rows[0] == ("t = 1", "once", "C1 promised", "p″ jumps by (0, 1)")


@pytest.mark.parametrize(
    ("points", "knots", "row"),
    [
        (POINTS, (0, 0, 0, 1, 1, 2, 3, 3, 3), ("t = 1", "2 times", "C0 promised", "a corner: p′ jumps by (0, -8)")),
        (  # the points on one line: a double knot, and no corner
            ((0, 0), (1, 1), (2, 2), (5, 5), (7, 3), (8, 0)),
            (0, 0, 0, 1, 1, 2, 3, 3, 3),
            ("t = 1", "2 times", "C0 promised", "p′ jumps by (4, 4)"),
        ),
        (POINTS, (0, 0, 0, 1, 1, 1, 2, 2, 2), ("t = 1", "3 times", "nothing promised", "p jumps by (2, -3)")),
    ],
)
def test_what_a_multiplicity_promises_and_what_the_curve_does(points, knots, row):
    assert said("breaks", points, knots, 0).rows[0] == row


def test_turning_back_is_a_corner():
    points = ((0, 0), (1, 0), (2, 0), (1, 0), (0, 0))
    rows = said("breaks", points, (0, 0, 0, 1, 1, 2, 2, 2), 0).rows
    assert rows == (("t = 1", "2 times", "C0 promised", "a corner: p′ jumps by (-4, 0)"),)


def test_an_inserted_knot_is_felt_by_nothing():
    points, knots = bspline.insert(POINTS, KNOTS, F(1, 2))
    row = said("breaks", points, tuple(knots)).rows[0]
    assert row == ("t = 1/2", "once", "C1 promised", "here all derivatives agree")


def test_one_span_has_no_joins():
    assert said("breaks", POINTS[:3], (0, 0, 0, 1, 1, 1), 1).rows == (("none: the curve is one span",),)


def test_the_curve_painted_is_scipy_s():
    board = explore_bspline(POINTS, KNOTS, show=["spline"])
    pieces = [mark.points for mark in board.marks if mark.kind == "curve"]
    curve = BSpline(np.array(KNOTS, float), np.array(POINTS, float), 2)
    assert len(pieces) == 4
    for k, (b0, b1, b2) in enumerate(np.array(pieces)):
        assert np.allclose([b0, (b0 + 2 * b1 + b2) / 4, b2], curve([k, k + 1 / 2, k + 1]))


def test_a_curve_that_jumps_has_two_points_there():
    board = Board(POINTS, knots=(0, 0, 0, 1, 1, 1, 2, 2, 2), show=["breaks"])
    (squares,) = [mark for mark in board.marks if mark.kind == "squares"]
    assert squares.points == ((3, 4), (5, 1))


@pytest.mark.parametrize("knots", [KNOTS, tuple(range(9)), (0, 1, 1, 1, 2, 2, 3, 3, 3)])
def test_the_graphs_painted_are_the_basis_functions_also_outside_of_the_domain(knots):
    board = Board(POINTS, knots=knots, show=["functions"])
    graphs = [mark.points for mark in board.marks if mark.kind == "line" and len(mark.points) > 2 and mark.frame]
    assert len(graphs) == len(POINTS)
    for i, graph in enumerate(graphs):
        own = np.array(knots[i : i + 4], float)
        t, y = np.array(graph).T
        assert (t[0], t[-1]) == (own[0], own[-1])
        inside = (t > own[0]) & (t < own[-1]) & ~np.isin(t, own)
        assert np.allclose(y[inside], BSpline.basis_element(own)(t[inside]))


def test_equal_knots_stand_under_each_other_and_their_value_under_all():
    board = Board(POINTS, knots=(0, 0, 0, 1, 1, 2, 3, 3, 3), show=[])
    *_, stacks, points, names = board.marks
    assert [y for x, y in stacks.points if x == 1] == [-0.2, -0.4]
    assert [mark.words for mark in board.marks if mark.kind == "below"] == [("0",), ("1",), ("2",), ("3",)]
    assert (len(points.points), names.words[0]) == (6, "b₀")


def test_picture_and_handout_have_the_line_under_the_curve():
    board = explore_bspline(POINTS, KNOTS, show=OF_KNOTS)
    above, under = board.svg.split("<svg ")[2:]
    assert "b₀" in above and "N₀" in under and 'x="0" y="' in under
    upper, lower = board.figure().axes
    assert lower.get_position().y1 < upper.get_position().y0
    assert lower.get_xlim() == (0, 4)
