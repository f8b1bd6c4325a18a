"""Where a line meets a polygon and a curve, to paint it; how often, exactly, is counted in ``words``."""

import numpy as np

from ... import numeric

DEPTH = 20  # halvings, after which a piece is a point of the picture
TINY = 1e-9  # of the greatest distance: nearer to the line than this is on it
NEAR = 1e-3  # in t: closer crossings are one dot


def heights(points, line):
    """Signed distances of points from the line, times its points' distance."""
    along = line[1] - line[0]
    return along[0] * (points[:, 1] - line[0][1]) - along[1] * (points[:, 0] - line[0][0])


def polygon_crossings(points, line):
    """Points in which a polygon meets a line, arrays of exact points; of edges on the line the first point."""
    h = heights(points, line)
    if not h.any():
        return []
    places = [points[i] for i in range(len(h)) if h[i] == 0 and (i == 0 or h[i - 1] != 0)]
    edges = [i for i in range(len(h) - 1) if h[i] * h[i + 1] < 0]
    return places + [points[i] + (points[i + 1] - points[i]) * (h[i] / (h[i] - h[i + 1])) for i in edges]


def curve_crossings(points, line):
    """Points in which the curve meets the line, shape (m, 2), in the order of t; none if it lies on the line."""
    h = heights(points, line)
    size = np.abs(h).max()
    if size == 0:
        return []
    found = _roots(h / size, 0.0, 1.0)
    return [numeric.evaluate(points, t) for t in found]


def _roots(h, low, high):
    """Zeros in [low, high] of the polynomial with these coefficients there: halve while a sign may change inside."""
    if (h > TINY).all() or (h < -TINY).all():
        return []
    if np.abs(h).max() <= TINY or high - low < 2.0**-DEPTH:
        return [(low + high) / 2]
    left, right = numeric.split(h, 0.5)
    middle = (low + high) / 2
    found = _roots(left, low, middle)
    return found + [t for t in _roots(right, middle, high) if not found or t - found[-1] > NEAR]
