"""The pictures of boxes, sign changes and pairs hold what the numbers say, and say it in words."""

import numpy as np
import pytest
from matplotlib.text import Text

from bezteach import figures
from bezteach.figures.crossing import meeting
from bezteach.numeric import box, subdivide
from bezteach.palette import FIRST, QUIET, SECOND

ARCH, VALLEY = [(-9, 0), (-3, 6), (3, 6), (9, 0)], [(-8, 5), (0, -4), (8, 7)]
ALL = {
    "boxes": lambda: figures.boxes(ARCH),
    "signs": lambda: figures.signs([-4, 7, -7, 4]),
    "crossing": lambda: figures.crossing(ARCH, VALLEY),
    "three panels": lambda: figures.crossing(ARCH, VALLEY, (1, 2, 3)),
}


def drawn(axes, filled):
    """The boxes of a panel as (left, bottom, right, top)."""
    patches = [patch for patch in axes.patches if (patch.get_alpha() is not None) == filled]
    return [tuple(np.round(patch.get_extents().transformed(axes.transData.inverted()).extents, 9)) for patch in patches]


def test_boxes_are_those_of_the_pieces():
    for depth, axes in enumerate(ALL["boxes"]().axes):
        expected = [tuple(np.round(np.asarray(sides, float).ravel(), 9)) for sides in box(subdivide(ARCH, depth))]
        assert drawn(axes, True) == drawn(axes, False) == expected


def test_signs_mark_every_piece_by_its_changes():
    """By hand: the halves are -4, 3/2, 3/4, 0 and 0, -3/4, -3/2, 4; the quarters next to 1/2 have no change."""
    panels = ALL["signs"]().axes
    colours = [[line.get_color() for line in axes.get_lines() if len(line.get_xdata()) == 4] for axes in panels]
    assert colours[:3] == [[SECOND], [FIRST, FIRST], [FIRST, QUIET, QUIET, FIRST]]
    assert colours[3] == [QUIET, FIRST, *[QUIET] * 4, FIRST, QUIET]
    first = next(line for line in panels[1].get_lines() if len(line.get_xdata()) == 4)
    assert np.allclose(first.get_data(), [(0, 1 / 6, 1 / 3, 1 / 2), (-4, 1.5, 0.75, 0)])
    markers = {line.get_marker() for axes in panels for line in axes.get_lines() if len(line.get_xdata()) == 4}
    assert len(markers) == 3


def test_pairs_that_meet():
    squares = [np.array([(k, k), (k + 1, k + 1)]) for k in range(3)]
    assert meeting(squares, squares[:1]) == [(0, 0), (1, 0)]  # a common corner is a common point
    assert meeting(squares[2:], squares[:1]) == []


def test_crossing_fills_the_boxes_that_meet_another():
    for depth, axes in enumerate(ALL["crossing"]().axes):
        filled, outlined = drawn(axes, True), drawn(axes, False)
        assert len(outlined) == 2 * 2**depth and set(filled) <= set(outlined)
        one, other = (box(subdivide(points, depth)) for points in (ARCH, VALLEY))
        pairs = meeting(one, other)
        assert len(filled) == len({i for i, _ in pairs}) + len({k for _, k in pairs})
        assert axes.get_title().startswith(f"{len(pairs)} of {4**depth} pair")
    assert "1 of 1, 4 of 4, 4 of 16, 4 of 64" in ALL["crossing"]().get_label()


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("boxes", "1, 2, 4, 8 of them. The first reaches from (-9, 0) to (9, 6)"),
        ("signs", "heights -4, 7, -7, 4 in pieces"),
        ("signs", "Pieces 1: 3; 2: 1, 1; 4: 1, 0, 0, 1;"),
        ("three panels", "4 of 4, 4 of 16, 4 of 64"),
    ],
)
def test_it_says_in_words_what_it_shows(name, words):
    assert words in ALL[name]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_words_lie_inside_and_do_not_overlap(name):
    figure = ALL[name]()
    figure.draw_without_rendering()
    frame = figure.bbox.padded(1)
    titles = [Text.get_window_extent(axes.title) for axes in figure.axes if axes.get_title()]
    legends = [legend.get_window_extent() for legend in figure.legends]
    assert all(frame.contains(one.x0, one.y0) and frame.contains(one.x1, one.y1) for one in [*titles, *legends])
    assert not any(title.overlaps(legend) for title in titles for legend in legends)
