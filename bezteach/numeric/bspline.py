"""B-splines on arrays: exact numbers in, exact numbers out.

Points are rows, as everywhere: (n+1, d) is a curve, (n+1,) one coordinate, (N, n+1, d) a batch on the same knots. The
degree p is len(knots) - len(points) - 1, the domain [t_p, t_{n+1}]. At a knot values and derivatives are limits from
the right, at the domain's end from the left; with span=k they are those of the polynomial of span k at any t, which
may be a symbol then.

All of it is one affine step: steps with t evaluate, steps with the ends of a span give its Bézier points, a single
step inserts a knot, and the basis is the values of unit points.
"""

import numpy as np

from bezteach.numeric.arrays import drop, finish, parameter, plain, quiet, read, whole
from bezteach.numeric.knots import averages as averages
from bezteach.numeric.knots import clamped as clamped
from bezteach.numeric.knots import fitting, inside, located, named, ordered, refuse, spline
from bezteach.numeric.knots import multiplicities as multiplicities
from bezteach.numeric.knots import span as span
from bezteach.numeric.knots import uniform as uniform
from bezteach.numeric.piecewise import blocks, corners, diagonal, filled, level_zero, step, values


@quiet
def basis(knots, degree, t, span=None):
    """Values of the B-splines N_{0,p}, ..., N_{n,p} on the knots: shape t.shape + (n+1,).

    N_{i,0} is 1 on span i and 0 elsewhere, and with 0/0 := 0
    N_{i,p} = (t - t_i) / (t_{i+p} - t_i) N_{i,p-1} + (t_{i+p+1} - t) / (t_{i+p+1} - t_{i+1}) N_{i+1,p-1}.

    >>> from fractions import Fraction
    >>> basis(clamped(6, 2), 2, Fraction(3, 2)).astype(str).tolist()
    ['0', '1/8', '3/4', '1/8', '0', '0']

    Between the first and the last knot, which t may not pass, none is negative; on the domain [t_p, t_{n+1}] they sum
    to 1, beyond it they do not. At t_{n+1} and at the last knot they are limits from the left. Raises ValueError for
    bad knots, a degree that is no whole number or too high for them, a t beyond them, and a symbol without a span.
    Source: transcript, "B-spline basis functions", Cox-de Boor recursion.
    """
    knots, t = ordered(knots, read(t, "parameter t"))
    degree = whole(degree, "degree p", 0)
    count, shape, t = fitting(knots, degree), t.shape, t.ravel()
    if span is None:
        ends = knots[[count, -1]] if knots[degree] < knots[count] else knots[-1:]
        k = located(knots, inside(t, knots[0], knots[-1]), ends)
    else:
        k = np.full(t.size, named(knots, span, 0, len(knots) - 2))
    # degree more knots at each end make room for the neighbours that the first and the last span lack
    longer = np.concatenate([knots[:1].repeat(degree), knots, knots[-1:].repeat(degree)])
    rows = np.zeros((t.size, count + 2 * degree), knots.dtype)
    units = np.eye(degree + 1, dtype=knots.dtype)[..., None]
    for part in blocks(0, t.size, (degree + 1) ** 2):
        local = longer.take(k[part] + np.arange(1, 2 * degree + 1)[:, None])
        columns = k[part, None] + np.arange(degree + 1)
        np.put_along_axis(rows[part], columns, diagonal(units, local, t[part]).T, axis=1)
    return finish(rows[:, degree : degree + count].reshape(*shape, count))


def evaluate(points, knots, t, span=None):
    """Points p(t) = sum of N_{i,p}(t) b_i of the curve: shape t.shape + (d,), for a batch (N,) + t.shape + (d,).

    >>> from fractions import Fraction
    >>> evaluate([0, 2, 4, 0, 4, 2], clamped(6, 2), [0, Fraction(3, 2), 4]).astype(str).tolist()
    ['0', '13/4', '2']

    In float64 the error is a few units in the last place of max|b|. Raises ValueError for points or t that are no
    finite real numbers; for knots that are none, decrease, do not fit the points, stand more than p+1 times or leave no
    domain; and, unless a span that is not empty is given, for a t that is a symbol or outside the domain.
    Source: transcript, "B-spline curves"; de Boor, A Practical Guide to Splines, 1978.
    """
    return derivative(points, knots, t, 0, span)


@quiet
def derivative(points, knots, t, r=1, span=None):
    """Values of the r-th derivative: shape t.shape + (d,), for a batch (N,) + t.shape + (d,).

    The derivative has the control points p (b_i - b_{i-1}) / (t_{i+p} - t_i) and degree p-1.

    >>> derivative([0, 2, 4, 0, 4, 2], clamped(6, 2), [0, 1, 4]).astype(str).tolist()
    ['4', '2', '-4']

    r > p gives 0, r = 0 the curve. Raises ValueError as `evaluate` does, and for an r that is no whole number or
    negative. Source: Piegl and Tiller, The NURBS Book, section 3.3.
    """
    t = t if span is None and plain(t, 1) else read(t, "parameter t")
    points, knots, degree, flat, t = spline(points, knots, t)
    *lead, count, d = points.shape
    if span is None:
        inside(t, knots[degree], knots[count])
    else:
        span = named(knots, span, degree, count - 1)
    if whole(r, "order r", 0) <= degree:
        rows = values(points, knots, degree, t.ravel(), r, span)
    else:
        rows = np.zeros((*lead, d, t.size), points.dtype)
    return drop(rows.mT.reshape(*lead, *t.shape, d), flat)


