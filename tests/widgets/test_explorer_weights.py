"""The explorer of weights: what it says is exact, what it paints is that curve, and it stands at every end."""

from fractions import Fraction as F
from html import escape

import numpy as np
import pytest

from bezteach import widgets
from bezteach.questions import GOALS
from bezteach.widgets.explorers.weights import STOPS, carried

QUARTER = ((1, 0), (1, 1), (0, 1))
ARCH = ((0, 0), (2, 4), (4, 0))
ROUND = "x² + y² = 1 for every t"


def explored(weights=(1, 1, 1), of=2, **settings):
    return widgets.explore_weights(QUARTER, weights, of=of, circle=True, **settings)


def painted(panel, kind, place=0):
    return [np.array(mark["points"]) for mark in panel.board.answer["marks"] if mark["kind"] == kind][place]


def test_it_says_the_point_in_space_and_in_the_plane():
    panel = explored((1, 1, 2))
    assert panel.text == (
        "Weights: 1 1 2; At t = 1/2: one dimension up (3/4, 1, 5/4), divided (3/5, 4/5), x² + y² 1; "
        f"Dashed: all weights equal: at t = 1/2 (3/4, 3/4); On the unit circle (dotted): {ROUND}"
    )
    panel.controls["t"].value = F(2, 3)
    assert "one dimension up (5/9, 4/3, 13/9), divided (5/13, 12/13), x² + y² 1" in panel.text


def test_only_one_weight_makes_it_a_circle_and_the_goal_is_recognised():
    goal = GOALS["rational/circle"]
    panel = explored(goal=goal)
    board, round_ones = panel.board, []
    for stop in STOPS[1:]:
        panel.controls["w"].value = stop
        assert (ROUND in panel.text) == (goal.praise in panel.text) != (goal.text in panel.text)
        round_ones += [stop] * (ROUND in panel.text)
    assert round_ones == [2]
    panel.controls["w"].value = F(2)
    assert escape(goal.praise) in board.answer["html"]
    board.points = [(1, 0), (1, F(1, 2)), (0, 1)]
    assert goal.text in panel.text and ROUND not in panel.text


def test_a_square_marks_the_place_to_pass_and_its_goal_is_recognised():
    goal = GOALS["rational/through"]
    panel = widgets.explore_weights(ARCH, (1, 1, 1), of=1, target=(2, F(8, 3)), goal=goal)
    assert painted(panel, "squares").tolist() == [[2, pytest.approx(8 / 3)]] and "x² + y²" not in panel.text
    assert goal.text in panel.text
    panel.controls["w"].value = F(2)
    assert goal.praise in panel.text and "divided (2, 8/3)" in panel.text


@pytest.mark.parametrize("w", [F(1, 4), F(1), F(2), F(16)])
def test_the_painted_curve_and_point_are_those_of_the_weights(w):
    panel = explored((1, 1, w))
    x, y = painted(panel, "line").T
    t = np.linspace(0, 1, len(x))
    assert np.allclose(x, (1 - t**2) / (1 - t**2 + float(w) * t**2))
    assert np.allclose(y, (2 * t * (1 - t) + float(w) * t**2) / (1 - t**2 + float(w) * t**2))
    ray, dot = painted(panel, "line", 1), painted(panel, "dots")
    assert np.allclose(ray, [(x[48], y[48]), (0, 1)]) and np.allclose(dot, [(x[48], y[48])])
    assert painted(panel, "curve").tolist() == [[1, 0], [1, 1], [0, 1]]
    assert painted(panel, "circle").tolist() == [[0, 0], [1, 0]]


@pytest.mark.parametrize("of", [0, 1, 2])
@pytest.mark.parametrize("t", [F(0), F(1)])
def test_it_stands_at_the_ends_of_its_sliders(of, t):
    panel = explored(of=of, t=t)
    stops = [stop for _, stop in panel.controls["w"].options]
    assert stops == list(STOPS if of == 1 else STOPS[1:])
    for stop in (stops[0], stops[-1]):
        panel.controls["w"].value = stop
        assert "nan" not in panel.board.svg and "inf" not in panel.board.svg
        assert f"divided {'(1, 0)' if t == 0 else '(0, 1)'}" in panel.text


def test_another_number_of_points_is_no_error():
    panel = explored(of=1)
    panel.controls["w"].value = F(0)
    panel.board.points = QUARTER[:2]
    assert "Weights: 1 0;" in panel.text and "divided (1, 0)" in panel.text
    panel.controls["t"].value = F(1)
    assert "no point the weight of this end is 0" in panel.text and "nan" not in panel.board.svg
    panel.board.points = (*QUARTER, (-1, 1))
    assert "Weights: 1 0 1 1;" in panel.text and "nan" not in panel.board.svg
    panel = explored(of=2)
    panel.board.points = QUARTER[:2]
    assert "Weights: 1 1;" in panel.text
    assert carried((1, 2, 3), 2) == (1, 2) and carried((1, 2), 4) == (1, 2, 1, 1)


@pytest.mark.parametrize(
    ("weights", "of", "words"),
    [
        ((1, 1), 0, "3 control points and 2 weights"),
        ((1, -1, 1), 0, "weight w_1 is -1"),
        ((0, 1, 1), 1, "weight w_0 is 0: the ends need positive weights"),
        ((1, 1, 1), 3, "there is no control point b_3: there are b_0 to b_2"),
        ((1, F(1, 3), 1), 1, "w = 1/3: the slider stops at 0, 1/4, ..., 16"),
        ((1, "x", 1), 1, "weight w_1 is 'x'"),
    ],
)
def test_what_does_not_fit_is_named(weights, of, words):
    with pytest.raises(ValueError, match=words):
        explored(weights, of)


def test_it_stands_in_for_itself_in_a_stored_notebook():
    panel = explored()
    shown = panel._repr_mimebundle_()
    data = shown[0] if isinstance(shown, tuple) else shown
    assert data["text/plain"] == repr(panel) == panel.text and data["text/html"].startswith('<img alt="Weights: 1 1 1')
