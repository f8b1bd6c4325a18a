"""Cubics through data points: by the one-sixth rule from the chord of the two neighbours, or with C2."""

from itertools import pairwise

from sympy import Add, IndexedBase, Matrix, Mul, Rational, Subs, expand, oo

from bezteach.symbolic import B, i, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import curve_of, derivative_at
from ..planar import acceleration
from .joins import c2

D, V = IndexedBase("D"), IndexedBase("v")
SIXTH = Rational(1, 6)


def shifted(point, factor, chord):
    """A point plus a multiple of a chord, as it stands."""
    return Add(point, Mul(factor, chord, evaluate=False), evaluate=False)


def segment(i, factor=SIXTH):
    """The cubic from D_i to D_{i+1}."""
    after = shifted(D[i], factor, D[i + 1] - D[i - 1])
    before = shifted(D[i + 1], -factor, D[i + 2] - D[i])
    return curve_of([D[i], after, before, D[i + 1]])


WEIGHTED = (
    -B(1, 3, t) / 6 * D[i - 1]
    + (B(0, 3, t) + B(1, 3, t) + B(2, 3, t) / 6) * D[i]
    + (B(1, 3, t) / 6 + B(2, 3, t) + B(3, 3, t)) * D[i + 1]
    - B(2, 3, t) / 6 * D[i + 2]
)


def velocities(factor):
    """At D_i: where one segment arrives, half the chord of the neighbours, where the next one starts."""
    arriving, leaving = derivative_at(1, segment(i - 1, factor)), derivative_at(0, segment(i, factor))
    return [arriving, (D[i + 1] - D[i - 1]) / 2, leaving]


def touched(place, count):
    """The segments that a data point enters, of ``count`` points with D_{-1} = 2 D_0 - D_1 and likewise at the end."""
    beyond = {D[-1]: 2 * D[0] - D[1], D[count]: 2 * D[count - 1] - D[count - 2]}
    segments = [expand(segment(start).doit().subs(beyond)) for start in range(count - 1)]
    return [start for start, polynomial in enumerate(segments) if polynomial.has(D[place])]


def with_velocities(i):
    """The cubic from D_i to D_{i+1} with the velocities v_i and v_{i+1} there."""
    after, before = D[i] + V[i] / 3, D[i + 1] - V[i + 1] / 3
    return curve_of([D[i], after, before, D[i + 1]])


BEFORE, AFTER = (with_velocities(place) for place in (0, 1))
SECOND_JUMP = derivative_at(0, AFTER, 2) - derivative_at(1, BEFORE, 2)


def smooth_cubics(data):
    """The cubics through data on a line with the velocities that solve the system of C2."""
    last = len(data) - 1
    rows = [
        [{0: 4 if 0 < row < last else 2, 1: 1}.get(abs(row - place), 0) for place in range(last + 1)]
        for row in range(last + 1)
    ]
    chords = [3 * (data[min(row + 1, last)] - data[max(row - 1, 0)]) for row in range(last + 1)]
    found = Matrix(rows).LUsolve(Matrix(chords))
    return [
        [(data[k],), (data[k] + found[k] / 3,), (data[k + 1] - found[k + 1] / 3,), (data[k + 1],)] for k in range(last)
    ]


def smooth_instance():
    """Whether these cubics through five data meet with equal velocities and second derivatives, 0 at the ends."""
    cubics = smooth_cubics([0, 3, 1, 1, 5])
    equal = all(c2(left, right) for left, right in pairwise(cubics))
    return equal and acceleration(cubics[0], 0) == (0,) == acceleration(cubics[-1], 1)


