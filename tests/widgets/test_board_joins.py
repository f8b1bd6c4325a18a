"""Layers of a board for curves in several pieces: what they paint, and what they say of each join, exactly."""

from fractions import Fraction as F
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from bezteach import numeric
from bezteach.widgets import Board, explore_join, explore_spline
from bezteach.widgets.board.blocks import exact_array
from bezteach.widgets.board.joining import a_frame, cut_in_pieces, joints
from bezteach.widgets.board.scene import scene
from bezteach.widgets.board.state import state_of
from bezteach.widgets.board.words import blocks

SMOOTH = ((0, 0), (0, 2), (2, 4), (4, 4), (6, 4), (8, 2), (8, 0))  # C2 at (4, 4): both tips are (4, 6)
DATA = ((0, 0), (1, 3), (4, 3), (6, 0), (9, 1))
HALF = F(1, 2)
PARAMETER = st.fractions(F(1, 20), F(19, 20), max_denominator=20)
POINT = st.tuples(*[st.fractions(-9, 9, max_denominator=6)] * 2)


def said(points, layer, t=HALF):
    """{title: rows} of a layer's blocks."""
    return dict(blocks(state_of(points, show=[layer], t=t))[1:])


def marks(kind, points, layer, t=HALF):
    """The points of the layer's marks of a kind, but the handles."""
    return [mark.points for mark in scene(state_of(points, show=[layer], t=t))[:-2] if mark.kind == kind]


# Pieces and their joins


def test_cubics_share_their_ends_and_the_rest_is_of_lower_degree():
    assert cut_in_pieces("abcdefghi") == ["abcd", "defg", "ghi"]
    assert cut_in_pieces("ab") == ["ab"]
    assert cut_in_pieces("abcd") == ["abcd"]


def test_intervals_take_turns():
    assert [lengths for *_, lengths in joints(list(range(10)), F(1, 3))] == [(F(1, 3), F(2, 3)), (F(2, 3), F(1, 3))]


def test_a_smooth_join():
    assert said(SMOOTH, "pieces") == {
        "Join (拼接) at b₃, intervals 1/2 and 1/2": (
            ("C0", "yes", "q - p: (0, 0)"),
            ("C1", "yes", "q' - p': (0, 0)"),
            ("G1", "yes", "q' - β p', β = 1: (0, 0)"),
            ("C2", "yes", "q'' - p'': (0, 0)"),
            ("G2", "yes", "q'' - β² p'' - γ p', γ = 0: (0, 0)"),
        )
    }


def test_the_same_points_over_other_intervals_lose_c1_and_keep_g1():
    [rows] = said(SMOOTH, "pieces", F(1, 3)).values()
    assert [row[:2] for row in rows[1:]] == [("C1", "no"), ("G1", "yes"), ("C2", "no"), ("G2", "yes")]
    # 3 (2, 0) over 1/3 arrives, over 2/3 starts; likewise 6 (0, -2) and 6 (0, -2) over the squares
    assert rows[1][2] == "q' - p': (-9, 0)"
    assert rows[3][2] == "q'' - p'': (0, 81)"


def test_a_corner_has_the_whole_of_the_next_velocity_left_over():
    [rows] = said(((0, 0), (1, 0), (2, 0), (3, 0), (2, 0), (1, 1), (0, 1)), "pieces").values()
    assert rows[2] == ("G1", "no", "q': (-6, 0)")


def test_a_class_that_lacks_only_the_one_below_it_says_so():
    """At a corner β is 0, and so is what G2 leaves over; on a straight line C2 may leave nothing over without C1."""
    corner = ((0, 0), (0, 2), (2, 4), (4, 4), (4, 2), (6, 0), (8, 2))
    assert said(corner, "pieces")["Join (拼接) at b₃, intervals 1/2 and 1/2"][2:] == (
        ("G1", "no", "q': (0, -12)"),
        ("C2", "no", "q'' - p'': (48, 48)"),
        ("G2", "no", "needs G1"),
    )
    [rows] = said(((0, 0), (1, 0), (2, 0), (3, 0), (5, 0), (7, 0), (9, 1)), "pieces").values()
    assert [row[:2] for row in rows[1:]] == [("C1", "no"), ("G1", "yes"), ("C2", "no"), ("G2", "yes")]
    assert rows[3][2] == "needs C1"


def test_without_a_tangent_the_geometric_classes_are_open():
    [rows] = said(((0, 0), (1, 1), (2, 2), (2, 2), (3, 2), (4, 1), (5, 0)), "pieces").values()
    assert rows[-1] == ("G1, G2", "open", "no tangent on the left")


@pytest.mark.parametrize("t", [0, 1])
def test_an_interval_without_length_joins_nothing(t):
    [(title, rows)] = said(SMOOTH, "pieces", t).items()
    assert title == f"Join (拼接) at b₃, intervals {t} and {1 - t}"
    assert rows == (("one interval has no length", "nothing joins"),)


