"""Knot vectors: the usual ones, reading and checking them, finding the span of a parameter.

Knots t_0 <= t_1 <= ... <= t_m are numbers and are never rescaled. With the control points b_0, ..., b_n and degree p,
m = n+p+1; the domain of the curve is [t_p, t_{n+1}], and span k is the half-open interval [t_k, t_{k+1}).
"""

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, finish, one_arithmetic, quiet, read, shown, whole
from bezteach.numeric.dyadic import rational


def clamped(count, degree):
    """Knots 0, ..., 0, 1, 2, ..., m, ..., m for so many control points, degree+1 equal ones at each end.

    The curve starts at its first control point and ends at its last; with count = degree+1 it is a Bézier curve.

    >>> clamped(6, 2).tolist(), clamped(4, 3).tolist()
    ([0, 0, 0, 1, 2, 3, 4, 4, 4], [0, 0, 0, 0, 1, 1, 1, 1])

    The knots are Python integers. Raises ValueError for a degree that is no whole number or negative and a count that
    is none or below degree+1. Source: transcript, "knot vectors", quasi-uniform; "B-splines and Bézier curves".
    """
    degree = whole(degree, "degree p", 0)
    inner = np.arange(whole(count, "count", degree + 1) - degree + 1).astype(object)
    return np.concatenate([inner[:1].repeat(degree), inner, inner[-1:].repeat(degree)])


def uniform(count, degree):
    """Knots 0, 1, 2, ..., count+degree for so many control points; the domain is [degree, count].

    >>> uniform(3, 2).tolist()
    [0, 1, 2, 3, 4, 5]

    The knots are Python integers. Raises ValueError as `clamped` does. Source: transcript, "knot vectors", uniform.
    """
    degree = whole(degree, "degree p", 0)
    return np.arange(whole(count, "count", degree + 1) + degree + 1).astype(object)


def multiplicities(knots):
    """(values, times): the different knots in their order, and how many times each of them stands there.

    >>> values, times = multiplicities([0, 0, 0, 1, 2, 2, 3, 3, 3])
    >>> values.astype(str).tolist(), times.tolist()
    (['0', '1', '2', '3'], [3, 1, 2, 3])

    Where a knot stands s times, the curve is at least p-s times continuously differentiable. Raises ValueError for
    knots that are no finite numbers or decrease. Source: transcript, properties of the B-spline curve, continuity.
    """
    (knots,) = ordered(knots)
    first = np.flatnonzero(np.append(True, knots[1:] != knots[:-1]))
    return knots[first], np.diff(np.append(first, len(knots)))


@quiet
def averages(knots, degree):
    """The means (t_{i+1} + ... + t_{i+p}) / p, one for each control point b_i: shape (count,); Greville's abscissae.

    They are the control points of the curve x(t) = t, so the graph of a spline function has the points (mean, b_i).

    >>> averages(clamped(6, 2), 2).astype(str).tolist()
    ['0', '1/2', '3/2', '5/2', '7/2', '4']

    Exact knots give Fractions. Raises ValueError for a degree below 1 and for knots that are no finite numbers, are
    fewer than degree+2, decrease, or stand more than degree+1 times. Source: Greville; de Boor, A Practical Guide to
    Splines, 1978.
    """
    (knots,) = ordered(knots)
    degree = whole(degree, "degree p", 1)
    count = fitting(knots, degree)
    return finish(sum(knots[i : i + count] / degree for i in range(1, degree + 1)))


def span(knots, degree, t):
    """The index k of the span with t_k <= t < t_{k+1}, at the domain's end of the last span: shape t.shape.

    There the curve is one polynomial, and of all control points only b_{k-p}, ..., b_k determine it.

    >>> span([0, 0, 0, 1, 2, 3, 4, 4, 4], 2, [0, 1, 2.5, 4]).tolist()
    [2, 3, 4, 5]

    Raises ValueError for bad knots, an empty domain, and a t that is a symbol or outside the domain. Source:
    transcript, Cox-de Boor recursion, degree 0; Piegl and Tiller, The NURBS Book, A2.1.
    """
    knots, t = ordered(knots, read(t, "parameter t"))
    degree = whole(degree, "degree p", 0)
    ends = domain(knots, degree, fitting(knots, degree))
    return located(knots, inside(t, *ends).ravel(), ends[1:]).reshape(t.shape)[()]


