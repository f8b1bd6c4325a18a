"""What a picture is made of: lines, curves, dots and words in the plane, and how each looks."""

from typing import NamedTuple

import numpy as np


class Style(NamedTuple):
    """How a mark looks. Colours are names of the palette; widths, dashes and radii are pixels."""

    colour: str = "ink"
    width: float = 1.6
    dash: str = ""
    fill: str = "none"
    radius: float = 5
    opacity: float = 1


class Mark(NamedTuple):
    """One thing in a picture.

    ``kind``: "line" joins the points, "area" closes and fills what they enclose, "whole" is the line through the first
    two, "curve" has them as control points, "dots" and "squares" mark them, "circle" has the first as its centre and
    runs through the second, "names" writes ``words`` beside them, away from their neighbours, "below" under them.
    ``frame`` is 0 for the plane of the curve, 1 for that of its derivative or the line of its knots.
    """

    kind: str
    points: tuple
    style: Style = Style()
    words: tuple = ()
    frame: int = 0


STYLES = {
    "polygon": Style("quiet", 2),
    "curve": Style("first", 4),
    "level": Style("ink", 1.4),
    "new": Style("ink", 1.6, fill="paper", radius=4),
    "point": Style("ink", 2, fill="ink", radius=6),
    "left": Style("first", 2.4, fill="paper", radius=4.5),
    "left-curve": Style("first", 5.5),
    "right": Style("second", 2.4, fill="paper", radius=4.5),
    "right-curve": Style("second", 5.5, dash="12 7"),
    "part": Style("second", 8),
    "tangent": Style("second", 1.8),
    "hull": Style("quiet", 1, fill="first", opacity=0.14),
    "box": Style("quiet", 1.6, dash="5 5"),
    "circle": Style("second", 2.4),
    "line": Style("ink", 2.4),
    "crossing": Style("first", 2.4, fill="first", radius=6),
    "polygon-crossing": Style("quiet", 2.4, fill="paper", radius=5),
    "axis": Style("quiet", 1.2),
    "hodograph": Style("second", 4),
    "vector": Style("ink", 2.4),
    "even": Style("second", 1.8, fill="paper", radius=3),
    "break": Style("ink", 2, fill="paper", radius=5),
    "deciding": Style("first", 2.4, fill="first", radius=11, opacity=0.4),
    "function-even": Style("second", 2.8),
    "function-odd": Style("first", 2.8, dash="8 4"),
    "function-rest": Style("quiet", 1.4),
    "odd": Style("first", 1.8, dash="7 4", fill="paper", radius=3),
}


def mark(kind, points, style, frame=0):
    """A mark through points, shape (m, 2), in the style of this name."""
    return Mark(kind, rows(points), STYLES[style], frame=frame)


def rows(points):
    """Points as a tuple of pairs of floats."""
    return tuple(map(tuple, np.asarray(points, dtype=float).tolist()))