@pytest.mark.parametrize("layer", ["pieces", "frames"])
def test_one_piece_has_no_join(layer):
    assert said(SMOOTH[:4], layer) == {"Joins (拼接)": (("none: up to four points are one piece",),)}


def test_the_frame_of_a_smooth_join_closes():
    assert said(SMOOTH, "frames") == {
        "A-frame at b₃: C1 with one tip is C2": (
            ("tip from the left", "(4, 6)"),
            ("tip from the right", "(4, 6)"),
        )
    }
    assert marks("line", SMOOTH, "frames") == [((2, 4), (4, 6)), ((6, 4), (4, 6))]


def test_the_legs_are_as_long_as_the_intervals_tell():
    [rows] = said(SMOOTH, "frames", F(1, 3)).values()
    assert [row[1] for row in rows] == ["(6, 8)", "(5, 5)"]


def test_a_piece_that_is_no_cubic_has_no_frame():
    assert said(SMOOTH[:6], "frames") == {
        "A-frame at b₃: C1 with one tip is C2": (("none: a piece is no cubic, or has no interval",),)
    }
    assert marks("line", SMOOTH[:6], "frames") == []


@settings(deadline=None)
@given(st.lists(POINT, min_size=4, max_size=4), POINT, POINT, PARAMETER)
def test_a_frame_closes_exactly_at_c2(left, inner, last, t):
    """Q_1 is put where C1 wants it; Q_2 somewhere, then where the left tip wants it."""
    left, inner = exact_array(left), np.array(inner, dtype=object)
    ratio = (1 - t) / t
    start = [left[3], left[3] + ratio * (left[3] - left[2])]
    tip, _ = a_frame(left, exact_array([*start, inner, last]), (t, 1 - t))
    wanted = start[1] + ratio * (start[1] - tip)
    for second in (inner, wanted):
        right = exact_array([*start, second, last])
        one, other = a_frame(left, right, (t, 1 - t))
        report = numeric.joins.continuity(left, right, (t, 1 - t))
        assert report.C1.holds
        assert report.C2.holds == (one == other).all()
    assert report.C2.holds


# Splines through the points as data


def test_the_one_sixth_rule_says_its_control_points():
    [(title, rows)] = said(DATA, "local").items()
    assert title == "Control points, one-sixth rule (六分之一法则)"
    # at (1, 3) the chord of the neighbours is (4, 3)
    assert rows[1][:2] == ("(1, 3)", "(5/3, 7/2)")
    assert rows[0][2:] == ("(1/3, 5/2)", "(1, 3)")
    assert len(rows) == 4


def test_the_natural_spline_is_scipy_s():
    x = np.arange(len(DATA))
    spline = CubicSpline(x, np.array(DATA, dtype=float), bc_type="natural")
    curves = marks("curve", DATA, "natural")
    at = np.linspace(0, 1, 5)
    for k, cubic in enumerate(curves):
        assert np.allclose(numeric.evaluate(np.array(cubic), at), spline(k + at))
    assert len(curves) == 4


@pytest.mark.parametrize("layer", ["local", "natural"])
def test_cubics_run_through_the_data(layer):
    curves = marks("curve", DATA, layer)
    assert [curve[0] for curve in curves] == list(DATA[:-1])
    assert all(left[-1] == right[0] for left, right in pairwise(curves))


# Their explorers


def test_a_join_to_explore():
    board = explore_join(SMOOTH[:4], SMOOTH[3:])
    assert board.points == SMOOTH
    assert board.t == HALF
    assert "C2 yes" in board.text
    assert "elevated" not in board.layers
    x0, y0, x1, y1 = board.view
    assert y1 > 6  # the tip is (4, 6), and no point is as high


def test_a_join_over_other_intervals():
    assert explore_join(SMOOTH[:4], SMOOTH[3:], lengths=(1, 2)).t == F(1, 3)


@pytest.mark.parametrize(
    ("left", "right", "lengths", "problem"),
    [
        (SMOOTH[:4], SMOOTH[2:6], (1, 1), r"the left curve ends at \(4, 4\) and the right one starts at \(2, 4\)"),
        (SMOOTH[:3], SMOOTH[2:6], (1, 1), "the left curve has 3 control points, and a cubic has 4"),
        (SMOOTH[:4], SMOOTH[3:6], (1, 1), "the right curve has 3 control points, and a cubic has 4"),
        (SMOOTH[:4], SMOOTH[3:], (1, 0), "the intervals have lengths 1 and 0: both must be positive"),
    ],
)
def test_what_is_no_join_is_refused(left, right, lengths, problem):
    with pytest.raises(ValueError, match=problem):
        explore_join(left, right, lengths)


def test_a_spline_to_explore():
    board = explore_spline(DATA)
    assert board.text.startswith("Data points: (0, 0) (1, 3)") and "one-sixth" in board.text
    assert "natural" not in board.text
    assert explore_spline(DATA, show=("local", "natural")).text.count("Control points, ") == 2
    assert isinstance(board, Board)
