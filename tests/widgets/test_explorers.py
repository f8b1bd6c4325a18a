"""Explorers: what each shows at its start, at the ends of its controls, and for degenerate points."""

import re
from fractions import Fraction as F
from html import escape
from xml.etree import ElementTree

import numpy as np
import pytest
from sympy import Poly, Rational, symbols

from bezteach import numeric, questions, widgets
from bezteach.examples import EXAMPLES
from bezteach.widgets.explorers.affine import MAPS, affine_blocks, image
from bezteach.widgets.explorers.basis import basis_view
from bezteach.widgets.explorers.powers import bernstein_points, graph, power_points
from bezteach.widgets.explorers.quartic import STOPS, quartic, quartic_blocks

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
PARABOLA = EXAMPLES["games/quadratic"].given["points"]
SVG = "{http://www.w3.org/2000/svg}"
PRESETS = [
    widgets.explore_casteljau,
    widgets.explore_crossings,
    widgets.explore_curvature,
    widgets.explore_elevation,
    widgets.explore_halving,
    widgets.explore_hodograph,
    widgets.explore_segment,
    widgets.explore_split,
    widgets.explore_tangents,
]
DEGENERATE = [((1, 1),) * 4, ((0, 0), (1, 0), (2, 0)), ((0, 0), (0, 5))]


@pytest.mark.parametrize("explore", PRESETS, ids=lambda explore: explore.__name__)
@pytest.mark.parametrize("points", [CUBIC, ARCH, PARABOLA, *DEGENERATE])
def test_a_preset_is_a_board_whose_layers_can_be_switched(explore, points):
    board = explore(points)
    assert set(board.state.show) <= set(board.layers)
    assert board.points == tuple(points)
    assert board.text and "nan" not in board.svg


def test_the_place_to_pull_to_is_a_square_with_its_name():
    board = widgets.explore_pull(ARCH, (F(9, 4), 1), t=F(1, 3))
    square, name = board.marks[:2]
    assert (square.kind, name.kind) == ("squares", "names")
    assert square.points == name.points == ((2.25, 1.0),) and name.words == ("(9/4, 1)",)
    assert tuple(board.layers) == board.state.show == ("polygon", "curve", "point") and board.state.t == F(1, 3)


ENDS = [
    *[(explore, {"t": t}) for explore in (PRESETS[0], PRESETS[5], PRESETS[7], PRESETS[8]) for t in (0, 1)],
    *[(widgets.explore_casteljau, {"level": level}) for level in (0, None)],
    *[(widgets.explore_segment, {"a": a, "b": b}) for a, b in ((0, 1), (1, 0), (0, 0), (1, 1))],
    *[(widgets.explore_curvature, {"end": end}) for end in (0, 1)],
    *[(widgets.explore_elevation, {"raised": raised}) for raised in (0, 12)],
    *[(widgets.explore_halving, {"depth": depth}) for depth in (0, 6)],
]


@pytest.mark.parametrize(("explore", "settings"), ENDS, ids=lambda value: getattr(value, "__name__", str(value)))
@pytest.mark.parametrize("points", [CUBIC, *DEGENERATE])
def test_a_preset_stands_at_the_ends_of_its_controls(explore, settings, points):
    board = explore(points, **settings)
    assert all(getattr(board.state, name) == value for name, value in settings.items())
    assert board.text and "nan" not in board.svg and "inf" not in board.svg


def test_split_starts_at_the_slide_s_example():
    board = widgets.explore_split(CUBIC)
    assert board.t == F(1, 3)
    assert (
        "(0, 0), (1, 3) (1/3, 1), (2, 1) (4/3, 7/3) (2/3, 13/9), (3, 3) (7/3, 5/3) (5/3, 19/9) (1, 5/3)" in board.text
    )


def test_the_goal_is_recognised_when_it_is_reached():
    goal = questions.GOALS["splitting/middle-edge"]
    board = widgets.explore_segment(ARCH, goal=goal)
    assert goal.text in board.text and escape(goal.text) in board.answer["html"]
    board.change(a=F(1, 3), b=F(2, 3))
    assert goal.praise in board.text and goal.text not in board.text
    board.change(a=F(2, 3), b=F(1, 3))
    assert goal.text in board.text


# The Bernstein functions


