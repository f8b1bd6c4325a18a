"""Where the name of a point stands in a picture: off its polygon."""

import numpy as np

STRAIGHT = 1e-6  # a smaller bisector of two unit vectors is rounding


def outward(points):
    """Unit vectors, shape (m, 2): from each of m points of a polygon away from its neighbours, along the bisector.

    Where the polygon goes straight on, the vector stands across it, upwards or else to the right; a point without a
    neighbour elsewhere has its name above it.

    >>> (outward([(0, 0), (2, 0), (5, 0), (5, 3)]).round(2) + 0.0).tolist()
    [[-1.0, 0.0], [0.0, 1.0], [0.71, -0.71], [0.0, 1.0]]
    """
    points = np.asarray(points, dtype=float)
    return np.array(
        [_away(points[i], [*points[max(i - 1, 0) : i], *points[i + 1 : i + 2]]) for i in range(len(points))]
    )


def _away(here, neighbours):
    ways = [there - here for there in neighbours if (there != here).any()]
    units = [way / np.hypot(*way) for way in ways]
    bisector = -sum(units, np.zeros(2))
    if np.hypot(*bisector) > STRAIGHT:
        return bisector / np.hypot(*bisector)
    x, y = units[0] if units else (1.0, 0.0)
    return np.array([-y, x] if x > STRAIGHT or (abs(x) <= STRAIGHT and y < 0) else [y, -x])
