"""Pictures for widgets as SVG text, made in a millisecond: layers over one view, each a function of the view."""

from html import escape

import numpy as np

from .. import numeric
from ..palette import INK

WIDTH, HIGHEST, MARGIN = 480, 420, 44
CURVE_SAMPLES = 65


def picture(view, layers, alt):
    """The SVG text of some layers; ``view`` holds the points, shape (m, 2), that must be seen."""
    view = np.asarray(view, dtype=float)
    low, span = view.min(axis=0), np.ptp(view, axis=0)
    scale = min((WIDTH - 2 * MARGIN) / max(span[0], 1e-9), (HIGHEST - 2 * MARGIN) / max(span[1], 1e-9))
    height = span[1] * scale + 2 * MARGIN

    def place(points):
        x, y = ((np.asarray(points, dtype=float) - low) * scale).T
        return np.column_stack([x + (WIDTH - span[0] * scale) / 2, height - MARGIN - y])

    body = "".join(layer(place) for layer in layers)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(alt)}" '
        f'viewBox="0 0 {WIDTH} {height:.0f}" width="{WIDTH}" height="{height:.0f}" style="max-width:100%" '
        f'font-family="sans-serif" font-size="17"><rect width="100%" height="100%" fill="white"/>{body}</svg>'
    )


def polygon(points, colour, *, dash="", width=1.6, marker="o", names=()):
    """A control polygon with round, square or no markers and, where given, names beside its points."""

    def layer(place):
        dots = place(points)
        marks = "".join(_mark(x, y, colour, marker) for x, y in dots) if marker else ""
        words = "".join(_word(*at, name) for at, name in zip(_beside(dots), names, strict=False))
        return _line(dots, colour, dash, width) + marks + words

    return layer


def dots(points, colour):
    """Single points."""
    return lambda place: "".join(_mark(x, y, colour, "o") for x, y in place(points))


def words(points, names, down):
    """Words centred on points, moved down by pixels (up if negative), readable on top of lines."""
    return lambda place: "".join(_word(x, y + down, name) for (x, y), name in zip(place(points), names, strict=True))


def curve(points, colour, *, dash="", width=4):
    """A Bézier curve."""
    samples = numeric.sample(np.asarray(points, dtype=float), CURVE_SAMPLES)
    return lambda place: _line(place(samples), colour, dash, width)


def _line(dots, colour, dash, width):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in dots)
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-dasharray="{dash}"/>'


def _mark(x, y, colour, marker):
    if marker == "o":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="white" stroke="{colour}" stroke-width="2"/>'
    place = f'x="{x - 5:.1f}" y="{y - 5:.1f}" width="10" height="10"'
    return f'<rect {place} fill="white" stroke="{colour}" stroke-width="2"/>'


def _beside(dots):
    """Places for names: away from the neighbours of each point."""
    for i, dot in enumerate(dots):
        neighbours = [dots[j] for j in (i - 1, i + 1) if 0 <= j < len(dots)] or [dot + (0, 1)]
        away = dot - np.mean(neighbours, axis=0)
        yield dot + 20 * away / (np.hypot(*away) or 1.0)


def _word(x, y, text):
    halo = 'stroke="white" stroke-width="4" paint-order="stroke"'
    return f'<text x="{x:.1f}" y="{y + 6:.1f}" text-anchor="middle" fill="{INK}" {halo}>{escape(text)}</text>'
