"""What hulls and halving find: the range of a curve, the roots of a polynomial, the points two curves share."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, polygon
from .style import STYLE

DEPTHS = (0, 1, 2, 3)
HALVES = (FIRST, "-"), (SECOND, "--")
SIGNS = {  # sign changes of a part: colour, dash, marker, words
    0: (QUIET, ":", "x", "no sign change: no root inside"),
    1: (FIRST, "-", "o", "one: a single root inside"),
    2: (SECOND, "--", "s", "more: halve again"),
}


@mpl.rc_context(STYLE)
def boxes(points, depths=DEPTHS):
    """The boxes of the pieces of a curve after repeated halving, a panel a depth. Source: notes, 2.3.5, curve range."""
    figure, panels = _panels(len(depths))
    for axes, depth in zip(panels, depths, strict=True):
        pieces = numeric.subdivide(points, depth)
        for k, sides in enumerate(numeric.box(pieces)):
            _box(axes, sides, *HALVES[k % 2])
        polygon(axes, points, QUIET, "o", ":", size=6)
        curve(axes, points, INK)
        axes.set_title(f"{2**depth} box{'es' if depth else ''}")
    _frame(panels, min(depths), points)
    low, high = numeric.box(points)
    figure.set_label(
        f"The boxes around the pieces of a curve, {_counted(depths)} of them. The first reaches from {point(low)} to "
        f"{point(high)}; the more pieces, the closer the boxes are to the curve."
    )
    return figure


@mpl.rc_context(STYLE)
def signs(heights, depths=DEPTHS):
    """The graph of a polynomial in pieces, a panel a depth: each piece's polygon shows how often its sign changes.

    Source: games, de Casteljau, "for root finding".
    """
    figure, panels = _panels(len(depths), 2.6)
    told = []
    for axes, depth in zip(panels, depths, strict=True):
        changes = []
        for k, piece in enumerate(numeric.subdivide(heights, depth)):
            places = np.linspace(k, k + 1, len(heights)) / 2**depth
            changes.append(numeric.sign_changes(piece))
            colour, dash, marker, _ = SIGNS[min(changes[-1], 2)]
            polygon(axes, np.column_stack([places, piece]), colour, marker, dash, width=2.2, size=6)
        axes.plot(np.linspace(0, 1, 129), numeric.sample(heights, 129).astype(float), color=INK, linewidth=1.2)
        axes.axhline(0, color=QUIET, linewidth=1, zorder=0.5)
        axes.set(title=f"{2**depth} piece{'s' if depth else ''}", xlabel="t", xticks=[0, 0.5, 1])
        axes.set_xticklabels(["0", "1/2", "1"])
        told.append(f"{2**depth}: {', '.join(map(str, changes))}")
    for colour, dash, marker, words in SIGNS.values():
        panels[0].plot([], [], color=colour, linestyle=dash, marker=marker, markerfacecolor="white", label=words)
    figure.legend(loc="outside lower center", ncols=1)
    figure.set_label(
        f"The graph with the heights {', '.join(map(number, heights))} in pieces, and how often the sign changes along "
        f"the heights of each. Pieces {'; '.join(told)}."
    )
    return figure


@mpl.rc_context(STYLE)
def crossing(one, other, depths=DEPTHS):
    """Two curves and the boxes of their pieces, a panel a depth: filled those that meet one of the other curve.

    Source: deck, 1.2, convex hull: it tells which curves cannot intersect.
    """
    figure, panels = _panels(len(depths))
    told = []
    for axes, depth in zip(panels, depths, strict=True):
        sides = [numeric.box(numeric.subdivide(points, depth)) for points in (one, other)]
        pairs = meeting(*sides)
        for which, (colour, dash) in enumerate(HALVES):
            alive = {pair[which] for pair in pairs}
            for k, corners in enumerate(sides[which]):
                if k in alive:
                    _box(axes, corners, colour, dash)
                else:
                    _box(axes, corners, QUIET, ":", filled=False)
        curve(axes, one, FIRST, label="first curve")
        curve(axes, other, SECOND, dash="--", label="second curve")
        axes.set_title(f"{len(pairs)} of {4**depth} pair{'s' if depth else ''} left")
        told.append(f"{len(pairs)} of {4**depth}")
    _frame(panels, min(depths), one, other)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    figure.set_label(
        f"Two curves, halved again and again, and the boxes of their pieces. Pairs of boxes that meet: "
        f"{', '.join(told)}; they are filled, and gather where the curves meet."
    )
    return figure


def meeting(boxes_of_one, boxes_of_other):
    """The pairs (i, k) of boxes, given as (low, high), that have a point in common."""
    pairs = [(i, k) for i in range(len(boxes_of_one)) for k in range(len(boxes_of_other))]
    return [(i, k) for i, k in pairs if _meet(boxes_of_one[i], boxes_of_other[k])]


def _meet(one, other):
    return bool((one[0] <= other[1]).all() and (other[0] <= one[1]).all())


def _box(axes, corners, colour, dash, *, filled=True):
    (left, bottom), (right, top) = np.asarray(corners, dtype=float)
    outline = {"edgecolor": colour, "linestyle": dash, "linewidth": 1.6 if filled else 1.2}
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, facecolor="none", zorder=1.5, **outline))
    if filled:
        axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, color=colour, alpha=0.15, linewidth=0))


def _counted(depths):
    return ", ".join(str(2**depth) for depth in depths)


def _panels(count, height=3.0):
    """A figure with panels, two a row, each so many inches high."""
    columns = min(count, 2)
    rows = -(-count // columns)
    figure = Figure(figsize=(4.6 * columns, height * rows + 0.4), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels[count:]:
        axes.set_axis_off()
    return figure, panels[:count]


def _frame(panels, depth, *curves):
    """Equal scales in all panels, with some room around the boxes of the pieces at a depth, the fewest shown."""
    corners = np.concatenate([numeric.box(numeric.subdivide(points, depth)).reshape(-1, 2) for points in curves])
    (left, bottom), (right, top) = np.asarray(numeric.box(corners), dtype=float)
    room = 0.06 * max(right - left, top - bottom)
    for axes in panels:
        axes.set(xlim=(left - room, right + room), ylim=(bottom - room, top + room), aspect="equal")
        axes.locator_params(nbins=6)
