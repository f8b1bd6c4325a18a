"""The lessons' pictures: data in, a matplotlib ``Figure`` out, whose label is its alternative text.

Every picture reads on a projector and in greyscale: what a colour tells, a dash or a marker tells too. Points are rows
of two numbers, exact or not. ``show`` puts a figure into a notebook as PNG and SVG, the same bytes from run to run.
"""

from html import escape
from io import BytesIO, StringIO

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from . import numeric
from .display import number, point
from .palette import FIRST, INK, QUIET, SECOND

LEVEL_MARKERS = "osD^v<>ph*"
STYLE = {
    "font.size": 14,
    "axes.titlesize": 15,
    "lines.linewidth": 2.5,
    "lines.markersize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "svg.hashsalt": "bezteach",
    "svg.fonttype": "path",
}
SAMPLES = 65
LINES = [(FIRST, "-"), (SECOND, "--"), (INK, "-."), (FIRST, ":"), (SECOND, (0, (6, 2, 1, 2, 1, 2))), (INK, (0, (1, 1)))]


def show(figure):
    """Display a figure in a notebook as PNG and SVG with its alternative text."""
    from IPython.display import display

    alt = figure.get_label()
    png, svg = BytesIO(), StringIO()
    with mpl.rc_context(STYLE):
        figure.savefig(png, format="png", dpi=96)
        figure.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
    picture = svg.getvalue().replace("<svg ", f'<svg role="img" aria-label="{escape(alt)}" ', 1)
    bundle = {"text/plain": alt, "image/png": png.getvalue(), "image/svg+xml": picture}
    display(bundle, raw=True, metadata={"image/png": {"alt": alt}})


@mpl.rc_context(STYLE)
def triangle(points, t):
    """De Casteljau's construction at t, growing by a level from panel to panel; new points carry their coordinates."""
    levels = numeric.de_casteljau(points, t)
    figure, panels = _panels(len(levels), points)
    for last, axes in enumerate(panels):
        for k, level in enumerate(levels[: last + 1]):
            newest = k == last
            _polygon(
                axes, level, INK if newest else QUIET, LEVEL_MARKERS[k % 10], "-" if newest else ":", filled=newest
            )
        _names(axes, levels[last], list(map(point, levels[last])), _rising(levels[last - 1]))
        axes.set_title(f"level {last}" if last else "the polygon")
    _curve(panels[-1], points, FIRST)
    found = ", ".join(point(p) for p in levels[-1])
    figure.set_label(
        f"De Casteljau's construction at t = {number(t)} in {len(levels)} pictures, a level more in each: "
        f"every edge is cut in the same ratio, down to the one point {found} of the curve."
    )
    return figure


@mpl.rc_context(STYLE)
def split(points, t):
    """The two halves of a curve cut at t with their control polygons, over the polygon of the whole."""
    left, right = numeric.split(points, t)
    figure, (axes,) = _panels(1, points)
    _polygon(axes, points, QUIET, ".", ":", name="b")
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
    _polygon(axes, points, QUIET, ".", ":", name="b")
    _curve(axes, points, QUIET)
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
        _curve(axes, points, QUIET, width=5)
        for number_of_piece, piece in enumerate(numeric.subdivide(points, depth)):
            _polygon(axes, piece, (FIRST, SECOND)[number_of_piece % 2], "os"[number_of_piece % 2], "-", size=5)
        axes.set_title(f"{2**depth} piece{'s' if depth else ''}")
    pieces = ", ".join(str(2**depth) for depth in depths)
    figure.set_label(f"The control polygons of a curve in {pieces} pieces: at each halving they hug the curve closer.")
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
def graphs(polynomials):
    """Polynomials over [0, 1]: {name: Bernstein coefficients}, each in a dash of its own."""
    figure, axes = _unit_square()
    for place, (name, coefficients) in enumerate(polynomials.items()):
        _graph(axes, coefficients, place, label=name)
    axes.axhline(0, color=QUIET, linewidth=1)
    figure.legend(loc="outside right upper")
    figure.set_label(f"Graphs over [0, 1] of {', '.join(polynomials)}.")
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
    _polygon(axes, points, colour, marker, dash, width=1.4)
    _curve(axes, points, colour, dash=dash, width=4, label=label)


def _polygon(axes, points, colour, marker, dash, *, name=None, width=1.6, size=8, filled=False):
    x, y = np.asarray(points, dtype=float).T
    inside = colour if filled else "white"
    axes.plot(x, y, dash, color=colour, linewidth=width, marker=marker, markersize=size, markerfacecolor=inside)
    if name is not None:
        _names(axes, points, [f"${name}_{{{i}}}$" for i in range(len(points))], np.array([0.0, 1.0]))


def _curve(axes, points, colour, *, dash="-", width=3.0, label=None):
    x, y = numeric.sample(np.asarray(points, dtype=float), SAMPLES).T
    axes.plot(x, y, color=colour, linestyle=dash, linewidth=width, label=label, zorder=1.9)


def _names(axes, points, names, alone):
    """Write a name beside each point, away from its neighbours; ``alone`` is the way for a point that has none."""
    places = np.asarray(points, dtype=float)
    for i, (place, name) in enumerate(zip(places, names, strict=True)):
        neighbours = [places[j] for j in (i - 1, i + 1) if 0 <= j < len(places)]
        away = place - np.mean(neighbours, axis=0) if neighbours else alone
        away = away / (np.hypot(*away) or 1.0)
        axes.annotate(
            name,
            place,
            xytext=14 * away,
            textcoords="offset points",
            ha="center" if abs(away[0]) < 0.35 else "left" if away[0] > 0 else "right",
            va="center" if abs(away[1]) < 0.35 else "bottom" if away[1] > 0 else "top",
            bbox={"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )


def _rising(points):
    """The normal of the way from the first point to the last that points to the left of it."""
    x, y = np.asarray(points[-1], dtype=float) - np.asarray(points[0], dtype=float)
    return np.array([-y, x])


def _listed(points):
    return ", ".join(map(point, points))
