"""A board's marks as a matplotlib figure, for a handout."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from .. import numeric
from ..naming import outward
from ..palette import FIRST, INK, QUIET, SECOND
from .style import SAMPLES, STYLE

COLOURS = {"ink": INK, "first": FIRST, "second": SECOND, "quiet": QUIET, "paper": "white", "none": "none"}


@mpl.rc_context(STYLE)
def drawn(marks, view, alt, *, stretched=False, line=None):
    """Draw marks (``widgets.board.marks``) over a view (x0, y0, x1, y1); a second frame has the derivative's plane.

    ``stretched`` gives the axes scales of their own. ``line`` is the view of a line of knots, which stands under the
    picture. ``alt`` is the figure's label.
    """
    x0, y0, x1, y1 = view
    height = 4.2 if stretched else min(max(6 * (y1 - y0) / (x1 - x0), 2.5), 7)
    if line is not None:
        figure = Figure(figsize=(7, height + 2.6), layout="constrained")
        panels = figure.subplots(2, 1, height_ratios=(height, 2.6))
    else:
        count = 1 + any(mark.frame for mark in marks)
        figure = Figure(figsize=(6 if count == 1 else 10, height), layout="constrained")
        panels = figure.subplots(1, count, squeeze=False).ravel()
    for axes in panels:
        axes.set(aspect="auto" if stretched else "equal")
        axes.set_axis_off()
    panels[0].set(xlim=(x0, x1), ylim=(y0, y1))
    if line is not None:
        panels[1].set(xlim=(line[0], line[2]), ylim=(line[1], line[3]), aspect="auto")
    for mark in marks:
        DRAWN[mark.kind](panels[mark.frame], np.asarray(mark.points, dtype=float), mark)
    figure.set_label(alt)
    return figure


def _look(style):
    return {"color": COLOURS[style.colour], "linewidth": style.width, "linestyle": _dash(style)}


def _dash(style):
    return (0, tuple(float(length) / style.width for length in style.dash.split())) if style.dash else "-"


def _line(axes, points, mark):
    axes.plot(*points.T, **_look(mark.style))


def _curve(axes, points, mark):
    _line(axes, numeric.sample(points, SAMPLES), mark)


def _whole(axes, points, mark):
    axes.axline(*points, **_look(mark.style))


def _area(axes, points, mark):
    style = mark.style
    axes.add_patch(Polygon(points, facecolor=COLOURS[style.fill], alpha=style.opacity, edgecolor="none"))


def _circle(axes, points, mark):
    centre, rim = points
    axes.add_patch(Circle(centre, float(np.hypot(*(rim - centre))), fill=False, **_edge(mark.style)))


def _edge(style):
    return {"edgecolor": COLOURS[style.colour], "linewidth": style.width}


def _spots(marker):
    def draw(axes, points, mark):
        style = mark.style
        look = {"markeredgecolor": COLOURS[style.colour], "markeredgewidth": style.width}
        axes.plot(
            *points.T, marker, markersize=2 * style.radius * 0.75, markerfacecolor=COLOURS[style.fill], zorder=3, **look
        )

    return draw


def _below(axes, points, mark):
    for place, word in zip(points, mark.words, strict=True):
        axes.annotate(word, place, xytext=(0, -16), textcoords="offset points", ha="center", va="center")


def _names(axes, points, mark):
    for place, word, way in zip(points, mark.words, outward(points), strict=True):
        axes.annotate(word, place, xytext=16 * way, textcoords="offset points", ha="center", va="center")


DRAWN = {
    "line": _line,
    "curve": _curve,
    "whole": _whole,
    "area": _area,
    "circle": _circle,
    "dots": _spots("o"),
    "squares": _spots("s"),
    "names": _names,
    "below": _below,
}
