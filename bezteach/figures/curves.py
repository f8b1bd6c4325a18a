"""Pictures of a curve and its polygon: the triangle, its paths, the last step, the halves, a part, halvings."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, names, polygon, word
from .style import STYLE

LEVEL_MARKERS = "osD^v<>ph*"


@mpl.rc_context(STYLE)
def triangle(points, t):
    """De Casteljau's construction at t, growing by a level from panel to panel; new points carry their coordinates."""
    levels = numeric.de_casteljau(points, t)
    figure, panels = _panels(len(levels), points)
    for last, axes in enumerate(panels):
        for k, level in enumerate(levels[: last + 1]):
            newest = k == last
            polygon(axes, level, INK if newest else QUIET, LEVEL_MARKERS[k % 10], "-" if newest else ":", filled=newest)
        _coordinates(axes, levels, last)
        axes.set_title(f"level {last}" if last else "the polygon")
    curve(panels[-1], points, FIRST)
    found = ", ".join(point(p) for p in levels[-1])
    figure.set_label(
        f"De Casteljau's construction at t = {number(t)} in {len(levels)} pictures, a level more in each: "
        f"every edge is cut in the same ratio, down to the one point {found} of the curve."
    )
    return figure


@mpl.rc_context(STYLE)
def loci(points, t):
    """The paths of the intermediate points as the parameter runs from 0 to 1, a panel a level, and where they are at t.

    Source: deck, 2.1: point j of level k runs along the curve of degree k with the control points j, ..., j + k.
    """
    levels = numeric.de_casteljau(points, t)
    figure, panels = _panels(len(levels) - 1, points)
    for k, (axes, level) in enumerate(zip(panels, levels[1:], strict=True), 1):
        polygon(axes, points, QUIET, ".", ":")
        for j in range(len(level)):
            curve(axes, points[j : j + k + 1], (FIRST, SECOND)[j % 2], dash=("-", "--")[j % 2])
        x, y = np.asarray(level, dtype=float).T
        axes.plot(x, y, linestyle="", marker=LEVEL_MARKERS[k % 10], color=INK, markersize=9)
        axes.set_title(f"level {k}: {len(level)} path{'s' if len(level) > 1 else ''} of degree {k}")
    counted = ", ".join(f"{len(level)} of degree {k}" for k, level in enumerate(levels[1:], 1))
    figure.set_label(f"The paths of the intermediate points, with their places at t = {number(t)}: {counted}.")
    return figure


@mpl.rc_context(STYLE)
def lower_curves(points, t):
    """A curve, the two curves of its first n and of its last n points, and the line between their points at t."""
    *_, ends, (here,) = numeric.de_casteljau(points, t)
    degree = len(points) - 1
    figure, (axes,) = _panels(1, points)
    polygon(axes, points, QUIET, "o", ":")
    _named(axes, points, "b")
    curve(axes, points[:-1], SECOND, dash="--", label=f"first {degree} points")
    curve(axes, points[1:], INK, dash="-.", label=f"last {degree} points")
    curve(axes, points, FIRST, width=4, label="the curve")
    polygon(axes, ends, INK, "s", "-")
    axes.plot(*map(float, here), "o", color=FIRST, markersize=11)
    figure.legend(loc="outside lower center", ncols=3)
    figure.set_label(
        f"A curve of degree {degree} between two curves of degree {degree - 1}, of its first and of its last {degree} "
        f"points. At t = {number(t)} these are at {point(ends[0])} and {point(ends[1])}; "
        f"the curve's point {point(here)} lies on the line between them."
    )
    return figure


@mpl.rc_context(STYLE)
def split(points, t):
    """The two halves of a curve cut at t with their control polygons, over the polygon of the whole."""
    left, right = numeric.split(points, t)
    figure, (axes,) = _panels(1, points)
    polygon(axes, points, QUIET, ".", ":")
    _named(axes, points, "b")
    _half(axes, left, FIRST, "o", "-", f"left, 0 to {number(t)}")
    _half(axes, right, SECOND, "s", "--", f"right, {number(t)} to 1")
    figure.legend(loc="outside lower center", ncols=2)
    figure.set_label(
        f"A curve cut at t = {number(t)}, the point {point(left[-1])}. "
        f"Left half: {_listed(left)}. Right half: {_listed(right)}."
    )
    return figure


@mpl.rc_context(STYLE)
def segment(points, a, b):
    """The part of a curve over [a, b] with its control polygon, over the whole."""
    part = numeric.segment(points, a, b)
    figure, (axes,) = _panels(1, np.concatenate([points, part]))
    polygon(axes, points, QUIET, ".", ":")
    _named(axes, points, "b")
    curve(axes, points, QUIET)
    _half(axes, part, FIRST, "o", "-", f"part, {number(a)} to {number(b)}")
    figure.legend(loc="outside lower center", ncols=2)
    figure.set_label(
        f"The part of a curve from t = {number(a)} to t = {number(b)}. Its control points: {_listed(part)}."
    )
    return figure


@mpl.rc_context(STYLE)
def halving(points, depths=(0, 1, 2, 3)):
    """The control polygons after repeated halving, a panel a depth, over the curve."""
    figure, panels = _panels(len(depths), points)
    for axes, depth in zip(panels, depths, strict=True):
        curve(axes, points, QUIET, width=5)
        for number_of_piece, piece in enumerate(numeric.subdivide(points, depth)):
            polygon(axes, piece, (FIRST, SECOND)[number_of_piece % 2], "os"[number_of_piece % 2], "-", size=5)
        axes.set_title(f"{2**depth} piece{'s' if depth else ''}")
    pieces = ", ".join(str(2**depth) for depth in depths)
    figure.set_label(f"The control polygons of a curve in {pieces} pieces: at each halving they hug the curve closer.")
    return figure


def _panels(count, points):
    """A figure with panels, two a row, all of the same scale, wide enough for the points and their labels."""
    columns = min(count, 2)
    rows = -(-count // columns)
    low, high = (np.asarray(f(points, axis=0), dtype=float) for f in (np.min, np.max))
    margin = np.array([0.16, 0.16] if count == 1 else [0.36, 0.26]) * max(high - low)  # names need room in small panels
    width, height = high - low + 2 * margin
    across = 7 if count == 1 else 4.3
    size = (across * columns, rows * (min(across * height / width, 6) + 0.4))
    figure = Figure(figsize=size, layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels:
        left, bottom, right, top = *(low - margin), *(high + margin)
        axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    for axes in panels[count:]:
        axes.set_axis_off()
    return figure, panels[:count]


def _half(axes, points, colour, marker, dash, label):
    polygon(axes, points, colour, marker, dash, width=1.4)
    curve(axes, points, colour, dash=dash, width=4, label=label)


def _named(axes, points, name):
    names(axes, points, [f"${name}_{{{i}}}$" for i in range(len(points))])


def _coordinates(axes, levels, last):
    """Write their coordinates beside the points of a level; the last point's stand across the edge that it is on."""
    if len(levels[last]) > 1:
        names(axes, levels[last], map(point, levels[last]))
    else:
        (here,) = np.asarray(levels[last], dtype=float)
        word(axes, here, point(levels[last][0]), _rising(levels[last - 1]))


def _rising(points):
    """The normal of the way from the first point to the last that points to the left of it."""
    x, y = np.asarray(points[-1], dtype=float) - np.asarray(points[0], dtype=float)
    return np.array([-y, x])


def _listed(points):
    return ", ".join(map(point, points))
