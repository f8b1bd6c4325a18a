"""Derivatives of a curve as curves, and its curvature."""

from fractions import Fraction
from functools import reduce
from math import frexp, inf, isqrt, perm

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, drop, finish, one_arithmetic, quiet, read, whole
from bezteach.numeric.basis import basis, elevation
from bezteach.numeric.evaluation import values_at

BLOCK = 2**15  # parameters at a time, so that what is in between stays in the processor's cache


@quiet
def hodograph(points, r=1):
    """Control points of the r-th derivative, n!/(n-r)! times the r-th differences: degree n-r, shape (n-r+1, d).

    >>> hodograph([[0, 0], [1, 3], [2, 1], [3, 3]]).tolist()
    [[3, 9], [3, -6], [3, 6]]

    r = 0 is the curve itself, r > n the zero curve of degree 0. Raises ValueError for points that are no finite real
    numbers and an r that is no whole number or negative. Source: deck, section 2.2, hodograph and higher derivatives.
    """
    points, flat = control_points(points)
    return finish(differences(points, whole(r, "order r", 0)), flat)


def differences(points, r):
    """hodograph(points, r) without the checks."""
    n = points.shape[-2] - 1
    if r > n:
        return np.zeros_like(points[..., :1, :])
    factor = perm(n, r)
    if points.dtype is FLOAT:
        factor = float(factor) if factor.bit_length() < 1024 else inf
    return factor * np.diff(points, r, axis=-2)


@quiet
def derivative(points, t, r=1):
    """Values of the r-th derivative: shape t.shape + (d,), for a batch (N,) + t.shape + (d,).

    >>> derivative([[0, 0], [1, 3], [2, 1], [3, 3]], [0, 1]).tolist()
    [[3, 9], [3, 6]]

    Raises ValueError as `hodograph` and `evaluate` do. Source: deck, section 2.2, derivatives.
    """
    points, flat = control_points(points)
    points, t = one_arithmetic(points, read(t, "parameter t"))
    return drop(values_at(finish(differences(points, whole(r, "order r", 0))), t), flat)


@quiet
def curvature(points, t):
    """Curvature at t: shape t.shape, for a batch (N,) + t.shape; signed in the plane, |p' x p''| / |p'|^3 in space.

    In the plane it is (x' y'' - y' x'') / (x'^2 + y'^2)^(3/2), positive where the curve turns left.

    >>> float(curvature([[1, 0], [1, 1], [0, 1]], 0))
    0.5

    The result is float64, of exact points the one next to the exact value; of symbols it is an expression. Raises
    ValueError for points that have not 2 or 3 coordinates or are no finite real numbers, for a t that is none, and
    where p'(t) = 0, in float64 up to rounding. Source: deck, section 2.2, curvature at the ends.
    """
    points, _ = control_points(points)
    if points.shape[-1] not in (2, 3):
        raise ValueError(f"control points have {points.shape[-1]} coordinates: curvature needs 2 or 3")
    points, t = one_arithmetic(points, read(t, "parameter t"))
    exponent = 0
    if points.dtype is FLOAT:  # curvature is a reciprocal length: a power of two keeps its factors in range
        exponent = -frexp(abs(points).max())[1]
        points = np.ldexp(points, exponent)
    edges, bends, places = differences(points, 1), differences(points, 2), t.ravel()
    if points.dtype is not FLOAT:
        values = exact_curvature(values_at(edges, places), values_at(bends, places), places)
    else:
        parts = np.array_split(places, -(-places.size // BLOCK))
        values = np.ldexp(np.concatenate([quotient(edges, bends, part) for part in parts], axis=-1), exponent)
    return finish(values.reshape((*points.shape[:-2], *t.shape)))[()]


def quotient(edges, bends, t):
    """Curvature in float64 at a row of parameters, of the control points of the first and the second derivative."""
    d, missing = edges.shape[-1], edges.shape[-2] - bends.shape[-2]
    raised = elevation(bends.shape[-2] - 1, missing) @ bends
    both = values_at(np.concatenate([edges, raised], axis=-1), t)  # in one degree they share their powers of t
    first, second = both[..., :d], both[..., d:]
    squares = sum(first[..., c] ** 2 for c in range(d))
    if squares.min() < 1e-180:  # divide before the product vanishes
        speed = np.hypot.reduce(first, axis=-1)
        refuse_rest(edges, speed, t)
        return reduce(np.hypot, cross(first / speed[..., None], second / speed[..., None])) / speed
    speed = np.sqrt(squares)
    refuse_rest(edges, speed, t)
    return reduce(np.hypot, cross(first, second)) / (squares * speed)  # in the plane one number with its sign


def cross(u, v):
    """The components of the cross product: one in the plane, three in space."""
    pairs = [(0, 1)] if u.shape[-1] == 2 else [(1, 2), (2, 0), (0, 1)]
    return [u[..., i] * v[..., j] - u[..., j] * v[..., i] for i, j in pairs]


def refuse_rest(edges, speed, t):
    """Raise where float64 cannot tell p'(t) from 0: |p'| is below the rounding errors of the sum of B_i h_i."""
    lengths = np.hypot.reduce(edges, axis=-1)
    n = lengths.shape[-1] - 1
    unit = 4 * (n + 2) * np.finfo(float).eps
    ends = np.array([t.min(), t.max()])
    growth = (abs(ends) + abs(1 - ends)).max() ** n  # of the sum of |B_i|, which is 1 on [0, 1]
    least = unit * growth * lengths.max()
    if speed.min() <= least:
        doubtful = (speed <= least).reshape(-1, t.size).any(axis=0)
        t = t[doubtful]
        rest = speed[..., doubtful] <= unit * lengths @ abs(basis(n, t)).T
        if rest.any():
            at_rest(t[np.argwhere(rest)[0, -1]])


def at_rest(t):
    raise ValueError(f"p'(t) = 0 at t = {t}: the curve has no curvature there")


def exact_curvature(first, second, t):
    """Curvature of exact vectors: float64 of rational numbers, an expression of symbols."""
    for place in np.ndindex(first.shape[:-1]):
        if all(x == 0 or (hasattr(x, "expand") and x.expand() == 0) for x in first[place]):
            at_rest(t[place[-1]])
    turns, speed2 = cross(first, second), (first * first).sum(axis=-1)
    turn2 = sum(c * c for c in turns)
    if all(type(x) in (int, Fraction) for x in (*turn2.flat, *speed2.flat)):
        size = np.frompyfunc(lambda a, b: root(Fraction(a) / Fraction(b) ** 3), 2, 1)(turn2, speed2)
        return size.astype(float) * (np.where(turns[0] < 0, -1.0, 1.0) if len(turns) == 1 else 1.0)
    zero = 0 * speed2.sum()  # one symbol among the numbers makes all of them SymPy's
    turn = turns[0] if len(turns) == 1 else (turn2 + zero) ** Fraction(1, 2)
    return (turn + zero) / (speed2 + zero) ** Fraction(3, 2)


def root(square):
    """The square root of a Fraction in float64, whatever its size: from 64 bits of an exact integer root."""
    p, q = square.numerator, square.denominator
    shift = max(0, 64 + (q.bit_length() - p.bit_length()) // 2)
    try:
        return float(Fraction(isqrt((p << 2 * shift) // q), 1 << shift))
    except OverflowError:
        return inf
