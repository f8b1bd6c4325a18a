"""Pictures of what numbers say of a curve: two bases, equal steps of t, a fit to samples, a small change."""

from fractions import Fraction

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, frame, names, outer_normal, polygon, word
from .style import SAMPLES, STYLE


@mpl.rc_context(STYLE)
def two_bases(points):
    """One curve twice: left with its power coefficients a_0, a_1, ... as points, right with its control points.

    Source: games, "power basis" and "Bernstein basis": the coefficient points and the curve.
    """
    coefficients = numeric.to_power(points)
    width, height = _room([*coefficients, *points])
    figure = Figure(figsize=(10.4, 1 + 4.6 * min(height / width, 1)), layout="constrained")
    sides = zip(figure.subplots(1, 2), (coefficients, points), ("a", "b"), strict=True)
    for axes, numbers, letter in sides:
        polygon(axes, numbers, QUIET, "s" if letter == "a" else "o", ":")
        curve(axes, points, FIRST)
        names(axes, numbers, [f"${letter}_{{{i}}}$" for i in range(len(numbers))])
        axes.set_title("coefficients of $1, t, t^2, ...$" if letter == "a" else "control points")
        frame(axes, [*coefficients, *points], 0.2)
    figure.set_label(
        f"One curve, twice. Left with its coefficients of the powers as points, {_listed(coefficients)}. "
        f"Right with its control points, {_listed(points)}: it starts at the first and ends at the last."
    )
    return figure


@mpl.rc_context(STYLE)
def clock(points, count=8):
    """A curve with its points at t = 0, 1/count, ..., 1: where it runs fast they are far apart."""
    times = [Fraction(k, count) for k in range(count + 1)]
    places = numeric.evaluate(points, times)
    figure = Figure(figsize=(7, 5), layout="constrained")
    axes = figure.subplots()
    curve(axes, points, FIRST)
    x, y = np.asarray(places, dtype=float).T
    axes.plot(x, y, linestyle="", marker="o", color=INK, markersize=8)
    for t, place in zip(times, np.asarray(places, dtype=float), strict=True):
        word(axes, place, number(t), outer_normal(points, t))
    frame(axes, [*places], 0.2)
    told = ", ".join(f"{point(place)} at t = {number(t)}" for t, place in zip(times, places, strict=True))
    figure.set_label(f"A curve with dots at equal steps of t: {told}.")
    return figure


@mpl.rc_context(STYLE)
def fitted(data, points, parameters=None):
    """Samples, a curve with its control polygon, and the way from each sample D_i to p(t_i).

    Without ``parameters`` the t_i are evenly spaced, as in ``numeric.fit``.
    """
    times = [Fraction(i, len(data) - 1) for i in range(len(data))] if parameters is None else parameters
    places = numeric.evaluate(points, times)
    figure = Figure(figsize=(7, 5), layout="constrained")
    axes = figure.subplots()
    polygon(axes, points, QUIET, "o", ":")
    curve(axes, points, FIRST, label="the curve")
    for sample, place in zip(np.asarray(data, dtype=float), np.asarray(places, dtype=float), strict=True):
        axes.plot(*zip(sample, place, strict=True), color=INK, linewidth=1.6)
    x, y = np.asarray(data, dtype=float).T
    axes.plot(x, y, linestyle="", marker="x", color=SECOND, markersize=11, markeredgewidth=2.5, label="samples")
    names(axes, points, [f"$b_{{{i}}}$" for i in range(len(points))])
    frame(axes, [*data, *points], 0.2)
    figure.legend(loc="outside lower center", ncols=2)
    missed = max(np.hypot(*(np.asarray(places, dtype=float) - np.asarray(data, dtype=float)).T))
    figure.set_label(
        f"{len(data)} samples as crosses, and the curve of degree {len(points) - 1} with the control points "
        f"{_listed(points)}. The largest distance of a sample from its point of the curve is {missed:.3g}."
    )
    return figure


@mpl.rc_context(STYLE)
def nudged(heights, part=Fraction(1, 100)):
    """One graph in two panels: left each power coefficient in turn is changed by a part of itself, right each height.

    The changed graphs are dashed. ``heights`` are the Bernstein coefficients; on the right each is moved by the part
    of the largest one.
    """
    coefficients = numeric.to_power(heights)
    step = max(map(abs, heights)) * part
    ways = (
        ("power coefficients", [numeric.from_power(row) for row in _changed(coefficients, part * coefficients)]),
        ("Bernstein coefficients", _changed(np.array(heights, object), step * np.ones(len(heights), object))),
    )
    figure = Figure(figsize=(10.4, 4.8), layout="constrained")
    t = np.linspace(0, 1, SAMPLES)
    reach = []
    for axes, (name, rows) in zip(figure.subplots(1, 2, sharey=True), ways, strict=True):
        original = numeric.sample(np.asarray(heights, dtype=float), SAMPLES)
        values = [numeric.sample(np.asarray(row, dtype=float), SAMPLES) for row in rows]
        for some in values:
            axes.plot(t, some, color=SECOND, linestyle="--", linewidth=1.6)
        axes.plot(t, original, color=FIRST, linewidth=3)
        axes.set(title=f"{name}, {number(part * 100)} %", xlabel="t", xticks=[0, 0.5, 1], xticklabels=["0", "1/2", "1"])
        reach.append(max(np.abs(some - original).max() for some in values))
    figure.set_label(
        f"The graph of a polynomial of degree {len(heights) - 1}, with heights up to {number(max(map(abs, heights)))}. "
        f"Left each power coefficient in turn is changed by {number(part * 100)} percent: the graph moves by up to "
        f"{reach[0]:.3g}, most at t = 1. Right each Bernstein coefficient is moved by {number(part * 100)} percent of "
        f"the largest: the graph moves by at most {reach[1]:.3g}."
    )
    return figure


def _changed(numbers, steps):
    """The numbers with one of them changed, for each of them that changes."""
    return [numbers + step * unit for step, unit in zip(steps, np.eye(len(numbers), dtype=int), strict=True) if step]


def _room(points):
    """Width and height of a frame around points, with a fifth of the greater extent on each side."""
    extent = np.ptp(np.asarray(points, dtype=float), axis=0)
    return extent + 0.4 * max(extent)


def _listed(points):
    return ", ".join(map(point, points))
