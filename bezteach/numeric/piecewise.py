"""The affine steps of de Boor's algorithm, at many parameters at once, and a table of polynomials for very many.

On span k the curve is a polynomial p with a blossom f: symmetric, affine in each argument, f(t, ..., t) = p(t).
A level holds the values of f at some arguments and each run of neighbouring knots, an array (..., q+1, m) for m
parameters. Level 0 is the control points, b_i = f(t_{i+1}, ..., t_{i+p}); a step puts one more argument in the place
of a knot. The knots that it divides by lie on both sides of the span, so that nothing is divided by 0.
"""

from functools import lru_cache

import numpy as np

from bezteach.numeric.arrays import FLOAT, finish
from bezteach.numeric.basis import frozen, to_power
from bezteach.numeric.curve import segment
from bezteach.numeric.knots import located

BLOCK = 2**15  # numbers at a time, so that they stay in the processor's cache
FEW = 1000  # parameters below which the count of calls decides
HIGHEST = 6  # degree up to which powers about the middle of a span lose no digits
LONG = 1000  # parameters for each span from which it is worth while to see whether they are sorted


def level_zero(points, knots, span, degree, r=0):
    """Level 0 of the r-th derivative, r <= p, for a row of spans, (..., d, p-r+1, m), and the knots around, (2p, m).

    The curve's own are the control points that enter there; a step with the vector 1 as argument is a derivative.
    """
    level = points.mT.take(span + np.arange(-degree, 1)[:, None], axis=-1)
    local = knots.take(span + np.arange(1 - degree, degree + 1)[:, None])
    for _ in range(r):
        left, right = around(level, local)
        level = len(left) * np.diff(level, axis=-2) / (right - left)
    return level, local


def around(level, local):
    """The knots in which neighbours of a level differ, each (q, m): that of the one before and that of the other."""
    p, q = len(local) // 2, level.shape[-2] - 1
    return local[p - q : p], local[p : p + q]


def step(level, local, u):
    """The next level, with the argument u: neighbours are blended as u lies between the knots in which they differ."""
    left, right = around(level, local)
    share = (u - left) / (right - left)
    blend = (1 - share) * level[..., :-1, :]
    blend += share * level[..., 1:, :]
    return blend


def filled(knots, degree, count):
    """The spans of the domain that are not empty."""
    return degree + np.flatnonzero(knots[degree:count] < knots[degree + 1 : count + 1])


def corners(points, knots, degree, spans, r=0):
    """Bézier points of the r-th derivative, r <= p, on each of the spans: (..., d, p-r+1, K)."""
    parts = blocks(0, len(spans), points.size // points.shape[-2] * (degree + 1))
    return np.concatenate([ends(*level_zero(points, knots, spans[part], degree, r)) for part in parts], axis=-1)


def ends(level, local):
    """f(a, ..., a, b, ..., b) with each number of times the end b of the span [a, b], in the shape of level 0."""
    found, p = [], len(local) // 2
    for j in reversed(range(level.shape[-2])):
        end = level
        for _ in range(j):
            end = step(end, local, local[p])
        found.append(end[..., 0, :])
        level = step(level, local, local[p - 1]) if j else level
    return np.stack(found[::-1], axis=-2)


def blocks(start, stop, width):
    """Slices of a row of parameters or spans, short enough for the cache if each of them takes so many numbers."""
    size = max(1, BLOCK // width)
    return [slice(k, min(k + size, stop)) for k in range(start, stop, size)]


def values(points, knots, degree, t, r=0, span=None):
    """Finite values (..., d, m) of the r-th derivative, r <= p, at m parameters, all in one span if it is given."""
    count = points.shape[-2]
    spans = filled(knots, degree, count)
    if t.dtype is FLOAT and span is None and degree - r <= HIGHEST and t.size > FEW + len(spans):
        powers = about_middle(degree - r) @ corners(points, knots, degree, spans, r)
        if np.isfinite(np.vdot(powers, powers)):  # then all values are: no term is larger than its coefficient
            return tabulated(powers, knots[spans], knots[spans + 1], t)
    k = located(knots, t, knots[count : count + 1]) if span is None else np.full(t.size, span)
    parts = blocks(0, t.size, points.size // count * (degree + 1))
    found = [diagonal(*level_zero(points, knots, k[part], degree, r), t[part]) for part in parts]
    return finish(np.concatenate(found, axis=-1))


def diagonal(level, local, t):
    """f(t, ..., t) from level 0."""
    while level.shape[-2] > 1:
        level = step(level, local, t)
    return level[..., 0, :]


def tabulated(powers, starts, ends, t):
    """values in float64 from the coefficients of the powers of x - 1/2 on each span, where x goes from 0 to 1."""
    *lead, n, count = powers.shape
    in_order = t.size > LONG * count and (t[1:] >= t[:-1]).all()
    found = (run if in_order else gathered)(powers.reshape(-1, n, count), starts, ends, t)
    return found.reshape(*lead, t.size)


@lru_cache(maxsize=HIGHEST + 1)
def about_middle(n):
    """Rows that take Bézier points to the coefficients of the powers of x - 1/2."""
    return frozen(to_power(segment(np.eye(n + 1), 0.5, 1.5)))


def run(table, starts, ends, t):
    """tabulated where the parameters are sorted: span after span, a product of coefficients and powers."""
    rows, n, _ = table.shape
    out, powers = np.empty((rows, t.size)), np.ones((max(2, n), BLOCK // 2))
    cuts = [0, *t.searchsorted(starts[1:]).tolist(), t.size]
    for k, start in enumerate(cuts[:-1]):
        for part in blocks(start, cuts[k + 1], max(2, rows)):
            level = powers[:, : part.stop - part.start]
            x = np.subtract(t[part], starts[k], out=level[1])
            x /= ends[k] - starts[k]
            x -= 0.5
            for j in range(2, n):
                np.multiply(level[j - 1], x, out=level[j])
            np.matmul(table[..., k], level[:n], out=out[:, part])
    return out


def gathered(table, starts, ends, t):
    """tabulated in any order: nested multiplication with coefficients that each parameter has of its span."""
    rows = len(table)
    table = table.transpose(1, 2, 0)[::-1].copy()  # one look-up for all coordinates, the highest power first
    out, widths, find = np.empty((t.size, rows)), ends - starts, finder(starts, ends[-1])
    for part in blocks(0, t.size, 2 * rows):
        k, value = find(t[part]), out[part]
        x = ((t[part] - starts.take(k)) / widths.take(k) - 0.5).repeat(rows).reshape(-1, rows)
        table[0].take(k, axis=0, out=value, mode="clip")
        for coefficients in table[1:]:
            value *= x
            value += coefficients.take(k, axis=0, mode="clip")
    return out.T


def finder(starts, last):
    """A function from a row of t, up to the last knot, to the numbers of the spans with these starts in which they are.

    There are equal buckets, none with many starts in it. A t in a higher bucket is larger, whatever was rounded, so
    that only the starts in a parameter's own bucket must be compared with it.
    """
    scale = 4 * len(starts) / (last - starts[0])

    def bucket(t):
        return ((t - starts[0]) * scale).astype(np.intp)

    if not np.isfinite(scale) or (most := np.bincount(bucket(starts[1:]), minlength=1).max()) > 3:
        return lambda t: starts[1:].searchsorted(t, "right")
    before = bucket(starts[1:]).searchsorted(np.arange(bucket(last) + 1))
    following = np.append(starts[1:], np.inf)

    def find(t):
        k = before.take(bucket(t))
        for _ in range(most):
            k += t >= following.take(k)
        return k

    return find
