"""The curve with its velocity arrows, and beside it the plane of the vectors, in which the hodograph lives."""

from fractions import Fraction

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, frame, outer_normal, polygon, word
from .style import STYLE

PLACES = (Fraction(0), Fraction(1, 3), Fraction(2, 3), Fraction(1))


@mpl.rc_context(STYLE)
def hodograph(points, places=PLACES):
    """Left the curve with p'(t) / n at some places; right the p'(t) from one origin, their tips on the hodograph.

    The arrows on the left have an n-th of their length, so that those at the ends are the edges of the polygon.
    Source: deck, 2.2, hodograph: the difference vectors moved to the origin.
    """
    n = len(points) - 1
    edges = numeric.hodograph(points)
    starts = [numeric.evaluate(points, t) for t in places]
    arrows = [numeric.derivative(points, t) for t in places]
    figure = Figure(figsize=(10.4, 5.4), layout="constrained")
    plane, vectors = figure.subplots(1, 2)
    tips = list(np.asarray(starts, dtype=float) + np.asarray(arrows, dtype=float) / n)
    polygon(plane, points, QUIET, "s", ":")
    curve(plane, points, FIRST, width=3.5)
    _arrows(plane, starts, tips)
    _labels(plane, points, places)
    plane.set_title(f"the curve at some t, with p'(t) / {n}")
    for at in (vectors.axhline, vectors.axvline):
        at(0, color=QUIET, linewidth=1, zorder=0.5)
    polygon(vectors, edges, QUIET, "s", ":")
    curve(vectors, edges, SECOND, dash="--", width=3.5)
    origin = np.zeros(2)
    _arrows(vectors, [origin] * len(arrows), arrows)
    vectors.plot(0, 0, marker="o", color=INK, markersize=7)
    _labels(vectors, edges, places)
    vectors.set_title("the hodograph at the same t, with p'(t)")
    for axes, shown in ((plane, [*points, *tips]), (vectors, [*edges, origin])):
        frame(axes, shown, (0.26, 0.18))
    said = ", ".join(f"{point(arrow)} at t = {number(t)}" for t, arrow in _pairs(places, arrows))
    figure.set_label(
        f"Left a curve of degree {n} with its velocity arrows, drawn with 1/{n} of their length. Right the same arrows "
        f"from one origin: {said}. Their tips lie on the hodograph, whose control points are "
        f"{', '.join(map(point, edges))}."
    )
    return figure


def _pairs(one, other):
    return zip(one, other, strict=True)


def _arrows(axes, starts, tips):
    for start, tip in _pairs(starts, tips):
        start, tip = np.asarray(start, dtype=float), np.asarray(tip, dtype=float)
        if np.allclose(start, tip):
            axes.plot(*start, marker="o", color=INK, markersize=9)
            continue
        arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 18}
        axes.annotate("", tip, start, arrowprops=arrow)


def _labels(axes, points, places):
    """Write each t, the number alone, beside its point, on the side the curve bends away from, where names part."""
    for t in places:
        word(axes, np.asarray(numeric.evaluate(points, t), dtype=float), number(t), outer_normal(points, t))
