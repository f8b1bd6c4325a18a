"""How smoothly two curves meet, and cubics through data points that meet smoothly."""

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, drop, finish, one_arithmetic, quiet, read, shown
from bezteach.numeric.derivatives import differences
from bezteach.numeric.exact import exact, is_positive, is_zero, tidy


class Condition(NamedTuple):
    """Whether a join is of one class (None: not decided), and what the class's own equation leaves over."""

    holds: bool | None
    residual: Any


class Continuity(NamedTuple):
    """The report of `continuity`: five classes, the factors of the two geometric ones, the curves without a tangent."""

    C0: Condition
    G1: Condition
    C1: Condition
    G2: Condition
    C2: Condition
    beta: Any
    gamma: Any
    vanishing: tuple[str, ...]

    @property
    def classes(self):
        """The names of the classes that hold."""
        return tuple(name for name in ("C0", "G1", "C1", "G2", "C2") if getattr(self, name).holds)


def continuity(left, right, lengths=(1, 1)):
    """How smoothly the curve `right`, (m+1, d), goes on from `left`, (n+1, d), on intervals of these two lengths.

    Let p, p', p'' be where the left curve ends and q, q', q'' where the right one starts, with the derivatives in the
    common parameter: p' is n times the last edge over the length. In the report, a `Continuity`, every class includes
    the lower ones, and its residual, in the shape of a point, is what its own equation leaves over:

    * C0: q - p. C1: q' - p'. C2: q'' - p''.
    * G1: q' = beta p' for some beta > 0. The residual is the way to the nearest such vector: q' - beta p' with
      beta = p'.q' / p'.p', but all of q' if that is not positive.
    * G2: q'' = beta^2 p'' + gamma p' for any gamma, that is one curvature, in space one curvature vector. The residual
      is what is left with the nearest gamma: it is perpendicular to p'.

    >>> report = continuity([[0, 0], [1, 0], [2, 0]], [[2, 0], [4, 0], [6, 3]])
    >>> report.classes, str(report.beta)
    (('C0', 'G1'), '2')
    >>> report.C1.residual.astype(str).tolist(), report.G2.residual.astype(str).tolist()
    (['2', '0'], ['0', '6'])
    >>> continuity([[0, 0], [1, 0], [2, 0]], [[2, 0], [4, 0], [6, 3]], (1, 2)).classes
    ('C0', 'G1', 'C1')

    Where p' or q' is 0 there is no tangent to compare: `vanishing` names "left", "right" or both, and beta, gamma and
    all of G1 and G2 are None; C1 and C2, mere equations, are decided. Exact numbers give Fractions. Floats are judged
    as the fractions that they are, so a rounding error counts, and give float64. Where it depends on symbols whether a
    class holds, that is None; lengths are taken to be positive and p', q' not to be 0, unless the contrary is certain.
    Raises ValueError for points or lengths that are no finite real numbers, a batch, different numbers of coordinates,
    lengths that are not two or not positive, and residuals beyond float64. Source: games, "conditions for joining two
    Bézier curves"; transcript, "joining Bézier curves".
    """
    left, right, lengths, flat = one_join(left, right, lengths)
    h, k = exact(lengths)
    before = [tidy(differences(exact(left), r)[-1] / h**r) for r in range(3)]
    after = [tidy(differences(exact(right), r)[0] / k**r) for r in range(3)]

    def given_back(values):  # a vector, or a factor without axes
        values = np.asarray(values, object)
        values = one_arithmetic(values, left)[0] if left.dtype is FLOAT else values
        return drop(values, flat) if values.ndim else values[()]

    return judged(before, after, given_back)


@quiet
def catmull_rom(data):
    """Cubics through N data points by the one-sixth rule: control points (N-1, 4, d), for a batch (B, N-1, 4, d).

    Beside D_i stand D_i - c/6 and D_i + c/6, where c = D_{i+1} - D_{i-1} is the chord of its neighbours; beyond the
    ends D_{-1} = 2 D_0 - D_1 and likewise. The curve is C1, and D_i enters at most four cubics.

    >>> catmull_rom([0, 6, 6]).astype(str).tolist()
    [['0', '2', '5', '6'], ['6', '7', '6', '6']]

    Exact data give Fractions. Raises ValueError for data that are no finite real numbers, fewer than two points, and
    numbers beyond float64. Source: transcript, "joining Bézier curves", the one-sixth rule; games, "construction of
    interpolating cubic curves".
    """
    data, flat = data_points(data)
    first, last = 2 * data[..., :1, :] - data[..., 1:2, :], 2 * data[..., -1:, :] - data[..., -2:-1, :]
    longer = np.concatenate([first, data, last], axis=-2)
    return finish(cubics(data, (longer[..., 2:, :] - longer[..., :-2, :]) / 6), flat)


