"""Rational curves: beside the polynomial one of the same points, as a shadow from space, and with a growing weight."""

from fractions import Fraction

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..numeric import bspline, rational
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, frame, names, polygon, word
from .style import SAMPLES, STYLE

STEPS = tuple(Fraction(k, 4) for k in range(5))
OBLIQUE = np.array([[1.1, -0.55], [0.9, 0.4], [0.0, 1.5]])  # where the unit vectors of x, y and w are drawn
DASHES = ("-", (0, (6, 2)), (0, (6, 2, 1, 2)), (0, (2, 1.5)), (0, (1, 2.5)))


@mpl.rc_context(STYLE)
def quarter(points, weights):
    """The curve with these weights beside that with equal ones, with dots at equal steps of t, and the unit circle."""
    figure = Figure(figsize=(5.6, 5.4), layout="constrained")
    axes = figure.subplots()
    _circle(axes)
    polygon(axes, points, QUIET, "s", "-", width=1.2)
    curve(axes, points, SECOND, dash="--", label="equal weights")
    _weighted(axes, points, weights, FIRST, "-", f"weights {_listed(weights)}")
    places = {"o": rational.evaluate(points, weights, STEPS), "D": numeric.evaluate(points, STEPS)}
    for marker, found in places.items():
        x, y = np.asarray(found, dtype=float).T
        colour = FIRST if marker == "o" else SECOND
        axes.plot(x, y, marker, color=colour, markerfacecolor="white", markersize=7, zorder=3)
    for t, place in list(zip(STEPS, places["o"], strict=True))[1:-1]:
        place = np.asarray(place, dtype=float)
        word(axes, place, number(t), -place)
    frame(axes, [*points, *(place for found in places.values() for place in found)], 0.12)
    figure.legend(loc="outside upper center", ncols=3, fontsize=12)
    said = ", ".join(f"{point(place)} at t = {number(t)}" for t, place in zip(STEPS, places["o"], strict=True))
    figure.set_label(
        f"The control points {', '.join(map(point, points))}: the curve with the weights {_listed(weights)} lies on "
        f"the unit circle and passes {said}; that with equal weights bulges out of it."
        if rational.on_unit_circle(points, weights)
        else f"The control points {', '.join(map(point, points))}: the curve with the weights {_listed(weights)} "
        f"passes {said}; dashed that with equal weights, dotted the unit circle."
    )
    return figure


@mpl.rc_context(STYLE)
def projection(points, weights, t=Fraction(1, 2)):
    """The lifted points (w x, w y, w) and their curve in space, seen from the origin on the plane w = 1.

    Source: Farin, Curves and Surfaces for CAGD: a rational curve as the projection of a polynomial one.
    """
    above = rational.lift(points, weights)
    there = numeric.evaluate(above, t)
    place = rational.project(there)
    figure = Figure(figsize=(8.6, 6.6), layout="constrained")
    axes = figure.subplots()
    low, high = np.asarray(points, dtype=float).min(axis=0) - 0.35, np.asarray(points, dtype=float).max(axis=0) + 0.35
    sheet = [(low[0], low[1], 1), (high[0], low[1], 1), (high[0], high[1], 1), (low[0], high[1], 1)]
    axes.fill(*_drawn(sheet).T, facecolor=QUIET, alpha=0.16, edgecolor=QUIET, zorder=0)
    word(axes, _drawn([sheet[1]])[0], "w = 1", np.array([1.0, -0.6]))
    for x, y, w in (*above, there):
        top = max(float(w), 1.0) / float(w)  # a ray goes on to the plane if the point is below it
        axes.plot(*_drawn([(0, 0, 0), (top * x, top * y, top * w)]).T, color=QUIET, linewidth=1.1, zorder=0.5)
    shadow = [(x, y, 1) for x, y in rational.evaluate(points, weights, np.linspace(0, 1, SAMPLES)).tolist()]
    axes.plot(*_drawn(numeric.sample(np.asarray(above, dtype=float), SAMPLES)).T, "--", color=SECOND, linewidth=3.5)
    axes.plot(*_drawn(shadow).T, color=FIRST, linewidth=4)
    _corners(axes, above, SECOND, ":")
    _corners(axes, [(*b, 1) for b in points], FIRST, "-")
    for dot, colour in (((*place, 1), FIRST), (there, SECOND)):
        axes.plot(*_drawn([dot])[0], "o", color=colour, markersize=11, zorder=4)
    axes.plot(0, 0, "o", color=INK, markersize=8)
    word(axes, np.zeros(2), "origin", np.array([-1.0, -0.6]))
    for i, (b, raised) in enumerate(zip(points, above, strict=True)):
        same = raised[-1] == 1
        word(axes, _drawn([(*b, 1)])[0], f"$b_{{{i}}}$", np.array([0.6, -1.0] if i < len(points) - 1 else [-1.0, 0.2]))
        if not same:
            word(axes, _drawn([raised])[0], rf"${number(weights[i])}\,(b_{{{i}}}, 1)$", np.array([0.3, 1.0]))
    axes.set_aspect("equal")
    axes.axis("off")
    axes.margins(0.09)
    figure.set_label(
        f"The control points {', '.join(map(point, points))} with the weights {_listed(weights)} are lifted to "
        f"{', '.join(map(point, above))}. Rays from the origin lead through them to the plane w = 1. The dashed curve "
        f"in space is a polynomial one; its point {point(there)} at t = {number(t)} is seen on the plane at "
        f"{point(place)}, on the rational curve."
    )
    return figure


