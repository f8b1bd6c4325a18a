"""The explorer of B-splines: a curve, and under it its knots and basis functions."""

from ..board import Board

SHOWN = ("span", "polygon", "spline", "breaks", "functions")


def explore_bspline(points, knots, t=None, **settings):
    """A B-spline curve with its knots to move: what depends on what, and how the spans join.

    ``points``: shape (n+1, 2), ``knots``: n+p+2 that do not decrease, for a degree p from 1 to 5, all exact; t in the
    domain, in its middle if none is given. Further settings are those of ``Board``. ``ValueError`` names the rule that
    points, knots or t break.
    """
    return Board(points, t, knots=knots, **{"show": SHOWN, "offer": (*SHOWN, "deboor")} | settings)