def test_basis_explorer_shows_exact_values_and_their_sum():
    explorer = widgets.explore_basis()
    assert repr(explorer) == "Degree 3 at t = 1/3: B₀ 8/27, B₁ 4/9, B₂ 2/9, B₃ 1/27, sum 1"
    explorer.controls["n"].value, explorer.controls["t"].value = 2, F(1, 2)
    assert repr(explorer) == "Degree 2 at t = 1/2: B₀ 1/4, B₁ 1/2, B₂ 1/4, sum 1"
    assert "<td>1/2</td>" in explorer.children[1].children[1].value


def dots(picture):
    """The marked points of a picture in picture coordinates."""
    return [
        (float(c.attrib["cx"]), float(c.attrib["cy"])) for c in ElementTree.fromstring(picture).iter(f"{SVG}circle")
    ]


def test_basis_explorer_marks_the_values_on_the_graphs():
    view = basis_view(2, F(1, 2))
    (x0, y0), (x1, y1), (_, y2) = dots(view["svg"])
    (_, bottom), (_, top) = dots(basis_view(1, F(1))["svg"])
    assert x0 == x1 and y0 == y2
    assert [(bottom - y) / (bottom - top) for y in (y0, y1)] == pytest.approx([1 / 4, 1 / 2], abs=1e-3)
    assert ElementTree.fromstring(view["svg"]).attrib["aria-label"] == view["text"]


@pytest.mark.parametrize("n", range(7))
def test_every_degree_is_drawn_also_at_the_ends(n):
    for where in (F(0), F(1, 3), F(1)):
        view = basis_view(n, where)
        assert len(dots(view["svg"])) == n + 1 and "nan" not in view["svg"] and view["text"].endswith("sum 1")


@pytest.mark.parametrize(("n", "t"), [(7, F(1, 3)), (3, F(1, 5)), (3, F(25, 24)), (3, 2)])
def test_a_start_that_the_slider_does_not_have_is_refused(n, t):
    with pytest.raises(ValueError, match=r"the slider stops at 0, (1, ..., 6|1/24, ..., 1)$"):
        widgets.explore_basis(n, t)


# One polynomial in two bases


def test_the_coefficients_of_both_bases_belong_to_one_polynomial():
    t = symbols("t")
    heights = (F(1), F(-2), F(3, 2), F(0))
    bernstein = sum(Rational(h.numerator, h.denominator) * B for h, B in zip(heights, _cubic_basis(t), strict=True))
    powers = [y for _, y in power_points(graph(heights))]
    assert [Rational(p.numerator, p.denominator) for p in powers] == Poly(bernstein, t).all_coeffs()[::-1]
    assert bernstein_points(power_points(graph(heights))) == graph(heights)


def _cubic_basis(t):
    return [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3]


def test_what_moves_on_one_board_moves_on_the_other():
    panel = widgets.explore_powers((0, 1, 0, 1))
    assert [y for _, y in panel.powers.points] == [0, 3, -6, 4]
    panel.powers.points = graph((1, 3, -6, 4))
    assert [y for _, y in panel.board.points] == [1, 2, 1, 2]
    panel.board.points = graph((0, 0, 0, 1))
    assert [y for _, y in panel.powers.points] == [0, 0, 0, 1]


def test_points_that_leave_the_view_make_it_grow():
    panel = widgets.explore_powers()
    panel.powers.points = graph((0, 0, 0, 40))
    assert panel.board.view[3] > 40


@pytest.mark.parametrize("moved", ["board", "powers"])
def test_back_at_the_start_both_views_are_the_first_ones_again(moved):
    panel = widgets.explore_powers()
    board = getattr(panel, moved)
    start, views = board.points, [panel.board.view, panel.powers.view]
    board.points = graph((0, 0, 0, 40))
    assert panel.board.view[3] > 40 and panel.powers.view[3] > 40
    board.points = graph((0, 1, 0, 40))
    assert panel.board.view[3] > 40
    board.points = start
    assert [panel.board.view, panel.powers.view] == views


def test_the_graph_on_the_right_follows():
    panel = widgets.explore_powers()
    panel.board.points = graph((2, 2, 2, 2))
    (curve,) = [mark for mark in panel.powers.answer["marks"] if mark["kind"] == "curve"]
    assert [y for _, y in curve["points"]] == [2, 2, 2, 2]


# The quartic


