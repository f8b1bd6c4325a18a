"""Pictures of B-spline functions over their knots, and of the recursion that makes them."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from ..display import number
from ..numeric import bspline
from ..palette import FIRST, INK, QUIET, SECOND
from .functions import LINES
from .style import STYLE

LIGHT = "#e3e8ee"  # a domain, or a hull
PALE = "#c4c4c4"  # a sum under its two terms
STACK = 0.13  # from a knot down to the next one of its stack, where a function reaches up to 1
EDGES = 8  # of a function on a span, for each degree
STILL = 1e-9  # a function that changes less at a knot does not jump


@mpl.rc_context(STYLE)
def spline_basis(knots, degree):
    """The B-splines of a degree over their knots, their sum dotted, the domain shaded; equal knots hang in a stack."""
    figure = Figure(figsize=(8.6, 4.4), layout="constrained")
    axes = figure.subplots()
    count = len(knots) - degree - 1
    first, last = knots[degree], knots[count]
    axes.axvspan(float(first), float(last), color=LIGHT, linewidth=0)
    pieces = _pieces(knots, degree)
    for i in range(count):
        t, values = _joined(pieces, i, i + degree + 1)
        colour, dash = LINES[i % len(LINES)]
        axes.plot(t, values[:, i], color=colour, linestyle=dash)
        top = np.nanargmax(values[:, i])
        axes.annotate(
            f"$N_{{{i},{degree}}}$",
            (t[top], values[top, i]),
            xytext=(0, 5 if values[top, i] > 0.99 else -19),
            textcoords="offset points",
            ha="center",
        )
    t, values = _joined(pieces, 0, len(knots) - 1)
    axes.plot(t, values.sum(axis=1), color=INK, linestyle=(0, (1, 2)), linewidth=1.8, label="sum")
    knots_under(axes, knots)
    axes.set_ylim(top=1.18)
    figure.legend(loc="outside right upper")
    figure.set_label(
        f"{count} B-splines of degree {degree} over the knots {', '.join(map(number, knots))}, each above 0 over "
        f"{degree + 1} neighbouring spans and 0 elsewhere. Their sum is 1 on the shaded domain from {number(first)} to "
        f"{number(last)}."
    )
    return figure


@mpl.rc_context(STYLE)
def recursion(knots):
    """One B-spline over all the knots from two of one degree less, and so on down to degree 0, each in a panel.

    The two terms of the recursion are dashed and dotted, their sum is the broad pale line.
    """
    degree = len(knots) - 2
    figure = Figure(figsize=(10.4, 1.9 * (degree + 1)), layout="constrained")
    grid = figure.add_gridspec(degree + 1, 2 * (degree + 1))
    for p in range(degree + 1):
        lower = _pieces(knots, p - 1) if p else None
        for i in range(degree + 1 - p):
            axes = figure.add_subplot(grid[p, p + 2 * i : p + 2 * i + 2])
            if p:
                for k, (colour, dash), share in ((i, (FIRST, "--"), _rise), (i + 1, (SECOND, ":"), _fall)):
                    t, values = _joined(lower, 0, len(knots) - 1)
                    here = (t >= float(knots[k])) & (t <= float(knots[k + p]))
                    axes.plot(t[here], (share(t, knots, k, p) * values[:, k])[here], color=colour, linestyle=dash)
            t, values = _joined(_pieces(knots, p), 0, len(knots) - 1)
            axes.plot(t, values[:, i], color=PALE if p else INK, linewidth=7 if p else 2.5, zorder=1.5)
            axes.set(ylim=(-0.06, 1.08), yticks=[0, 1], xticks=sorted({float(knot) for knot in knots}))
            axes.set_title(f"$N_{{{i},{p}}}$", pad=3)
    figure.set_label(
        f"A triangle of panels over the knots {', '.join(map(number, knots))}: {degree + 1} functions of degree 0, "
        f"each 1 on one span; below each two neighbours the function of one degree more that they make, with its two "
        f"terms dashed and dotted; at the bottom N_(0,{degree}) alone."
    )
    return figure


def _pieces(knots, degree):
    """For each span that is not empty its index, parameters and the values of all functions there."""
    ends = np.asarray(knots, dtype=float)
    found = []
    for k in np.flatnonzero(ends[1:] > ends[:-1]):
        t = np.linspace(ends[k], ends[k + 1], EDGES * max(degree, 1) + 1)
        found.append((k, t, bspline.basis(ends, degree, t, span=int(k))))
    return found


def _joined(pieces, low, high):
    """Parameters and values on the spans low, ..., high - 1, with a gap where one of the functions jumps."""
    t, values = np.empty(0), np.empty((0, pieces[0][2].shape[1]))
    for k, places, rows in pieces:
        if low <= k < high:
            if len(t) and np.abs(values[-1] - rows[0]).max() > STILL:
                t, values = np.append(t, places[0]), np.vstack([values, np.full(rows.shape[1], np.nan)])
            t, values = np.append(t, places), np.vstack([values, rows])
    return t, values


def _rise(t, knots, k, p):
    """The factor before N_{k,p-1} in the recursion of N_{k,p}."""
    low, high = float(knots[k]), float(knots[k + p])
    return (t - low) / (high - low) if high > low else 0 * t


def _fall(t, knots, k, p):
    """The factor before N_{k,p-1} in the recursion of N_{k-1,p}."""
    return 1 - _rise(t, knots, k, p) if knots[k + p] > knots[k] else 0 * t


def knots_under(axes, knots):
    """Knots under the axis, equal ones in a stack, with their values as ticks."""
    low = -0.09
    values, times = bspline.multiplicities(list(knots))
    for value, count in zip(values, times, strict=True):
        axes.plot([float(value)] * count, low - STACK * np.arange(count), "^", color=INK, markersize=7, clip_on=False)
    axes.axhline(0, color=QUIET, linewidth=1)
    axes.set(xticks=[float(value) for value in values], xticklabels=[number(value) for value in values], xlabel="t")
    axes.set_ylim(bottom=low - STACK * max(times))
    if axes.get_yticks().size:
        axes.set_yticks([0, 0.5, 1], ["0", "1/2", "1"])
