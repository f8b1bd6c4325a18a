"""Pictures of a curve's shape: dots at equal steps of t, one control point moved, graphs over their polygons."""

from fractions import Fraction

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, frame, polygon, word
from .style import SAMPLES, STYLE

PLACES = (Fraction(1, 10), Fraction(1, 3), Fraction(3, 5), Fraction(9, 10))
QUARTERS = ["0", "1/4", "1/2", "3/4", "1"]


@mpl.rc_context(STYLE)
def beads(curves, count=8):
    """Curves with a dot at t = 0, 1/count, ..., 1 each: where the dots are dense, the point is slow.

    ``curves`` maps a title to control points. Source: deck, 1.2, property 7 of the curve, and its counterpart.
    """
    figure = Figure(figsize=(5.2 * len(curves), 3.6), layout="constrained")
    for axes, (title, points) in zip(figure.subplots(1, len(curves), squeeze=False)[0], curves.items(), strict=True):
        polygon(axes, points, QUIET, "s", ":", size=11)
        curve(axes, points, FIRST)
        x, y = _floats(numeric.evaluate(points, [Fraction(k, count) for k in range(count + 1)])).T
        axes.plot(x, y, "o", color=INK, markersize=7)
        axes.set_title(title)
        frame(axes, points, 0.14)
    half = ", ".join(f"{title}: {point(numeric.evaluate(points, Fraction(1, 2)))}" for title, points in curves.items())
    figure.set_label(f"Curves with dots at t = 0, 1/{count}, ..., 1. Where they are at t = 1/2: {half}.")
    return figure


@mpl.rc_context(STYLE)
def moved(points, j, v, places=PLACES):
    """A curve before and after its control point j moved by the vector v, with the way of some of its points.

    Source: deck, 1.2, property 9 of the curve.
    """
    old = np.array(points, dtype=object)
    new = np.array([p + np.array(v, dtype=object) * int(i == j) for i, p in enumerate(old)])
    figure = Figure(figsize=(7.4, 5.4), layout="constrained")
    axes = figure.subplots()
    polygon(axes, old, QUIET, "s", ":")
    polygon(axes, new, QUIET, "s", "--")
    curve(axes, old, FIRST, label="before")
    curve(axes, new, SECOND, dash="--", label="after")
    _arrow(axes, old[j], new[j])
    for t in places:
        here = numeric.evaluate(old, t)
        _arrow(axes, here, numeric.evaluate(new, t))
        word(axes, _floats(here), f"t = {number(t)}", _behind(_floats(numeric.derivative(old, t)), _floats(v)))
    frame(axes, [*old, *new], 0.14)
    figure.legend(loc="outside lower center", ncols=2)
    factors = numeric.bernstein(len(points) - 1, list(places))[:, j]
    ways = ", ".join(f"{number(factor)} at t = {number(t)}" for t, factor in zip(places, factors, strict=True))
    figure.set_label(
        f"A curve of degree {len(points) - 1} before and after control point {j} moved by {point(v)}: every point but "
        f"the ends moves the same way, not equally far. Parts of the whole way: {ways}."
    )
    return figure


@mpl.rc_context(STYLE)
def heights(functions):
    """Graphs over [0, 1] in panels, each over the polygon of its Bernstein coefficients.

    ``functions`` maps a title to coefficients. Source: deck, 1.2, note on the convexity theorem.
    """
    figure = Figure(figsize=(10.4, 3.4 * -(-len(functions) // 2)), layout="constrained")
    panels = figure.subplots(-(-len(functions) // 2), 2, squeeze=False, sharex=True, sharey=True).ravel()
    for axes, (title, coefficients) in zip(panels, functions.items(), strict=False):
        places = np.linspace(0, 1, len(coefficients))
        polygon(axes, np.column_stack([places, _floats(coefficients)]), QUIET, "s", ":")
        graph = numeric.sample(_floats(coefficients), SAMPLES)
        axes.plot(np.linspace(0, 1, SAMPLES), graph, color=FIRST, linewidth=3)
        axes.axhline(0, color=QUIET, linewidth=1, zorder=0.5)
        axes.set(title=title, xticks=np.linspace(0, 1, 5), xticklabels=QUARTERS)
    for axes in panels[len(functions) :]:
        axes.set_axis_off()
    told = "; ".join(f"{title}: {', '.join(map(number, values))}" for title, values in functions.items())
    figure.set_label(f"Graphs over [0, 1] with the polygons of their heights at equal steps. {told}.")
    return figure


def _behind(tangent, v):
    """The normal of a tangent that points away from the vector v."""
    x, y = tangent
    normal = np.array([-y, x])
    return -normal if normal @ v > 0 else normal


def _arrow(axes, start, tip):
    arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 16}
    axes.annotate("", _floats(tip), _floats(start), arrowprops=arrow)


def _floats(values):
    return np.asarray(values, dtype=float)