def ordered(knots, *others):
    """Knots that do not decrease, as Fractions where they are exact, and the other arrays, all in one arithmetic."""
    knots, *others = one_arithmetic(read(knots, "parameter knots"), *others)
    if knots.ndim != 1:
        raise ValueError(f"knots have {knots.ndim} axes: one row of numbers is needed")
    if knots.dtype is not FLOAT:
        knots = rational(knots, "knot t")
    falls = np.flatnonzero(knots[1:] < knots[:-1])
    if falls.size:
        i = falls[0]
        after = f"t_{i} = {brief(knots[i])}"
        raise ValueError(f"knot t_{i + 1} = {brief(knots[i + 1])} is below {after}: knots must not decrease")
    return knots, *others


@quiet
def fitting(knots, degree):
    """The number of control points that such knots are for."""
    count = len(knots) - degree - 1
    if count < 1:
        raise ValueError(f"{len(knots)} knots are too few: degree {degree} needs at least {degree + 2}")
    crowded = np.flatnonzero(knots[degree + 1 :] == knots[:count])
    if crowded.size:
        knot = knots[crowded[0]]
        refuse(knot, int((knots == knot).sum()), degree)
    if knots.dtype is FLOAT and not np.isfinite(knots[-1] - knots[0]):
        raise ValueError("the knots are too far apart for float64: give the numbers as int or Fraction")
    return count


def brief(number):
    """A number in a few characters, fractions as p/q."""
    try:
        text = str(number)
    except ValueError:  # Python's bound on digits
        return "a very long number"
    return text if len(text) <= 40 else text[:37] + "..."


def refuse(knot, times, degree):
    """Raise because a knot stands too many times."""
    most = f"at degree {degree} it may stand at most {degree + 1} times"
    raise ValueError(f"knot {brief(knot)} stands {times} times: {most}")


def domain(knots, degree, count):
    """The ends t_p and t_{n+1} of the domain."""
    if count <= degree:
        raise ValueError(f"{count} control points are too few: degree {degree} needs at least {degree + 1}")
    first, last = knots[degree], knots[count]
    if first == last:
        raise ValueError(f"the domain [t_{degree}, t_{count}] is empty: both knots are {brief(first)}")
    return first, last


def inside(t, first, last):
    """The parameters, if all are numbers in [first, last]."""
    if t.dtype is FLOAT and t.min() >= first and t.max() <= last:
        return t
    ends = f"[{brief(first)}, {brief(last)}]"
    for value in read(t, "parameter t").ravel().tolist():
        if not getattr(value, "is_number", True):
            raise ValueError(f"parameter t is {shown(value)}: a symbol lies in no span of the knots")
        try:
            within = bool(first <= value <= last)
        except TypeError:
            incomparable(value)
        if not within:
            raise ValueError(f"parameter t is {shown(value)}: it must lie in the domain {ends}")
    return t


def incomparable(value):
    """Raise because SymPy cannot tell whether a number is above a knot."""
    raise ValueError(f"parameter t is {shown(value)}: it cannot be compared with the knots") from None


def located(knots, t, ends):
    """For each t of a row the k with t_k <= t < t_{k+1}, but at the ends the last k with t_k < t."""
    try:
        k = knots.searchsorted(t, "right") - 1
    except TypeError:
        incomparable(t.tolist()[0] if t.size == 1 else t.tolist())
    for end in ends:
        k[t == end] = knots.searchsorted(end) - 1
    return k


def named(knots, k, first, last):
    """The index of a span that was given, if it is between first and last and not empty."""
    k = whole(k, "span k", first, last)
    if knots[k] == knots[k + 1]:
        raise ValueError(f"span k is {k}: it is empty, t_{k} and t_{k + 1} are both {brief(knots[k])}")
    return k


def spline(points, knots, *others):
    """Points, knots, degree and the other arrays, checked and in one arithmetic, and whether the points were flat."""
    points, flat = control_points(points)
    knots, points, *others = ordered(knots, points, *others)
    count, degree = points.shape[-2], len(knots) - points.shape[-2] - 1
    if not 0 <= degree < count:
        fit = f"{count + 1} to {2 * count}"
        raise ValueError(f"{len(knots)} knots do not fit {count} control points: {fit} are needed, degree+1 more")
    domain(knots, degree, fitting(knots, degree))
    return points, knots, degree, flat, *others
