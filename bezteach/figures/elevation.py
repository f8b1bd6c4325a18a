"""Pictures of one curve in several degrees: the new points on the old edges, the polygons that tend to it, and the
nearest curve of lower degree.
"""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, polygon, word
from .style import STYLE


@mpl.rc_context(STYLE)
def elevated(points):
    """A curve with its polygon and the polygon one degree higher, and in which ratio each new point divides its edge.

    Source: notes, 2.3.3, whose own picture is lost.
    """
    raised = numeric.elevate(points)
    n = len(points) - 1
    figure, (axes,) = _panels(1, points)
    polygon(axes, points, QUIET, "s", ":", width=2.2, size=10)
    polygon(axes, raised, FIRST, "o", "-", filled=True)
    curve(axes, points, SECOND, width=4.5)
    old, new = np.asarray(points, dtype=float), np.asarray(raised, dtype=float)
    middle = old.mean(axis=0)
    for i, place in enumerate(old):
        same = rf"$b_{{{i}}} = c_{{{i + (i == n)}}}$"
        word(axes, place, same if i in (0, n) else f"$b_{{{i}}}$", place - middle)
    for i, place in enumerate(new[1:-1], 1):
        x, y = old[i] - old[i - 1]
        across = np.array([-y, x])
        side = -1 if across @ (middle - place) > 0 else 1
        word(axes, place, f"$c_{{{i}}}$  {n + 1 - i} : {i}", side * across)
    told = ", ".join(f"{point(c)} divides its edge {n + 1 - i} : {i}" for i, c in enumerate(raised[1:-1], 1))
    figure.set_label(
        f"A curve of degree {n} with its polygon and the one of degree {n + 1}, whose inner points lie on the old "
        f"edges: {told}. The curve is the same."
    )
    return figure


@mpl.rc_context(STYLE)
def raised(points, orders=(1, 3, 9, 27)):
    """The polygons of a curve some degrees higher, a panel each, over the polygon as given and the curve."""
    figure, panels = _panels(len(orders), points)
    degrees = [len(points) - 1 + r for r in orders]
    for axes, r, degree in zip(panels, orders, degrees, strict=True):
        polygon(axes, points, QUIET, ".", ":")
        curve(axes, points, SECOND, width=5)
        polygon(axes, numeric.elevate(points, r), FIRST, "o", "-", size=4, filled=True)
        axes.set_title(f"degree {degree}")
    listed = ", ".join(map(str, degrees))
    figure.set_label(
        f"The polygons of one curve in the degrees {listed}, over its polygon of degree {len(points) - 1}: "
        "they cut corners, and slowly they come near the curve."
    )
    return figure


@mpl.rc_context(STYLE)
def two_ways(points, rounds=6):
    """How far the polygon is from the curve, against the number of edges: degrees raised, or pieces halved."""
    n = len(points) - 1
    edges = [n * 2**k for k in range(rounds)]
    floats = np.asarray(points, dtype=float)
    by_degree = [numeric.polygon_gap(numeric.elevate(floats, count - n)) for count in edges]
    by_halving = [numeric.polygon_gap(numeric.subdivide(floats, k)).max() for k in range(rounds)]
    figure = Figure(figsize=(7, 4.4), layout="constrained")
    axes = figure.subplots()
    axes.loglog(edges, by_degree, color=FIRST, marker="o", label="degree raised")
    axes.loglog(edges, by_halving, color=SECOND, linestyle="--", marker="s", label="pieces halved")
    axes.set(xlabel="edges", ylabel="distance", xticks=edges, xticklabels=list(map(str, edges)))
    axes.minorticks_off()
    axes.legend(loc="best")
    figure.set_label(
        f"Distance from polygon to curve against the number of edges, {edges[0]} to {edges[-1]}, both axes "
        f"logarithmic: from {by_degree[0]:.2g} it falls to {by_degree[-1]:.2g} by raising the degree, a half for each "
        f"doubling, and to {by_halving[-1]:.2g} by halving, a quarter for each."
    )
    return figure


@mpl.rc_context(STYLE)
def lowered(points):
    """A curve and the nearest one with a degree less, with both polygons."""
    nearest = numeric.lower(points)
    n = len(points) - 1
    figure, (axes,) = _panels(1, np.concatenate([points, nearest]))
    polygon(axes, points, QUIET, "s", ":", width=2)
    polygon(axes, nearest, INK, "o", ":", width=1.2)
    curve(axes, points, FIRST, width=4, label=f"degree {n}")
    curve(axes, nearest, SECOND, dash="--", label=f"nearest of degree {n - 1}")
    figure.legend(loc="outside lower center", ncols=2)
    ends = numeric.evaluate(nearest, [0, 1])
    figure.set_label(
        f"A curve of degree {n} from {point(points[0])} to {point(points[-1])} and the nearest one of degree {n - 1}, "
        f"with the control points {', '.join(map(point, nearest))}: it runs from {point(ends[0])} to {point(ends[1])}."
    )
    return figure


def _panels(count, points):
    """A figure with panels, two a row, with equal scales and room for names around the points."""
    places = np.asarray(points, dtype=float)
    low, high = places.min(axis=0), places.max(axis=0)
    room = 0.24 * max(high - low)
    width, height = high - low + 2 * room
    columns = min(count, 2)
    rows, across = -(-count // columns), 5.6 if count == 1 else 4.0
    figure = Figure(figsize=(across * columns, rows * (across * height / width + 0.5)), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels:
        axes.set(xlim=(low[0] - room, high[0] + room), ylim=(low[1] - room, high[1] + room), aspect="equal")
        axes.locator_params(nbins=7)
    for axes in panels[count:]:
        axes.set_axis_off()
    return figure, panels[:count]
