"""Where two plane curves meet: boxes that lie apart, and halving."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bezteach.numeric.arrays import control_points, drop, shown
from bezteach.numeric.curve import segment
from bezteach.numeric.dyadic import common, halves, integers, rational, rounds

MOST = 2048  # pairs of parts that may wait at once


class Crossing(NamedTuple):
    """Where two curves may meet: an interval of parameters (start, end) of each; start = end is the parameter itself.

    certain: in these intervals they meet once, and cross. Else nobody knows yet: they may touch, meet several times, or
    pass each other closely.
    """

    one: tuple[Fraction, Fraction]
    other: tuple[Fraction, Fraction]
    certain: bool


def box(points):
    """The smallest and the largest coordinates of the control points, shape (2, d); of a batch, (N, 2, d).

    For t in [0, 1] the curve stays between them, as it stays in the convex hull.

    >>> box([(0, 0), (1, 3), (2, 1), (3, 3)]).tolist()
    [[0, 0], [3, 3]]

    Raises ValueError for points that are no finite real numbers, and for symbols. Source: deck, 1.2, property 5 of the
    curve, convex hull; notes, section 2.3.5, curve range.
    """
    points, flat = control_points(points)
    symbols = [x for x in points.flat if not getattr(x, "is_number", True)]
    if symbols:
        raise ValueError(f"control points hold {shown(symbols[0])}: only numbers have a smallest and a largest")
    return drop(np.stack([points.min(axis=-2), points.max(axis=-2)], axis=-2), flat)


def intersections(one, other, tolerance=Fraction(1, 2**20)):
    """Where two plane curves, (n+1, 2) and (m+1, 2), meet: a list of `Crossing`, in the order of the first parameter.

    Parts whose boxes lie apart do not meet. Of two others the larger is halved, until both are no longer than the
    tolerance; neighbours among the pairs left over are one answer. Every point that the curves share for parameters in
    [0, 1] is in one of the answers; an answer that is not certain may hold none.

    >>> parabola, line = [(0, 0), (1, 2), (2, 0)], [(0, 0), (3, 1)]
    >>> for crossing in intersections(parabola, line, Fraction(1, 64)):
    ...     print(*map(str, crossing.one), crossing.certain)
    0 0 True
    53/64 27/32 True

    Certain is shown so: each edge of the one part's polygon turns to the same side of each edge of the other's, hence
    they meet at most once; and the ends of each part lie on both sides of a strip around the other, hence they do meet.

    Takes ints, Fractions and floats; floats count as the fractions that they are. All is computed exactly, and answered
    in Fractions. Raises ValueError for other numbers and shapes, for a tolerance that is not positive or below 2^-1000,
    and where too many pairs are left over: the curves run along each other. Source: deck, 1.2, property 5 of the curve,
    convex hull, to exclude an intersection; J. Lane and R. Riesenfeld, IEEE PAMI 2, 1980; for strips beside boxes
    T. Sederberg and T. Nishita, Curve intersection using Bézier clipping, Computer-Aided Design 22, 1990.
    """
    curves, depth = [plane(one, "first"), plane(other, "second")], rounds(tolerance)
    scale = common(*curves) << max(map(len, curves)) * depth
    first, second = (Part(0, 2**depth, integers(points, scale)) for points in curves)
    groups = clusters(near(first, second))
    places = [rectangle(group) for group in groups]
    return sorted(crossing(group, place, places, curves, 2**depth) for group, place in zip(groups, places, strict=True))


def plane(points, which):
    """The control points of a plane curve as Fractions."""
    values, flat = control_points(points)
    if flat or values.ndim != 2 or values.shape[1] != 2:
        raise ValueError(f"the {which} curve is not one curve in the plane: control points (x, y) are needed")
    return rational(values, "control point b")


def cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


@dataclass(frozen=True, eq=False)
class Part:
    """A part of a curve: its parameters, in units of the smallest part, and its control points, integers."""

    start: int
    end: int
    points: np.ndarray

    @cached_property
    def box(self):
        return [(min(side), max(side)) for side in self.points.T.tolist()]

    @cached_property
    def size(self):
        return max(high - low for low, high in self.box)

    @cached_property
    def strip(self):
        return self.along(self.points)

    def along(self, points):
        """The least and the greatest height of points over the line through both ends of this part."""
        heights = cross(self.points[-1] - self.points[0], points).tolist()
        return min(heights), max(heights)

    @cached_property
    def halves(self):
        middle = (self.start + self.end) // 2
        left, right = halves(self.points)
        return Part(self.start, middle, left), Part(middle, self.end, right)


def apart(p, q):
    """Whether boxes, or strips along one of the parts, show that the hulls of two parts have no point in common."""
    if any(map(disjoint, p.box, q.box)):
        return True
    return disjoint(p.strip, p.along(q.points)) or disjoint(q.strip, q.along(p.points))


def disjoint(one, other):
    return one[1] < other[0] or other[1] < one[0]


def near(first, second):
    """The pairs of smallest parts that are not apart."""
    waiting, found = [(first, second)], []
    while waiting:
        left = [pair for pair in waiting if not apart(*pair)]
        found += [pair for pair in left if all(part.end - part.start == 1 for part in pair)]
        waiting = [child for pair in left for child in children(*pair)]
        if len(found) + len(waiting) > MOST:
            raise ValueError(
                f"more than {MOST} pairs of parts are left over: the curves run along each other, or the tolerance "
                "is too small for how closely they touch"
            )
    return found


def children(p, q):
    """The pairs that halving makes: of the two parts that are not the smallest yet, the larger is halved."""
    able = [part for part in (p, q) if part.end - part.start > 1]
    if not able:
        return []
    if max(able, key=lambda part: part.size) is p:
        return [(half, q) for half in p.halves]
    return [(p, half) for half in q.halves]


def clusters(pairs):
    """The pairs in groups: in one group neighbours, whose parameters touch on both curves, and their neighbours."""
    left, groups = {(p.start, q.start): (p, q) for p, q in pairs}, []
    while left:
        group = [left.pop(next(iter(left)))]
        for p, q in group:  # it grows while it is read
            around = [(p.start + i, q.start + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
            group += [left.pop(place) for place in around if place in left]
        groups.append(group)
    return groups


def rectangle(group):
    """((start, end) on the first curve, (start, end) on the second) of a group of pairs."""
    sides = zip(*group, strict=True)
    return tuple((min(p.start for p in side), max(p.end for p in side)) for side in sides)


def crossing(group, place, places, curves, unit):
    """The answer for a group of pairs, judged with some room around its place, in which no other place may be."""
    wider = [(max(start - 1, 0), min(end + 1, unit)) for start, end in place]
    alone = all(any(map(disjoint, wider, other)) for other in places if other is not place)
    p, q = (segment(c, *(Fraction(t, unit) for t in side)) for c, side in zip(curves, wider, strict=True))
    met = hit(group)
    certain = alone and once(p, q) and (met is not None or (straddles(p, q) and straddles(q, p)))
    if certain and met is not None:
        place = [(t, t) for t in met]
    (start, end), (begin, stop) = [tuple(Fraction(t, unit) for t in side) for side in place]
    return Crossing((start, end), (begin, stop), certain)


def hit(group):
    """Parameters at which ends of two parts are one point, None if there are none."""
    for p, q in group:
        for s, at in ((p.start, 0), (p.end, -1)):
            for t, by in ((q.start, 0), (q.end, -1)):
                if (p.points[at] == q.points[by]).all():
                    return s, t
    return None


def once(p, q):
    """Whether each edge of q turns to the same side of each edge of p: then the curves have one common point at most.

    From one common point to another both would go the same way, p by a multiple of a mean of its edges and q of its
    own; but such means, too, turn to one side of each other, so they are not parallel.
    """
    turns = cross(np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None])
    return turns.size > 0 and bool((turns > 0).all() or (turns < 0).all())


def straddles(p, q):
    """Whether the ends of p lie strictly on both sides of the strip along q that holds q's control points.

    If p straddles q and q straddles p, they meet: the theorem of Poincaré and Miranda, on the rectangle of parameters.
    """
    chord = q[-1] - q[0]
    strip, ends = cross(chord, q), sorted([cross(chord, p[0]), cross(chord, p[-1])])
    return ends[0] < strip.min() and strip.max() < ends[1]
