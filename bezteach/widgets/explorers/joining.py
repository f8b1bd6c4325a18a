"""Explorers of curves in several pieces: two cubics that meet, and splines through data points."""

from ..board import Board
from ..board.blocks import exact_array
from ..board.joining import a_frame
from ..board.state import exact, points_of
from ..board.svg import room


def explore_join(left, right, lengths=(1, 1), **settings):
    """Two cubics that meet, over intervals of these lengths: the class of the join, what it lacks, and its A-frame.

    ``left`` and ``right``: shape (4, 2), exact, with the join in common. t is where the parameter, which runs from 0
    to 1 over both, passes the join. Further settings are those of ``Board``. ``ValueError`` for curves that do not
    meet, are no cubics, and lengths that are not positive. Source: games, "conditions for joining two Bézier curves".
    """
    left, right = points_of(left, "P"), points_of(right, "Q")
    for name, points in (("left", left), ("right", right)):
        if len(points) != 4:
            raise ValueError(f"the {name} curve has {len(points)} control points, and a cubic has 4")
    if left[-1] != right[0]:
        end, start = (f"({x}, {y})" for x, y in (left[-1], right[0]))
        raise ValueError(f"the left curve ends at {end} and the right one starts at {start}: they must meet")
    h, k = (exact(length, "the length of an interval") for length in lengths)
    if h <= 0 or k <= 0:
        raise ValueError(f"the intervals have lengths {h} and {k}: both must be positive")
    layers = ("polygon", "pieces", "frames")
    view = room([*left, *right, *a_frame(exact_array(left), exact_array(right), (h, k))])
    return Board((*left, *right[1:]), h / (h + k), **{"show": layers, "offer": layers, "view": view} | settings)


def explore_spline(data, **settings):
    """Cubics through data points: by the one-sixth rule, which is local, and the natural spline, which is not.

    ``data``: shape (m, 2), exact, 2 to 20 points; further settings are those of ``Board``. Source: games,
    "interpolating with piecewise Bézier curves"; transcript, the one-sixth rule.
    """
    return Board(data, **{"show": ("local",), "offer": ("local", "natural"), "letter": "D"} | settings)
