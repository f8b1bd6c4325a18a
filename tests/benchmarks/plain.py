"""Answers to check by, computed in the plainest way, in long doubles, by nothing of bezteach."""

import numpy as np

FEW = 500  # parameters at which a long answer is looked at


def curve(points, t):
    """Points (m, d) of the curve at a row of parameters: de Casteljau's triangle."""
    level = np.asarray(points, dtype=np.longdouble)[:, None]
    t = np.asarray(t, dtype=np.longdouble)[:, None]
    while len(level) > 1:
        level = (1 - t) * level[:-1] + t * level[1:]
    return level[0]


def differences(points, r=1):
    """Control points of the r-th derivative, in long doubles."""
    level = np.asarray(points, dtype=np.longdouble)
    for _ in range(r):
        level = (len(level) - 1) * (level[1:] - level[:-1])
    return level


def curvature(points, t):
    """Signed curvature of a plane curve at a row of parameters, in long doubles."""
    (x1, y1), (x2, y2) = (curve(differences(points, r), t).T for r in (1, 2))
    return (x1 * y2 - y1 * x2) / (x1 * x1 + y1 * y1) ** 1.5


def spline(points, knots, degree, t):
    """Points of a B-spline curve at a row of parameters: de Boor's triangle, one parameter after the other."""
    points, knots = (np.asarray(values, dtype=np.longdouble) for values in (points, knots))
    return np.array([_at(points, knots, degree, value) for value in np.asarray(t, dtype=np.longdouble)])


def _at(points, knots, p, t):
    k = min(max(int(np.searchsorted(knots, t, "right")) - 1, p), len(points) - 1)
    level = points[k - p : k + 1]
    for r in range(1, p + 1):
        start, end = knots[k - p + r : k + 1, None], knots[k + 1 : k + 1 + p - r + 1, None]
        share = (t - start) / (end - start)
        level = (1 - share) * level[:-1] + share * level[1:]
    return level[0]


def some(count):
    """Indices, the first and the last among them, at which a row of so many is looked at."""
    return np.unique(np.linspace(0, count - 1, min(count, FEW)).astype(int))
