"""The marks of a board's layers, each layer a function of the state; ``browser/`` paints the same ones."""

from fractions import Fraction

import numpy as np

from ... import numeric
from ...numeric.hull import hull
from .blocks import name_of
from .crossings import curve_crossings, polygon_crossings
from .joining import frames, local, natural, pieces
from .knots import stacks
from .marks import STYLES, Mark, mark, rows
from .spline import breaks, deboor, functions, line, span, spline


def scene(state, letter="b"):
    """The marks of all layers shown, from the bottom to the top, the control points and their names last."""
    points = np.asarray(state.points, dtype=float)
    marks = [one for name in state.show for one in PAINTED[name](points, state)]
    names = tuple(name_of(i, letter=letter) for i in range(len(points)))
    handles = [mark("dots", points, "new"), Mark("names", rows(points), STYLES["new"], names)]
    if state.knots is None:
        return marks + handles
    return line(state) + marks + [mark("dots", stacks(state.knots), "new", 1)] + handles


def _polygon(points, state):
    return [mark("line", points, "polygon")]


def _curve(points, state):
    return [mark("curve", points, "curve")]


def _point(points, state):
    return [mark("dots", [numeric.evaluate(points, float(state.t))], "point")]


def _levels(points, state):
    last = len(points) - 1 if state.level is None else state.level
    levels = numeric.de_casteljau(points, float(state.t))[1 : last + 1]
    lines = [mark("line", level, "level") for level in levels if len(level) > 1]
    dots = [mark("dots", level, "new" if len(level) > 1 else "point") for level in levels]
    return lines + dots


def _halves(points, state):
    left, right = numeric.split(points, float(state.t))
    return [
        mark("curve", left, "left-curve"),
        mark("curve", right, "right-curve"),
        mark("line", left, "left"),
        mark("line", right, "right"),
        mark("dots", left, "left"),
        mark("squares", right, "right"),
    ]


def _part(points, state):
    part = numeric.segment(points, float(state.a), float(state.b))
    return [mark("curve", part, "part"), mark("line", part, "right"), mark("squares", part, "right")]


def _tangents(points, state):
    """Where two points that give a tangent coincide, which exact numbers tell, there is none."""
    exact = np.array(state.points, dtype=object)
    levels = numeric.de_casteljau(exact, state.t)
    pairs = [exact[:2], levels[-2], exact[-2:]]
    return [mark("whole", pair, "tangent") for pair in pairs if (pair[0] != pair[1]).any()] + [
        mark("dots", levels[-1], "point")
    ]


def _hodograph(points, state):
    arrows = numeric.hodograph(points)
    tip = numeric.evaluate(arrows, float(state.t))
    return [
        mark("whole", [(0, 0), (1, 0)], "axis", 1),
        mark("whole", [(0, 0), (0, 1)], "axis", 1),
        mark("line", arrows, "polygon", 1),
        mark("curve", arrows, "hodograph", 1),
        mark("dots", arrows, "new", 1),
        mark("line", [(0, 0), tip], "vector", 1),
        mark("dots", [tip], "point", 1),
        Mark("names", rows([tip]), STYLES["point"], ("p′(t)",), 1),
        mark("dots", numeric.de_casteljau(points, float(state.t))[-1], "point"),
    ]


def _hull(points, state):
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    box = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    return [mark("area", hull(state.points), "hull"), mark("line", box, "box")]


def _circle(points, state):
    exact = np.array(state.points, dtype=object)
    found = end_circle(exact[::-1] if state.end else exact)
    if found is None:
        return []
    return [mark("circle", found, "circle"), mark("line", found, "axis"), mark("dots", found, "new")]


def end_circle(points):
    """(centre, b_0) of the circle of curvature at t = 0 of exact points, an array; None where there is none."""
    first = points[1] - points[0]
    second = points[min(2, len(points) - 1)] - points[0]
    area = first[0] * second[1] - first[1] * second[0]
    n = len(points) - 1
    if area == 0:
        return None
    # the radius is n |first|^3 / ((n-1) area), measured along the normal, which is as long as the edge
    away = Fraction(n, n - 1) * (first @ first) / area
    return points[0] + away * np.array([-first[1], first[0]]), points[0]


def _line(points, state):
    line = np.asarray(state.line, dtype=float)
    exact = (np.array(rows, dtype=object) for rows in (state.points, state.line))
    marks = [mark("whole", line, "line")]
    for kind, places, style in (
        ("squares", polygon_crossings(*exact), "polygon-crossing"),
        ("dots", curve_crossings(points, line), "crossing"),
    ):
        marks += [mark(kind, places, style)] if len(places) else []
    return marks


def _elevated(points, state):
    marks = []
    for r in range(1, state.raised + 1):
        style = ("even", "odd")[r % 2]
        raised = numeric.elevate(points, r)
        marks += [mark("line", raised, style), mark("dots", raised, style)]
    return marks


def _halving(points, state):
    marks = []
    for i, piece in enumerate(numeric.subdivide(points, state.depth)):
        style = ("even", "odd")[i % 2]
        marks += [mark("line", piece, style), mark("dots", piece, style)]
    return marks


PAINTED = {
    "hull": _hull,
    "polygon": _polygon,
    "curve": _curve,
    "elevated": _elevated,
    "halving": _halving,
    "circle": _circle,
    "point": _point,
    "tangents": _tangents,
    "line": _line,
    "levels": _levels,
    "halves": _halves,
    "part": _part,
    "hodograph": _hodograph,
    "pieces": pieces,
    "frames": frames,
    "local": local,
    "natural": natural,
    "spline": spline,
    "breaks": breaks,
    "span": span,
    "deboor": deboor,
    "functions": functions,
}
