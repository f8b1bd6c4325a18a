"""Pictures of B-spline curves: their spans, knot vectors compared, a knot inserted, points in four ways."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..naming import outward
from ..numeric import bspline, joins
from ..numeric.hull import hull
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import frame, names, polygon, word
from .spline_functions import LIGHT, STACK, knots_under
from .style import STYLE

EDGES = 8  # of a drawn piece, for each control point
STILL = 1e-9  # of the size of the points: a piece that moved less did not move
SPANS = ((FIRST, "-"), (SECOND, (0, (3, 1.2))))


@mpl.rc_context(STYLE)
def spans(points, knots, chosen):
    """A B-spline curve, its spans drawn in two looks by turns; the points of the chosen span filled, their hull grey.

    ``chosen`` is the index k of a span, whose points are b_{k-p}, ..., b_k.
    """
    degree = len(knots) - len(points) - 1
    figure = Figure(figsize=(8.6, 5), layout="constrained")
    axes = figure.subplots()
    near = np.asarray(points[chosen - degree : chosen + 1], dtype=float)
    axes.fill(*np.transpose(hull(near)), color=LIGHT, zorder=0.5)
    polygon(axes, points, QUIET, "s", ":")
    axes.plot(*near.T, "s", color=INK, markersize=9)
    pieces = _spans(axes, points, knots)
    names(axes, points, [f"$b_{{{i}}}$" for i in range(len(points))])
    frame(axes, points, 0.12)
    figure.set_label(
        f"A B-spline curve of degree {degree} in {pieces} spans by turns full and dashed, with squares where they "
        f"meet. The span from t = {number(knots[chosen])} to {number(knots[chosen + 1])} lies in the shaded hull of b_"
        f"{chosen - degree} to b_{chosen}."
    )
    return figure


@mpl.rc_context(STYLE)
def knot_vectors(points, vectors):
    """The same control points with knot vectors {title: knots}: the curve, and under it the knots in a line."""
    figure = Figure(figsize=(5.2 * len(vectors), 5), layout="constrained")
    panels = figure.subplots(2, len(vectors), squeeze=False, height_ratios=[4, 1])
    for (above, under), (title, knots) in zip(panels.T, vectors.items(), strict=True):
        polygon(above, points, QUIET, "s", ":")
        _spans(above, points, knots)
        above.set_title(title)
        frame(above, points, 0.1)
        degree = len(knots) - len(points) - 1
        under.axvspan(float(knots[degree]), float(knots[len(points)]), color=LIGHT, linewidth=0)
        knots_under(under, knots)
        under.set(ylim=(-0.2 - STACK * (degree + 1), 0.1))
        under.spines["left"].set_visible(False)
        under.set_yticks([])
    told = "; ".join(f"{title}: {', '.join(map(number, knots))}" for title, knots in vectors.items())
    figure.set_label(
        f"{len(points)} control points and a curve for each of {len(vectors)} knot vectors, with squares where its "
        f"spans meet, and under it the knots in a line. {told}."
    )
    return figure


@mpl.rc_context(STYLE)
def inserted(points, knots, t, times=1):
    """A B-spline curve with its polygon before and after a knot is inserted so many times; the curve is one."""
    after, longer = bspline.insert(points, knots, t, times)
    figure = Figure(figsize=(8.6, 5), layout="constrained")
    axes = figure.subplots()
    polygon(axes, points, QUIET, "s", ":", size=11)
    polygon(axes, after, SECOND, "o", "--", size=6, filled=True)
    _spans(axes, after, longer, plain=True)
    old = [tuple(place) for place in np.asarray(points, dtype=object)]
    new = [(i, place) for i, place in enumerate(after) if tuple(place) not in old]
    names(axes, points, [f"$b_{{{i}}}$" for i in range(len(points))])
    for i, place in new:
        word(axes, np.asarray(place, dtype=float), f"$c_{{{i}}}$", outward(after)[i])
    frame(axes, points, 0.12)
    listed = ", ".join(f"c_{i} = {point(place)}" for i, place in new)
    figure.set_label(
        f"One curve with two polygons: {len(points)} points before, {len(after)} after the knot {number(t)} is "
        f"inserted {'once' if times == 1 else f'{times} times'}. The new ones are {listed}, on edges of those before."
    )
    return figure


def _spline_pieces(points, degree):
    return bspline.to_bezier(points, bspline.clamped(len(points), degree))[0]


WAYS = {  # of a row of points to a curve in Bézier pieces
    "one Bézier curve": lambda points, degree: [points],
    "one-sixth rule": lambda points, degree: joins.catmull_rom(points),
    "natural spline": lambda points, degree: joins.natural(points),
    "B-spline": _spline_pieces,
}


@mpl.rc_context(STYLE)
def ways(points, place, to, titles=tuple(WAYS), degree=3):
    """Curves of one row of points made in several ways, before and after a point moves; what moves with it is thick.

    ``titles`` are of ``WAYS``; ``degree`` is that of the B-spline, whose knots are clamped.
    """
    after = [tuple(to) if i == place else tuple(there) for i, there in enumerate(points)]
    rows = -(-len(titles) // 2)
    width, height = np.ptp(np.asarray([*points, to], dtype=float), axis=0)
    figure = Figure(figsize=(10.4, rows * (0.9 + 4.4 * min(height / width, 0.8))), layout="constrained")
    panels = figure.subplots(rows, 2, squeeze=False, sharex=True, sharey=True).ravel()
    said = []
    for axes, title in zip(panels, titles, strict=False):
        before, now = (
            [np.asarray(piece, dtype=float) for piece in WAYS[title](row, degree)] for row in (points, after)
        )
        size = np.abs(np.asarray([*points, to], dtype=float)).max()
        changed = [np.abs(new - old).max() > STILL * size for old, new in zip(before, now, strict=True)]
        polygon(axes, after, QUIET, "o", ":", width=1, size=6)
        for old, new, moves in zip(before, now, changed, strict=True):
            _piece(axes, old, QUIET, "--", 1.4)
            _piece(axes, new, *((FIRST, "-", 4.5) if moves else (INK, "-", 1.6)))
        x, y = np.asarray([points[place], to], dtype=float).T
        axes.plot(x[1], y[1], "s", color=INK, markersize=8)
        axes.annotate("", (x[1], y[1]), (x[0], y[0]), arrowprops={"arrowstyle": "->", "color": INK})
        pieces = "the whole moves" if all(changed) else f"{sum(changed)} of {len(changed)} pieces move"
        axes.set_title(f"{title}: {pieces}", fontsize=14)
        frame(axes, [*points, to], 0.1)
        said.append(f"{title}: {pieces}")
    figure.set_label(
        f"Point {place} of {len(points)} is moved from {point(points[place])} to {point(to)}. {'; '.join(said)}."
    )
    return figure


def _piece(axes, points, colour, dash, width):
    """A curve with as many edges as its degree needs to look round."""
    x, y = numeric.sample(points, EDGES * len(points)).T
    axes.plot(x, y, color=colour, linestyle=dash, linewidth=width, zorder=1.9)


def _spans(axes, points, knots, plain=False):
    """Draw the spans of a curve, with squares where they meet; how many there are."""
    pieces = np.asarray(bspline.to_bezier(points, knots)[0], dtype=float)
    for k, piece in enumerate(pieces):
        _piece(axes, piece, *(SPANS[0] if plain else SPANS[k % 2]), 3.0)
    meet = np.concatenate([pieces[1:, 0], pieces[:-1, -1]])
    axes.plot(*meet.T, "s", color=INK, markerfacecolor="white", markersize=7, zorder=2.1)
    return len(pieces)
