"""Graphs of functions over [0, 1], the Bernstein basis among them, and of numbers that decay."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number
from ..palette import FIRST, INK, QUIET, SECOND
from .style import SAMPLES, STYLE

LINES = [(FIRST, "-"), (SECOND, "--"), (INK, "-."), (FIRST, ":"), (SECOND, (0, (6, 2, 1, 2, 1, 2))), (INK, (0, (1, 1)))]


@mpl.rc_context(STYLE)
def basis(n):
    """The n+1 Bernstein functions of degree n over [0, 1], each with its name at its greatest value, at i/n."""
    figure, axes = _unit_square()
    for i, row in enumerate(np.eye(n + 1)):
        place = i / max(n, 1)
        height = float(numeric.evaluate(row, place))
        _graph(axes, row, i)
        axes.plot(place, height, "o", color=LINES[i % len(LINES)][0], markersize=6)
        axes.annotate(f"$B_{{{i},{n}}}$", (place, height), xytext=(0, 7), textcoords="offset points", ha="center")
    axes.set_ylim(0, 1.12)
    figure.set_label(
        f"The {n + 1} Bernstein functions of degree {n}: humps side by side, none negative, the one with index i "
        f"greatest at i/{n}; only the first and the last reach 1."
    )
    return figure


@mpl.rc_context(STYLE)
def bases(degrees):
    """The Bernstein functions of several degrees over [0, 1], a panel a degree, at most three a row."""
    columns = min(len(degrees), 3)
    rows = -(-len(degrees) // columns)
    figure = Figure(figsize=(3.5 * columns, 2.7 * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False, sharey=True).ravel()
    for axes, n in zip(panels, degrees, strict=False):
        for i, row in enumerate(np.eye(n + 1)):
            _graph(axes, row, i)
        axes.set(title=f"degree {n}", xticks=[0, 0.5, 1], xticklabels=["0", "1/2", "1"], ylim=(0, 1.04))
    for axes in panels[len(degrees) :]:
        axes.set_axis_off()
    counted = "; ".join(f"degree {n}, {n + 1} function{'s' * (n > 0)}" for n in degrees)
    figure.set_label(f"The Bernstein functions over [0, 1], a panel a degree: {counted}.")
    return figure


@mpl.rc_context(STYLE)
def stacked(n):
    """The n+1 Bernstein functions of degree n on top of each other: at every t they fill the height 1."""
    figure, axes = _unit_square()
    t = np.linspace(0, 1, SAMPLES)
    values = numeric.bernstein(n, t)
    tops = np.cumsum(values, axis=1)
    for i in range(n + 1):
        shade = 0.95 - 0.35 * i / max(n, 1)
        axes.fill_between(t, tops[:, i] - values[:, i], tops[:, i], color=str(shade), edgecolor=INK, linewidth=1)
        middle = tops[:, i] - values[:, i] / 2
        at = min(max(round(i / max(n, 1) * (SAMPLES - 1)), 5), SAMPLES - 6)
        axes.annotate(f"$B_{{{i},{n}}}$", (t[at], middle[at]), ha="center", va="center")
    axes.set(xlim=(0, 1), ylim=(0, 1.02))
    figure.set_label(
        f"The {n + 1} Bernstein functions of degree {n} stacked: at every t they fill exactly the height 1."
    )
    return figure


@mpl.rc_context(STYLE)
def areas(n):
    """The areas under the n+1 Bernstein functions of degree n, a panel each; all are 1/(n+1)."""
    figure = Figure(figsize=(2.6 * (n + 1), 2.6), layout="constrained")
    t = np.linspace(0, 1, SAMPLES)
    for i, axes in enumerate(figure.subplots(1, n + 1, squeeze=False, sharey=True)[0]):
        axes.fill_between(t, numeric.sample(np.eye(n + 1)[i], SAMPLES), color=FIRST, alpha=0.3)
        _graph(axes, np.eye(n + 1)[i], 0)
        axes.set(title=f"$B_{{{i},{n}}}$: area 1/{n + 1}", xticks=[0, 1], yticks=[0, 1], ylim=(0, 1.02))
    figure.set_label(f"The areas under the {n + 1} Bernstein functions of degree {n}, over [0, 1]: each is 1/{n + 1}.")
    return figure


@mpl.rc_context(STYLE)
def graph(coefficients, name):
    """The graph of a polynomial over [0, 1] and the polygon of its Bernstein coefficients, above 0, 1/n, ..., 1."""
    figure, axes = _unit_square()
    places = np.linspace(0, 1, len(coefficients))
    axes.plot(
        places, np.asarray(coefficients, dtype=float), color=QUIET, linestyle=":", marker="o", markerfacecolor="white"
    )
    _graph(axes, coefficients, 0)
    axes.axhline(0, color=QUIET, linewidth=1)
    axes.set_title(name)
    listed = ", ".join(map(number, coefficients))
    figure.set_label(f"The graph of {name} over [0, 1], and its polygon with the heights {listed} at equal steps.")
    return figure


@mpl.rc_context(STYLE)
def graphs(polynomials):
    """Polynomials over [0, 1]: {name: Bernstein coefficients}, each in a dash of its own."""
    figure, axes = _unit_square()
    for place, (name, coefficients) in enumerate(polynomials.items()):
        _graph(axes, coefficients, place, label=name)
    axes.axhline(0, color=QUIET, linewidth=1)
    figure.legend(loc="outside right upper")
    figure.set_label(f"Graphs over [0, 1] of {', '.join(polynomials)}.")
    return figure


@mpl.rc_context(STYLE)
def decay(values, limit_ratio):
    """Positive numbers against 0, 1, 2, ... on a logarithmic scale, beside a line that falls by the ratio a step."""
    figure = Figure(figsize=(7, 4.2), layout="constrained")
    axes = figure.subplots()
    steps = range(len(values))
    sizes = [float(value) for value in values]
    guide = [sizes[0] * float(limit_ratio) ** k for k in steps]
    axes.semilogy(steps, guide, color=QUIET, linestyle="--", label=f"falling by {number(limit_ratio)} a halving")
    axes.semilogy(steps, sizes, color=FIRST, marker="o", label="measured")
    axes.set(xlabel="halvings", ylabel="distance", xticks=list(steps))
    axes.legend(loc="best")
    figure.set_label(
        f"Distance from polygon to curve after 0 to {len(sizes) - 1} halvings, {sizes[0]:.2g} down to {sizes[-1]:.2g}: "
        f"on a logarithmic scale it runs along the line that falls by {number(limit_ratio)} a halving."
    )
    return figure


def _unit_square():
    figure = Figure(figsize=(7, 4.2), layout="constrained")
    axes = figure.subplots()
    axes.set(
        xlim=(-0.06, 1.06), xlabel="t", xticks=[0, 0.25, 0.5, 0.75, 1], xticklabels=["0", "1/4", "1/2", "3/4", "1"]
    )
    return figure, axes


def _graph(axes, coefficients, place, label=None):
    colour, dash = LINES[place % len(LINES)]
    values = numeric.sample(np.asarray(coefficients, dtype=float), SAMPLES)
    axes.plot(np.linspace(0, 1, SAMPLES), values, color=colour, linestyle=dash, label=label)