@quiet
def de_boor(points, knots, t, span=None):
    """The levels of de Boor's triangle at one t, a tuple of p+1 arrays: level r has shape (p+1-r, d).

    d_i^r = (1-w) d_{i-1}^{r-1} + w d_i^{r-1} with w = (t - t_i) / (t_{i+p+1-r} - t_i). With t in span k, level 0 is the
    control points b_{k-p}, ..., b_k and level p the point p(t).

    >>> from fractions import Fraction
    >>> for level in de_boor([0, 2, 4, 0, 4, 2], clamped(6, 2), Fraction(3, 2)):
    ...     print(*level)
    2 4 0
    7/2 3
    13/4

    Raises ValueError as `evaluate` does, and for a t that is no single number. Source: de Boor, A Practical Guide to
    Splines, 1978.
    """
    points, knots, degree, flat, t = spline(points, knots, parameter(t))
    count = points.shape[-2]
    if span is None:
        k = located(knots, inside(t, knots[degree], knots[count]).ravel(), knots[count : count + 1])
    else:
        k = np.full(1, named(knots, span, degree, count - 1))
    level, local = level_zero(points, knots, k, degree)
    levels = [level]
    for _ in range(degree):
        levels.append(step(levels[-1], local, t))
    return tuple(finish(level[..., 0].mT, flat) for level in levels)


@quiet
def blossom(points, knots, span, *arguments):
    """f(u_1, ..., u_p) of the polynomial on a span: symmetric, affine in each argument, f(t, ..., t) = p(t).

    It is de Boor's triangle with another argument at each level. Shape (d,), for a batch (N, d).

    >>> [str(blossom([0, 2, 4, 0, 4, 2], clamped(6, 2), 3, *u)) for u in [(0, 1), (1, 1), (1, 2), (2, 2)]]
    ['2', '3', '4', '2']

    So the control points are its values at neighbouring knots, b_i = f(t_{i+1}, ..., t_{i+p}), and the Bézier points
    of the span those at its ends. Raises ValueError as `evaluate` does, and for arguments that are not p or no single
    numbers. Source: Ramshaw, Blossoms are polar forms, Computer Aided Geometric Design 6, 1989.
    """
    arguments = [parameter(u, f"u_{i}") for i, u in enumerate(arguments, 1)]
    points, knots, degree, flat, *arguments = spline(points, knots, *arguments)
    k = np.full(1, named(knots, span, degree, points.shape[-2] - 1))
    if len(arguments) != degree:
        raise ValueError(f"a blossom of degree {degree} has {degree} arguments: {len(arguments)} are given")
    level, local = level_zero(points, knots, k, degree)
    for u in arguments:
        level = step(level, local, u)
    return finish(level[..., 0, 0], flat)


@quiet
def insert(points, knots, t, times=1):
    """(points, knots) of the same curve with t so many times more among the knots: shapes (n+1+times, d), (m+1+times,).

    The first step of de Boor's triangle is Boehm's algorithm: p points of level 1 take the place of p-1.

    >>> points, knots = insert([0, 2, 4, 0, 4, 2], clamped(6, 2), 1)
    >>> points.astype(str).tolist(), knots.astype(str).tolist()
    (['0', '2', '3', '4', '0', '4', '2'], ['0', '0', '0', '1', '1', '2', '3', '4', '4', '4'])

    A knot that stands p times is a point of the curve; p+1 times, it falls into two curves there. The ends of the
    domain may be inserted too, and p+1 knots there clamp the curve. Raises ValueError as `evaluate` does, for a t that
    is no single number, a number of times that is none or negative, and a knot that would stand more than p+1 times.
    Source: Boehm, Inserting new knots into B-spline curves, Computer-Aided Design 12, 1980; transcript, "flexibility".
    """
    points, knots, degree, flat, t = spline(points, knots, parameter(t))
    inside(t, knots[degree], knots[points.shape[-2]])
    stands = int((knots == t).sum()) + whole(times, "times", 0)
    if stands > degree + 1:
        refuse(t[()], stands, degree)
    points, knots = points.copy(), knots.copy()
    for _ in range(times):
        count = points.shape[-2]
        (k,) = spot = located(knots, t.reshape(1), knots[count : count + 1])
        new = step(*level_zero(points, knots, spot, degree), t)[..., 0].mT
        points = np.concatenate([points[..., : k - degree + 1, :], new, points[..., k:, :]], axis=-2)
        (knots,) = ordered(np.insert(knots, k + 1, t))
    return finish(points, flat), knots


@quiet
def to_bezier(points, knots):
    """(segments, breaks): Bézier points of all K spans that are not empty, (K, p+1, d), and the knots between, (K+1,).

    Neighbours share a point wherever the curve does not jump. A batch gives (N, K, p+1, d).

    >>> segments, breaks = to_bezier([0, 2, 4, 0, 4, 2], clamped(6, 2))
    >>> segments.astype(str).tolist(), breaks.astype(str).tolist()
    ([['0', '2', '3'], ['3', '4', '2'], ['2', '0', '2'], ['2', '4', '2']], ['0', '1', '2', '3', '4'])

    Exact points give Fractions. Raises ValueError as `evaluate` does. Source: transcript, "B-splines and Bézier
    curves"; Ramshaw as for `blossom`.
    """
    points, knots, degree, flat = spline(points, knots)
    spans = filled(knots, degree, points.shape[-2])
    segments = corners(points, knots, degree, spans)
    return finish(segments.swapaxes(-1, -3), flat), np.append(knots[spans], knots[spans[-1] + 1])
