"""Marks as the text of an SVG picture, made in a millisecond; ``browser/`` makes the same elements on a screen."""

from html import escape

import numpy as np

from ... import numeric
from ...naming import outward
from ...palette import FIRST, INK, QUIET, SECOND

COLOURS = {"ink": INK, "first": FIRST, "second": SECOND, "quiet": QUIET, "paper": "#ffffff", "none": "none"}
WIDTH = 640
MARGIN = 32
NARROW = 460  # below this the second frame stands under the first
SAMPLES = 97
LETTERS = 17
STEEP = 0.66  # height by width of a graph
BELOW = 20  # pixels from a point down to a word under it
AWAY = 24  # and to its name, which the ring around a marked point does not touch


class Frame:
    """A rectangle of the picture, (left, top, width, height), and the view (x0, y0, x1, y1) of the plane put on it.

    Both axes have one scale, but for graphs, which are stretched.
    """

    def __init__(self, rectangle, view, stretched=False):
        left, top, width, height = rectangle
        x0, y0, x1, y1 = view
        self.rectangle = rectangle
        scales = np.array([(width - 2 * MARGIN) / (x1 - x0), (height - 2 * MARGIN) / (y1 - y0)])
        self.scale = (scales if stretched else np.repeat(scales.min(), 2)) * (1, -1)
        self.origin = (left + width / 2, top + height / 2) - self.scale * ((x0 + x1) / 2, (y0 + y1) / 2)

    def place(self, points):
        """Pixels, shape (m, 2), of points; y grows upwards in the plane."""
        return self.origin + self.scale * np.asarray(points, dtype=float)

    @property
    def diagonal(self):
        return float(np.hypot(*self.rectangle[2:]))


def room(points, spare=0.12):
    """The view (x0, y0, x1, y1) that shows points with room around them."""
    points = np.asarray(points, dtype=float)
    low, high = points.min(axis=0), points.max(axis=0)
    spare = max(*(high - low) * spare, 0.25 if (high == low).all() else 0)
    (x0, y0), (x1, y1) = low - spare, high + spare
    return (float(x0), float(y0), float(x1), float(y1))


def layout(width, view, beside, stretched=False, line=False):
    """The height of a picture of this width, and the rectangles of its one or two frames.

    ``beside``: whether there is a frame of vectors, beside the first or, in a narrow picture, under it; ``line``:
    whether there is a line of knots, always under it.
    """
    stacked = line or width < NARROW
    across = width if stacked or not beside else round(0.62 * width)
    x0, y0, x1, y1 = view
    steep = STEEP if stretched else (y1 - y0) / (x1 - x0)
    high = 0.5 if line else 0.72
    height = round(min(max(steep * (across - 2 * MARGIN) + 2 * MARGIN, 0.4 * across), high * across))
    first = (0, 0, across, height)
    if not beside:
        return height, [first]
    if stacked:
        under = round((0.36 if line else 0.7) * width)
        return height + under, [first, (0, height, width, under)]
    return height, [first, (across, 0, width - across, height)]


def vector_view(marks):
    """The view of the second frame: the vectors' points around the origin, growing in steps of two so that it rests."""
    reach = max(
        (abs(c) for mark in marks if mark.frame and mark.kind != "whole" for p in mark.points for c in p), default=0
    )
    half = 2.0 ** np.ceil(np.log2(reach)) if reach > 0 else 1.0
    return (-half, -half, half, half)


def picture(marks, view, alt, width=WIDTH, *, stretched=False, line=None):
    """The SVG text of marks over a view of the plane, ``width`` pixels wide; ``line`` is that of the knots' line."""
    beside = any(mark.frame for mark in marks)
    height, rectangles = layout(width, view, beside, stretched, line is not None)
    views = [(view, stretched), (vector_view(marks), False) if line is None else (line, True)]
    frames = [Frame(place, *seen) for place, seen in zip(rectangles, views, strict=False)]
    body = "".join(_clipped(frame, [m for m in marks if m.frame == i]) for i, frame in enumerate(frames))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(alt)}" '
        f'viewBox="0 0 {width} {height}" width="{width}" height="{height}" style="max-width:100%;height:auto" '
        f'font-family="sans-serif" font-size="{LETTERS}"><rect width="100%" height="100%" fill="white"/>{body}</svg>'
    )


def _clipped(frame, marks):
    x, y, width, height = frame.rectangle
    inside = "".join(element for mark in marks for element in drawn(mark, frame))
    place = f'x="{x}" y="{y}" width="{width}" height="{height}"'
    return f'<svg {place} viewBox="{x} {y} {width} {height}">{inside}</svg>'


def drawn(mark, frame):
    """The elements of one mark as SVG text."""
    style, pixels = mark.style, frame.place(mark.points)
    if mark.kind == "curve":
        pixels = frame.place(numeric.sample(np.asarray(mark.points, dtype=float), SAMPLES))
    if mark.kind == "whole":
        along = pixels[1] - pixels[0]
        along *= 2 * frame.diagonal / np.hypot(*along)
        pixels = np.array([pixels[0] - along, pixels[0] + along])
    if mark.kind in ("line", "curve", "whole"):
        return [_line("polyline", pixels, style, "none")]
    if mark.kind == "area":
        return [_line("polygon", pixels, style, COLOURS[style.fill])]
    if mark.kind == "circle":
        return [_dot(pixels[0], float(np.hypot(*(pixels[1] - pixels[0]))), style, "none")]
    if mark.kind == "dots":
        whole = style._replace(dash="")
        return [_dot(at, style.radius, whole, COLOURS[style.fill]) for at in pixels]
    if mark.kind == "squares":
        return [_square(at, style._replace(dash="")) for at in pixels]
    places = pixels + (0, BELOW) if mark.kind == "below" else beside(pixels)
    return [_word(at, word) for at, word in zip(places, mark.words, strict=True)]


def beside(pixels):
    """Places for names, off the polygon; pixels count downwards."""
    down = np.array([1, -1])
    return pixels + AWAY * down * outward(pixels * down)


def _look(style, fill):
    opacity = "" if style.opacity == 1 else f' fill-opacity="{style.opacity}"'
    dash = f' stroke-dasharray="{style.dash}"' if style.dash else ""
    return f'fill="{fill}"{opacity} stroke="{COLOURS[style.colour]}" stroke-width="{style.width}"{dash}'


def _line(tag, pixels, style, fill):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in pixels)
    return f'<{tag} points="{path}" {_look(style, fill)} stroke-linejoin="round"/>'


def _dot(at, radius, style, fill):
    return f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}" {_look(style, fill)}/>'


def _square(at, style):
    r = style.radius
    place = f'x="{at[0] - r:.1f}" y="{at[1] - r:.1f}" width="{2 * r}" height="{2 * r}"'
    return f"<rect {place} {_look(style, COLOURS[style.fill])}/>"


def _word(at, text):
    halo = 'stroke="white" stroke-width="4" paint-order="stroke"'
    return (
        f'<text x="{at[0]:.1f}" y="{at[1] + 6:.1f}" text-anchor="middle" '
        f'fill="{COLOURS["ink"]}" {halo}>{escape(text)}</text>'
    )