CLAIMS = [
    claim(
        "interpolation/arrives",
        "a segment of the one-sixth rule ends in its data point",
        (Subs(segment(i), t, 1), D[i + 1]),
        {i: (1, oo)},
        twins=[(Subs(segment(i), t, 1), D[i])],
    ),
    claim(
        "interpolation/leaves",
        "a segment of the one-sixth rule starts in its data point",
        (Subs(segment(i), t, 0), D[i]),
        {i: (1, oo)},
        twins=[(Subs(segment(i), t, 0), D[i + 1])],
    ),
    claim(
        "interpolation/one-sixth",
        "the one-sixth rule: both segments pass a data point with the velocity (D_{i+1} - D_{i-1}) / 2",
        velocities(SIXTH),
        {i: (2, oo)},
        twins=[velocities(Rational(1, 3)), [velocities(SIXTH)[0], D[i + 1] - D[i - 1]]],
    ),
    argued(
        "interpolation/c1",
        "the one-sixth rule gives a C1 curve through all data points",
        Known("Each segment starts in its data point,", "interpolation/leaves"),
        Known("and ends in the next: the curve is C0.", "interpolation/arrives"),
        Known(
            "At each inner data point both velocities are half the chord of the neighbours.", "interpolation/one-sixth"
        ),
        "The first and the last data point lack a neighbour, where any point may be put: nothing joins there. Counted "
        "from the one before the first, every inner data point has one segment before it and one after it.",
        "If the two neighbours are one point, the velocity is 0: the curve is C1 there, and may have a cusp.",
    ),
    argued(
        "interpolation/c2",
        "through any data points runs a C2 curve of cubics, each on an interval of length 1",
        "Give each data point D_0, ..., D_N a velocity v_i, and let D_i, D_i + v_i/3, D_{i+1} - v_{i+1}/3, D_{i+1} be "
        "the control points of the segment from D_i to D_{i+1}.",
        Known("It starts in D_i with three times its first edge, v_i,", "examples/cubic-speed/start"),
        Known(
            "and ends in D_{i+1} with three times its last edge, v_{i+1}: the whole is C1, whatever they are.",
            "examples/cubic-speed/end",
        ),
        Shown(
            "At D_1, and likewise at every inner data point, the second derivative jumps by this.",
            eq(SECOND_JUMP, 6 * (D[2] - D[0]) - 2 * (V[0] + 4 * V[1] + V[2])),
        ),
        "So the curve is C2 exactly if v_{i-1} + 4 v_i + v_{i+1} = 3 (D_{i+1} - D_{i-1}) for i = 1, ..., N - 1. Two "
        "more conditions may be chosen: let the second derivative be 0 at both ends, which is "
        "2 v_0 + v_1 = 3 (D_1 - D_0) and v_{N-1} + 2 v_N = 3 (D_N - D_{N-1}).",
        "In each coordinate these are N + 1 linear equations for N + 1 numbers. If all right sides are 0, so are they: "
        "let v_k be one of the greatest amount. Its own term, 4 v_k, or 2 v_k at an end, would have to be cancelled by "
        "terms that amount to 2 |v_k| at most, or |v_k| at an end: so v_k is 0, and all are.",
        "Hence they have exactly one solution, whatever stands on the right.",
        Computed("An instance: the data 0, 3, 1, 1, 5 in one coordinate.", smooth_instance),
    ),
    argued(
        "interpolation/reach",
        "a data point of the one-sixth rule enters four segments, two on each side",
        "The segment from D_i to D_{i+1} is made from D_{i-1}, D_i, D_{i+1} and D_{i+2}. So D_j enters it for "
        "i = j - 2, j - 1, j, j + 1, if these segments exist.",
        Shown(
            "Ordered by these four points, their factors are -B_1/6, B_0 + B_1 + B_2/6, B_1/6 + B_2 + B_3 and -B_2/6, "
            "where B_0 .. B_3 are the cubic basis functions.",
            eq(segment(i), WEIGHTED),
            {i: (1, oo)},
        ),
        Known("All four factors are different from 0 for every t between 0 and 1.", "basis/positive-inside"),
        Computed(
            "Among 8 data points D_3 enters exactly the segments 1, 2, 3, 4.", lambda: touched(3, 8) == [1, 2, 3, 4]
        ),
        Computed(
            "Near the ends it is fewer: D_0 enters two segments, D_1 three.",
            lambda: touched(0, 8) == [0, 1] and touched(1, 8) == [0, 1, 2],
        ),
    ),
]
