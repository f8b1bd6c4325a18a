"""Explorers that are boards: the layers that belong together, at the state where a lesson begins."""

from fractions import Fraction

from ...display import point
from ..board import Board
from ..board.marks import Mark, Style, rows

ALWAYS = ("polygon", "curve")
TARGET = Style("second", 2.4, fill="paper", radius=6)


def explore_casteljau(points, t=Fraction(1, 3), **settings):
    """De Casteljau's construction at t, level by level: play it, or step through it.

    Here and below ``points`` are exact, shape (n+1, 2); further settings are those of ``Board``.
    """
    return Board(points, t, (*ALWAYS, "levels"), offer=(*ALWAYS, "levels", "tangents", "halves", "hull"), **settings)


def explore_tangents(points, t=Fraction(1, 3), **settings):
    """The tangents at 0, t and 1; those of a parabola cut each other in one ratio."""
    return Board(points, t, (*ALWAYS, "tangents"), offer=(*ALWAYS, "tangents", "levels"), **settings)


def explore_split(points, t=Fraction(1, 3), **settings):
    """Cut a curve at t: both halves with their control points, and the whole triangle."""
    return Board(points, t, ("polygon", "levels", "halves"), offer=(*ALWAYS, "levels", "halves"), **settings)


def explore_segment(points, a=Fraction(1, 4), b=Fraction(3, 4), **settings):
    """Cut the part over [a, b] out of a curve; with a > b it runs backwards."""
    return Board(points, show=(*ALWAYS, "part"), offer=(*ALWAYS, "part"), a=a, b=b, **settings)


def explore_hodograph(points, t=Fraction(1, 3), **settings):
    """A curve, and beside it its hodograph, which lives in the plane of the vectors; the derivatives at the ends."""
    return Board(points, t, (*ALWAYS, "hodograph"), offer=(*ALWAYS, "hodograph", "tangents"), **settings)


def explore_curvature(points, end=0, **settings):
    """The circle of curvature at an end: only the three points next to it decide."""
    return Board(points, show=(*ALWAYS, "circle"), offer=(*ALWAYS, "circle", "tangents"), end=end, **settings)


def explore_elevation(points, raised=1, **settings):
    """The polygons of one curve in higher degrees; they tend to it."""
    return Board(points, show=(*ALWAYS, "elevated"), offer=(*ALWAYS, "elevated"), raised=raised, **settings)


def explore_halving(points, depth=1, **settings):
    """The polygons of a curve's pieces after repeated halving; they hug it four times closer with each one."""
    return Board(points, show=(*ALWAYS, "halving"), offer=(*ALWAYS, "halving", "elevated"), depth=depth, **settings)


def explore_crossings(points, line=None, **settings):
    """A line to drag through polygon and curve: it passes through the curve at most as often as through the polygon."""
    return Board(points, show=(*ALWAYS, "line"), offer=(*ALWAYS, "line", "hull"), line=line, **settings)


def explore_pull(points, place, t=Fraction(1, 2), **settings):
    """The point of the curve at t, and a square at a place to which control points are to pull it."""
    target = rows([place])
    marks = [Mark("squares", target, TARGET), Mark("names", target, TARGET, (point(place),))]
    layers = (*ALWAYS, "point")
    return Board(points, t, layers, offer=layers, marks=lambda state: marks, **settings)
