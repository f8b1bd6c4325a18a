"""What several pictures draw alike: a polygon, a curve, and words beside a point."""

import numpy as np

from .. import numeric
from ..naming import outward
from .style import SAMPLES


def polygon(axes, points, colour, marker, dash, *, width=1.6, size=8, filled=False):
    x, y = np.asarray(points, dtype=float).T
    inside = colour if filled else "white"
    axes.plot(x, y, dash, color=colour, linewidth=width, marker=marker, markersize=size, markerfacecolor=inside)


def curve(axes, points, colour, *, dash="-", width=3.0, label=None):
    x, y = numeric.sample(np.asarray(points, dtype=float), SAMPLES).T
    axes.plot(x, y, color=colour, linestyle=dash, linewidth=width, label=label, zorder=1.9)


def word(axes, place, text, away):
    """Write a text beside a place, some way off in the direction of the vector ``away``, above it if that is 0."""
    away = away / np.hypot(*away) if np.any(away) else np.array([0.0, 1.0])
    axes.annotate(
        text,
        place,
        xytext=14 * away,
        textcoords="offset points",
        ha="center" if abs(away[0]) < 0.35 else "left" if away[0] > 0 else "right",
        va="center" if abs(away[1]) < 0.35 else "bottom" if away[1] > 0 else "top",
        bbox={"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
    )


def frame(axes, points, room):
    """Equal scales, with room around the points: a part of the greater extent, one number or one for each axis."""
    places = np.asarray(points, dtype=float)
    low, high = places.min(axis=0), places.max(axis=0)
    (left, bottom), (right, top) = np.array([low, high]) + np.outer((-1, 1), np.broadcast_to(room, 2) * max(high - low))
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    axes.locator_params(nbins=7)  # numbers beside each other stay apart


def names(axes, points, texts):
    """Write a name beside each point of a polygon, off it."""
    for place, text, way in zip(np.asarray(points, dtype=float), texts, outward(points), strict=True):
        word(axes, place, text, way)


def outer_normal(points, t):
    """The normal at t on the side that the curve bends away from; 0 where it goes straight on."""
    first, second = (np.asarray(numeric.derivative(points, t, r), dtype=float) for r in (1, 2))
    return np.sign(first[0] * second[1] - first[1] * second[0]) * np.array([first[1], -first[0]])
