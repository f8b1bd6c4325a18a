"""Affine invariance: transform the control points or the points of the curve, and compare; one map is not affine."""

from fractions import Fraction

import ipywidgets as widgets
import numpy as np

from ... import numeric
from ...display import point
from ..board import Board, svg
from ..board.blocks import Block
from ..board.marks import STYLES, Mark, Style
from .sliders import beside

MAPS = {
    "shift": lambda x, y: (x + 1, y - 1),
    "turn (cosine 4/5, sine 3/5)": lambda x, y: (
        Fraction(4, 5) * x - Fraction(3, 5) * y,
        Fraction(3, 5) * x + Fraction(4, 5) * y,
    ),
    "stretch one way": lambda x, y: (Fraction(3, 2) * x, Fraction(1, 2) * y),
    "shear": lambda x, y: (x + Fraction(1, 2) * y, y),
    "mirror": lambda x, y: (-x, y),
    "bend: y + x² / 4, not affine": lambda x, y: (x, y + Fraction(1, 4) * x * x),
}
SEEN = 33  # points of the curve that are mapped one by one
IMAGE, DOTS = Style("second", 3, dash="12 7"), Style("ink", 1.2, fill="paper", radius=3)


def explore_affine(points, t=Fraction(1, 3), transformation="turn (cosine 4/5, sine 3/5)"):
    """Map the control points (dashed curve) or the curve itself, point by point (dots): both give one curve.

    For the map that bends they do not. ``points``: exact, shape (n+1, 2). The choice is ``.controls["map"]``, the board
    ``.board``. ``ValueError`` names an unknown transformation.
    """
    if transformation not in MAPS:
        raise ValueError(f"there is no transformation {transformation!r}: there are {', '.join(MAPS)}")
    choice = widgets.Dropdown(options=list(MAPS), value=transformation, description="map")
    images = [image(points, name) for name in MAPS]
    board = Board(
        points,
        t,
        ("polygon", "curve", "point"),
        offer=("polygon", "curve", "point"),
        view=svg.room([p for some in (points, *images) for p in some]),
        blocks=lambda state: affine_blocks(state.points, state.t, choice.value),
        marks=lambda state: affine_marks(state.points, choice.value),
    )
    choice.observe(lambda _: board.refresh(), "value")
    return beside(board, {"map": choice})


def image(points, name):
    """The points under a transformation about the first of them: exact in, exact out."""
    x0, y0 = points[0]
    return tuple((u + x0, v + y0) for u, v in (MAPS[name](x - x0, y - y0) for x, y in points))


def affine_blocks(points, t, name):
    """What is said: the image of p(t), and the point at t of the curve of the mapped control points."""
    mapped = image(points, name)
    start = points[0]
    first = image((start, tuple(numeric.evaluate(points, t))), name)[1]
    second = tuple(numeric.evaluate(np.array(mapped, dtype=object), t))
    verdict = "One point, computed in two ways" if first == second else "Two points: this map is not affine"
    return [
        Block("Control points mapped", (tuple(map(point, mapped)),)),
        Block(f"At t = {t}", (("p(t), mapped", point(first)), ("on the curve of the mapped points", point(second)))),
        Block(verdict, ()),
        Block("In the picture", (("dashed", "the curve of the mapped points"), ("dots", "the curve, mapped"))),
    ]


def affine_marks(points, name):
    """What is painted under the board's layers: the mapped polygon and its curve, and the curve mapped as dots."""
    mapped = np.asarray(image(points, name), dtype=float)
    seen = numeric.sample(np.asarray(points, dtype=float), SEEN)
    dots = np.asarray(image((tuple(np.asarray(points[0], dtype=float)), *map(tuple, seen)), name)[1:], dtype=float)
    rows = [tuple(map(tuple, some.tolist())) for some in (mapped, dots)]
    return [
        Mark("line", rows[0], STYLES["box"]),
        Mark("curve", rows[0], IMAGE),
        Mark("squares", rows[0], STYLES["even"]),
        Mark("dots", rows[1], DOTS),
    ]