@mpl.rc_context(STYLE)
def pulled(points, weights, of, values, t=Fraction(1, 2)):
    """Curves of the same points, the weight of b_of one of ``values``, and the straight way that the point at t goes.

    The values are in rising order, at most five.
    """
    if len(values) > len(DASHES):
        raise ValueError(f"{len(values)} values of one weight: at most {len(DASHES)} can be told apart")
    figure = Figure(figsize=(8.4, 5.2), layout="constrained")
    axes = figure.subplots()
    polygon(axes, points, QUIET, "s", "-", width=1.2)
    places = []
    for value, dash in zip(values, DASHES, strict=False):
        now = [*weights[:of], value, *weights[of + 1 :]]
        _weighted(axes, points, now, FIRST, dash, number(value))
        places.append(rational.evaluate(points, now, t))
    x, y = np.asarray([*places, points[of]], dtype=float).T
    axes.plot(x, y, ":", color=INK, linewidth=1.4, zorder=2.5)
    axes.plot(x[:-1], y[:-1], "o", color=INK, markersize=7, zorder=3)
    names(axes, points, [f"$b_{{{i}}}$" for i in range(len(points))])
    frame(axes, [*points, *places], 0.12)
    figure.legend(loc="outside right center", title=f"weight of $b_{{{of}}}$", handlelength=4)
    said = ", ".join(f"{point(place)} for {number(value)}" for place, value in zip(places, values, strict=True))
    figure.set_label(
        f"The control points {', '.join(map(point, points))} with the weight of b_{of} growing. The point at "
        f"t = {number(t)} goes straight towards b_{of}: {said}."
    )
    return figure


@mpl.rc_context(STYLE)
def nurbs(points, weights, knots):
    """A rational B-spline curve in the plane: its control points with their weights, its knots on the curve."""
    figure = Figure(figsize=(5.6, 5.4), layout="constrained")
    axes = figure.subplots()
    above = rational.lift(points, weights)
    degree = len(knots) - len(points) - 1
    start, end = Fraction(knots[degree]), Fraction(knots[len(points)])
    along = [start + (end - start) * Fraction(k, 128) for k in range(129)]
    x, y = np.asarray(rational.project(bspline.evaluate(above, knots, along)), dtype=float).T
    polygon(axes, points, QUIET, "s", "--", width=1.4)
    axes.plot(x, y, color=FIRST, linewidth=4, zorder=2)
    breaks = sorted({Fraction(knot) for knot in knots if start <= knot < end})
    joins = np.asarray(rational.project(bspline.evaluate(above, knots, breaks)), dtype=float)
    axes.plot(*joins.T, "o", color=INK, markerfacecolor="white", markersize=9, zorder=3)
    for place, knot in zip(joins, breaks, strict=True):
        word(axes, place, f"t = {number(knot)}", -place)
    for place, weight in {tuple(b): weight for b, weight in zip(points, weights, strict=True)}.items():
        word(axes, place, f"w = {number(weight)}", np.asarray(place, dtype=float))
    frame(axes, points, 0.28)
    figure.set_label(
        f"A rational B-spline curve of degree {degree} with the control points {', '.join(map(point, points))}, the "
        f"weights {_listed(weights)} and the knots {_listed(knots)}; its pieces meet at "
        f"{', '.join(map(point, rational.project(bspline.evaluate(above, knots, breaks))))}."
    )
    return figure


def _circle(axes):
    turn = np.linspace(0, 2 * np.pi, 2 * SAMPLES)
    axes.plot(np.cos(turn), np.sin(turn), ":", color=INK, linewidth=1.4, label="unit circle")


def _weighted(axes, points, weights, colour, dash, label):
    x, y = np.asarray(rational.evaluate(points, weights, [Fraction(k, 96) for k in range(97)]), dtype=float).T
    axes.plot(x, y, color=colour, linestyle=dash, linewidth=3.5, label=label, zorder=2)


def _corners(axes, places, colour, dash):
    x, y = _drawn(places).T
    axes.plot(x, y, dash, color=colour, linewidth=1.6, marker="s", markersize=8, markerfacecolor="white", zorder=3)


def _drawn(places):
    """Where points (x, y, w) of space are drawn."""
    return np.asarray(places, dtype=float) @ OBLIQUE


def _listed(values):
    return ", ".join(map(number, values))