@quiet
def natural(data):
    """The natural cubic spline through N data points: control points (N-1, 4, d), for a batch (B, N-1, 4, d).

    Each cubic runs on an interval of length 1; they meet with C2, and at both ends the second derivative is 0. Every
    data point enters every cubic.

    >>> natural([0, 6, 6]).astype(str).tolist()
    [['0', '5/2', '5', '6'], ['6', '7', '13/2', '6']]

    Exact data give Fractions. Raises ValueError for data that are no finite real numbers, fewer than two points, and
    numbers beyond float64. Source: games, "interpolating with piecewise Bézier curves", C2.
    """
    data, flat = data_points(data)
    return finish(cubics(data, natural_velocities(data) / 3), flat)


def one_join(left, right, lengths):
    """The arguments of `continuity` in one arithmetic, and whether the points were flat."""
    (left, flat), (right, also_flat) = control_points(left, "control point P"), control_points(right, "control point Q")
    for name, points in (("left", left), ("right", right)):
        if points.ndim == 3:
            raise ValueError(f"the {name} curve is a batch of {len(points)}: a join is of two single curves")
    here, there = "numbers" if flat else left.shape[1], "numbers" if also_flat else right.shape[1]
    if here != there:
        raise ValueError(f"coordinates of a point: {here} in the left curve, {there} in the right: they must agree")
    lengths = read(lengths, "parameter lengths")
    if lengths.shape != (2,):
        raise ValueError(f"parameter lengths has shape {lengths.shape}: two numbers are needed, one for each curve")
    for i, length in enumerate(exact(lengths)):
        if is_positive(length) is False:
            raise ValueError(f"parameter lengths[{i}] is {shown(lengths.tolist()[i])}: it must be positive")
    return *one_arithmetic(left, right, lengths), flat


def judged(before, after, given_back):
    """The `Continuity` of exact points, first and second derivatives; `given_back` makes results of exact vectors."""
    (p, p1, p2), (q, q1, q2) = before, after

    def condition(residual, *others):
        residual = tidy(residual)
        return Condition(every(*others, *map(is_zero, residual)), given_back(residual))

    c0 = condition(q - p)
    c1 = condition(q1 - p1, c0.holds)
    c2 = condition(q2 - p2, c1.holds)
    vanishing = tuple(name for name, first in (("left", p1), ("right", q1)) if every(*map(is_zero, first)))
    if vanishing:
        open_ = Condition(None, None)
        return Continuity(c0, open_, c1, open_, c2, None, None, vanishing)
    beta = tidy(p1.dot(q1) / p1.dot(p1))
    bend = q2 - beta**2 * p2
    gamma = tidy(p1.dot(bend) / p1.dot(p1))
    onward = is_positive(beta)
    g1 = condition(q1 if onward is False else q1 - beta * p1, c0.holds, onward)
    g2 = condition(bend - gamma * p1, g1.holds)
    return Continuity(c0, g1, c1, g2, c2, given_back(beta), given_back(gamma), vanishing)


def every(*answers):
    """Whether all of the answers are True: False if one is, otherwise None if one is."""
    return False if False in answers else None if None in answers else True


def data_points(data):
    """Two data points or more, ready for division, and whether they were flat."""
    data, flat = control_points(data, "data point D")
    if data.shape[-2] < 2:
        raise ValueError("there is 1 data point: at least 2 are needed")
    return data if data.dtype is FLOAT else exact(data), flat


def cubics(data, thirds):
    """D_i, D_i + w_i, D_{i+1} - w_{i+1}, D_{i+1} with a third w_i of the velocity at each data point."""
    start, end = data[..., :-1, :], data[..., 1:, :]
    return np.stack([start, start + thirds[..., :-1, :], end - thirds[..., 1:, :], end], axis=-2)


def natural_velocities(data):
    """The v with v_{i-1} + 4 v_i + v_{i+1} = 3 (D_{i+1} - D_{i-1}), 2 v_0 + v_1 = 3 (D_1 - D_0) and so at the end."""
    longer = np.concatenate([data[..., :1, :], data, data[..., -1:, :]], axis=-2)
    v = 3 * (longer[..., 2:, :] - longer[..., :-2, :])
    last = data.shape[-2] - 1
    pivots = [2.0 if data.dtype is FLOAT else Fraction(2)]
    for i in range(1, last + 1):
        v[..., i, :] -= v[..., i - 1, :] / pivots[-1]
        pivots.append((4 if i < last else 2) - 1 / pivots[-1])
    v[..., last, :] /= pivots[last]
    for i in reversed(range(last)):
        v[..., i, :] = (v[..., i, :] - v[..., i + 1, :]) / pivots[i]
    return v
