"""The convex hull of points of the plane, exact or not."""


def hull(points):
    """The corners of the convex hull of points, a list, counter-clockwise from the lowest of the leftmost points.

    >>> hull([(0, 0), (1, 2), (1, 1), (2, 0), (1, 0)])
    [(0, 0), (2, 0), (1, 2)]

    Two corners are left of points on a line, one of equal ones. Source: Andrew, Another efficient algorithm for convex
    hulls in two dimensions, 1979.
    """
    ordered = sorted(set(map(tuple, points)))
    if len(ordered) < 3:
        return ordered
    return _chain(ordered)[:-1] + _chain(ordered[::-1])[:-1]


def _chain(ordered):
    corners = []
    for point in ordered:
        while len(corners) > 1 and _turn(corners[-2], corners[-1], point) <= 0:
            corners.pop()
        corners.append(point)
    return corners


def _turn(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