@pytest.mark.parametrize("w", STOPS)
def test_the_quartic_is_convex_for_w_in_the_deck_s_range(w):
    """y'' = -6 + 24 t - 24 t^2 + w (12 - 72 t + 72 t^2): its sign over [0, 1] on a fine exact grid."""
    grid = [F(k, 400) for k in range(1, 400)]
    signs = [s for s in ((-6 + 24 * t - 24 * t * t + w * (12 - 72 * t + 72 * t * t)) for t in grid) if s]
    turns = sum((s > 0) != (r > 0) for s, r in zip(signs, signs[1:], strict=False))
    said = dict((block.title, block.rows[0][0]) for block in quartic_blocks(quartic(w)))
    assert said["The curve"].startswith(f"{turns} inflection point")
    assert (turns == 0) == (0 <= w <= F(1, 2)) == ("not convex" not in said["The curve"])


def test_slider_and_board_of_the_quartic_move_each_other():
    panel = widgets.explore_quartic(F(1, 4))
    panel.controls["w"].value = F(1, 2)
    assert panel.board.points[2] == (F(1, 2), F(1, 2))
    assert "convex, it bends one way only" in panel.text
    panel.controls["w"].value = F(9, 16)
    assert "2 inflection points: not convex" in panel.text


def test_the_slider_of_the_quartic_follows_its_point():
    panel = widgets.explore_quartic(F(1, 4))
    moved = (*quartic(F(1, 4))[:1], (F(1, 4), F(1, 2)), (F(1, 2), F(-3, 16)), *quartic(F(1, 4))[3:])
    panel.board.points = moved
    assert panel.controls["w"].value == F(-3, 16) and panel.board.points == moved
    panel.controls["w"].value = F(3, 8)
    assert panel.board.points == (*moved[:2], (F(1, 2), F(3, 8)), *moved[3:])
    panel.board.points = quartic(F(1, 3))
    assert panel.controls["w"].value == F(3, 8) and panel.board.points == quartic(F(1, 3))


def test_where_the_quartic_s_point_can_be_dragged_the_slider_stops():
    board = widgets.explore_quartic().board
    _, low, _, high = board.view
    step = F(board.grid)
    assert [k * step for k in range(-99, 99) if low <= k * step <= high] == list(STOPS)


def test_a_straight_graph_has_no_inflection_point():
    assert quartic_blocks([(0, 0), (1, 1), (2, 2)])[-1].rows[0][0].startswith("0 inflection points")


# Affine invariance


@pytest.mark.parametrize("name", MAPS)
@pytest.mark.parametrize("t", [F(0), F(1, 3), F(1)])
def test_an_affine_map_may_come_before_or_after_the_curve(name, t):
    said = {block.title for block in affine_blocks(CUBIC, t, name)}
    affine = "not affine" not in name or t in (0, 1)
    assert ("One point, computed in two ways" in said) == affine
    assert ("Two points: this map is not affine" in said) == (not affine)


def test_maps_leave_the_first_point_but_for_the_shift():
    for name in MAPS:
        assert (image(CUBIC, name)[0] == CUBIC[0]) == (name != "shift")
    turned = np.array(image(CUBIC, "turn (cosine 4/5, sine 3/5)"), dtype=float)
    assert np.hypot(*np.diff(turned, axis=0).T) == pytest.approx(np.hypot(*np.diff(np.array(CUBIC, float), axis=0).T))


def test_another_map_is_said_and_painted():
    panel = widgets.explore_affine(CUBIC)
    before = panel.svg if hasattr(panel, "svg") else panel.board.svg
    panel.controls["map"].value = "shear"
    assert panel.board.svg != before and "(5/2, 3)" in panel.text
    with pytest.raises(ValueError, match="there is no transformation 'twist': there are shift, turn"):
        widgets.explore_affine(CUBIC, transformation="twist")


def test_dots_lie_on_the_curve_of_the_mapped_points():
    marks = {mark["kind"]: mark["points"] for mark in widgets.explore_affine(CUBIC).board.answer["marks"]}
    on_curve = numeric.sample(np.array(marks["curve"]), len(marks["dots"]))
    assert np.abs(on_curve - np.array(marks["dots"])).max() < 1e-12


def test_two_boards_are_stored_as_two_pictures():
    panel = widgets.explore_powers((0, 1, 0, 1))
    words = ["Coefficients of B₀, B₁, ...: 0 1 0 1", "Coefficients of 1, t, t², ...: 0 3 -6 4"]
    assert panel.text == "; ".join(words)
    assert re.findall('<img alt="([^"]+)"', panel._repr_mimebundle_()["text/html"]) == words


@pytest.mark.parametrize("build", [widgets.explore_affine, widgets.explore_split])
def test_a_panel_stands_in_for_itself_in_a_stored_notebook(build):
    shown = build(CUBIC)
    bundle = shown._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    assert data["text/plain"] == shown.text and re.match("<img ", data["text/html"])
