"""Marks of a B-spline curve, and of the line of its knots, which is the second frame of the picture."""

import numpy as np

from ... import numeric
from ...numeric import bspline
from ...numeric.hull import hull
from .blocks import name_of
from .joining import CURVES
from .knots import degree_of, domain_of, graphs, inner, span_of, stacks
from .marks import Mark, mark, rows

FINE = 24  # edges of a graph on each span
TOP = 1.36  # above the graphs, where their names hang
NEAR = 1e-9  # relatively: a point of the curve is a control point


def spline(points, state):
    pieces, _ = bspline.to_bezier(points, _floats(state))
    return [mark("curve", piece, CURVES[k % 2]) for k, piece in enumerate(pieces)]


def breaks(points, state):
    """The points of the curve at the inner knots, two where it jumps; at a control point, that has the name."""
    knots, near, marks = _floats(state), NEAR * np.abs(points).max(), []
    for knot, times in inner(state):
        last = int(np.flatnonzero(knots <= knot)[-1])
        sides = (last - times, last) if times > degree_of(state) else (last,)
        places = [bspline.evaluate(points, knots, float(knot), span=k) for k in sides]
        marks.append(mark("squares", places, "break"))
        if np.abs(points - places[-1]).max(axis=1).min() > near:
            marks.append(Mark("below", rows(places[-1:]), words=(f"t = {knot}",)))
    return marks


def span(points, state):
    """The control points that decide on the span of t, and their hull, in which it lies."""
    k, p = span_of(state), degree_of(state)
    piece = bspline.to_bezier(points[k - p : k + 1], _floats(state)[k - p : k + p + 2])[0][0]
    near = state.points[k - p : k + 1]
    return [mark("area", hull(near), "hull"), mark("curve", piece, "part"), mark("dots", near, "deciding")]


def deboor(points, state):
    levels = bspline.de_boor(points, _floats(state), float(state.t))[1:]
    lines = [mark("line", level, "level") for level in levels if len(level) > 1]
    return lines + [mark("dots", level, "new" if len(level) > 1 else "point") for level in levels]


def functions(points, state):
    """The graphs of the basis functions; those that are not 0 on the span of t stand out, with their values at t."""
    k, p, t = span_of(state), degree_of(state), float(state.t)
    marks = []
    for i, pieces in enumerate(graphs(_floats(state), p)):
        graph = np.concatenate([numeric.sample(piece, FINE + 1) for piece in pieces])
        style = ("even", "odd")[i % 2] if k - p <= i <= k else "rest"
        marks.append(mark("line", graph, f"function-{style}"))
        centre = sum(state.knots[i : i + p + 2]) / (p + 2)  # no two functions have one
        marks.append(Mark("below", rows([(centre, TOP)]), words=(name_of(i, letter="N"),)))
    values = bspline.basis(_floats(state), p, t, span=k)[k - p : k + 1]
    marks += [mark("line", [(t, 0), (t, 1)], "level"), mark("dots", [(t, value) for value in values], "new")]
    return [one._replace(frame=1) for one in marks]


def line(state):
    """What is always seen of the line: the domain, the axis, the values of the knots under their stacks."""
    (a, b), knots = domain_of(state.points, state.knots), state.knots
    lowest = dict(zip(knots, stacks(knots), strict=True))  # the last one of a stack
    return [
        mark("area", [(a, 0), (b, 0), (b, 1), (a, 1)], "hull", 1),
        mark("line", [(knots[0], 0), (knots[-1], 0)], "axis", 1),
        *(Mark("below", rows([place]), words=(str(knot),), frame=1) for knot, place in lowest.items()),
    ]


def _floats(state):
    return np.array(state.knots, dtype=float)
