"""What a board says of a B-spline: its knots, what each span depends on, how the spans join, de Boor's triangle."""

from itertools import pairwise

import numpy as np

from ... import numeric
from ...display import number, point
from ...numeric import bspline
from .blocks import Block, cells, exact_array, name_of, times
from .knots import degree_of, domain_of, inner, span_of

PRIMES = ("p", "p′", "p″", "p‴", "p⁗", "p⁽⁵⁾")


def knots_said(state):
    values, counts = bspline.multiplicities(state.knots)
    named = [number(u) if m == 1 else f"{number(u)} ({m} times)" for u, m in zip(values, counts, strict=True)]
    first, last = map(number, domain_of(state.points, state.knots))
    title = f"Knots (节点), degree {degree_of(state)}, domain [{first}, {last}]"
    return [Block(title, cells(named))]


def spline_said(state):
    return [
        Block(f"The point at t = {number(state.t)}", ((point(bspline.evaluate(state.points, state.knots, state.t)),),))
    ]


def breaks_said(state):
    """At each inner knot: the class that its multiplicity promises, and what the curve itself does there."""
    pieces, knots = bspline.to_bezier(exact_array(state.points), state.knots)
    ends = [_derivatives(piece, length) for piece, length in zip(pieces, np.diff(knots), strict=True)]
    joints = zip(inner(state), pairwise(ends), strict=True)
    rows = tuple(_join(degree_of(state), *knot, left[1], right[0]) for knot, (left, right) in joints)
    return [Block("Joins (连续性) at the inner knots", rows or (("none: the curve is one span",),))]


def _derivatives(piece, length):
    """Of a Bézier piece over an interval of this length, the derivatives of order 0 to p, at both ends."""
    levels = [numeric.hodograph(piece, r) / length**r for r in range(len(piece))]
    return [[level[end] for level in levels] for end in (0, -1)]


def _join(degree, knot, count, left, right):
    promised = degree - count
    where = (f"t = {number(knot)}", times(count), f"C{promised} promised" if promised >= 0 else "nothing promised")
    jumps = [r for r, (before, after) in enumerate(zip(left, right, strict=True)) if (before != after).any()]
    if not jumps:
        return (*where, "here all derivatives agree")
    r = jumps[0]
    step = f"{PRIMES[r]} jumps by {point(right[r] - left[r])}"
    return (*where, f"a corner: {step}" if r == 1 and _corner(left[1], right[1]) else step)


def _corner(before, after):
    """Whether two vectors have different directions; a vector 0 has none, and its point may be a corner or not."""
    return bool(before[0] * after[1] != before[1] * after[0] or before @ after < 0)


def span_said(state):
    k, p = span_of(state), degree_of(state)
    ends = f"[{number(state.knots[k])}, {number(state.knots[k + 1])}]"
    deciding = [name_of(i) for i in range(k - p, k + 1)]
    return [Block(f"t = {number(state.t)} is in the span {ends}, in the hull of", cells(deciding))]


def functions_said(state):
    """The values of the functions that are not 0 on the span of t, and their sum, which is 1."""
    k, p = span_of(state), degree_of(state)
    values = bspline.basis(state.knots, p, state.t, span=k)[k - p : k + 1]
    rows = [(name_of(i, letter="N"), number(value)) for i, value in enumerate(values, k - p)]
    return [Block(f"Basis functions (基函数) at t = {number(state.t)}", (*rows, ("sum", number(np.sum(values)))))]


def deboor_said(state):
    levels = bspline.de_boor(exact_array(state.points), state.knots, state.t)
    rows = tuple(tuple(point(levels[k][row - k]) for k in range(row + 1)) for row in range(len(levels)))
    return [Block(f"De Boor's triangle (德布尔算法) at t = {number(state.t)}", rows)]
