"""Marks of curves in several pieces: cubics that share their ends, their A-frames, and splines through data points."""

from itertools import cycle, pairwise

from ...numeric import joins
from .marks import mark

CURVES = ("left-curve", "right-curve")


def cut_in_pieces(points):
    """The control points of cubics that share their ends; what is left at the end is a piece of a lower degree."""
    return [points[first : first + 4] for first in range(0, len(points) - 1, 3)]


def joints(points, t):
    """(left, right, lengths) for each two pieces that meet; the pieces run over intervals t and 1 - t in turn."""
    lengths = [(t, 1 - t), (1 - t, t)]
    return [(*pair, both) for pair, both in zip(pairwise(cut_in_pieces(points)), cycle(lengths), strict=False)]


def a_frame(left, right, lengths):
    """The two tips of the A-frame of cubics that meet with C1, arrays of points: with C2 they are one point.

    None where a piece is no cubic or an interval has no length. Source: games, "conditions for joining"; the ledger's
    joins/a-frame.
    """
    h, k = lengths
    if len(left) != 4 or len(right) != 4 or not h * k:
        return None
    return left[2] + (left[2] - left[1]) * k / h, right[1] + (right[1] - right[2]) * h / k


def pieces(points, state):
    return [mark("curve", piece, CURVES[k % 2]) for k, piece in enumerate(cut_in_pieces(points))]


def frames(points, state):
    marks = []
    for left, right, lengths in joints(points, float(state.t)):
        if tips := a_frame(left, right, lengths):
            marks += [mark("line", [left[2], tips[0]], "left"), mark("line", [right[1], tips[1]], "right")]
            marks += [mark("squares", [tips[1]], "right"), mark("dots", [tips[0]], "new")]
    return marks


def local(points, state):
    return _spline(joins.catmull_rom(points), "left-curve", "odd")


def natural(points, state):
    return _spline(joins.natural(points), "right-curve", "even")


def _spline(cubics, curve, inner):
    marks = [mark("curve", cubic, curve) for cubic in cubics]
    for cubic in cubics:
        marks += [mark("line", cubic, inner), mark("dots", cubic[1:3], inner)]
    return marks
