"""The curvature of the curve at its ends."""

from fractions import Fraction

from sympy import Interval, Mul, Symbol, oo, symbols

from bezteach.symbolic import n

from ..claim import Computed, Known, argued, claim
from ..forms import quotient
from ..planar import cross, curvature_squared, dot, minus, times

x, y, v, w = symbols("x y v w", real=True)
POLYGONS = [
    [tuple(map(Fraction, point)) for point in points]
    for points in (
        [(0, 0), (1, 3), (2, 1)],
        [(0, 0), (1, 3), (2, 1), (3, 3)],
        [(-9, 0), (-3, 6), (3, 6), (9, 0), (4, -5)],
    )
]


def from_edges(end, edge, area):
    """The two claims of the curvature at an end: its second equality, and false ones."""
    printed = Mul(n**2 * (n - 1) * area, n**-3, edge**-3, evaluate=False)
    cubed, squared = quotient(area, edge**3), quotient(area, edge**2)
    return claim(
        f"curve/curvature/{end}",
        f"the curvature at the {end}, the powers of n cancelled",
        (printed, Mul(quotient(n - 1, n), cubed, evaluate=False)),
        {n: (1, oo), edge: Interval.open(0, oo)},
        twins=[
            (printed, Mul(quotient(n, n - 1), cubed, evaluate=False)),
            (printed, Mul(quotient(n - 1, n), squared, evaluate=False)),
        ],
    )


def squared_from_edges(before, after, near, degree):
    """The square of the curvature at an end from two edges, of which ``near`` is the one at the end."""
    return (Fraction(degree - 1, degree) * cross(before, after)) ** 2 / dot(near, near) ** 3


def at_start(points):
    before, after = minus(points[1], points[0]), minus(points[2], points[1])
    return curvature_squared(points, 0) == squared_from_edges(before, after, before, len(points) - 1)


def at_end(points):
    before, after = minus(points[-2], points[-3]), minus(points[-1], points[-2])
    return curvature_squared(points, 1) == squared_from_edges(before, after, after, len(points) - 1)


EDGE, NEXT = (x, y), (v, w)
BEND = times(n * (n - 1), minus(NEXT, EDGE))
AREA = n**2 * (n - 1) * cross(EDGE, NEXT)
NO_POWER = "The cube of the length of n times an edge is n^3 times the cube of the edge's length: the denominator."

CLAIMS = [
    claim(
        "curve/curvature/start/cross",
        "a coordinate of p' x p'' at the start, from two coordinates (x, y) and (v, w) of the first two edges",
        (cross(times(n, EDGE), BEND), AREA),
        twins=[(cross(times(n, EDGE), BEND), -AREA), (cross(times(n, EDGE), BEND), n * AREA)],
    ),
    argued(
        "curve/curvature/start/derivatives",
        "the curvature |p' x p''|/|p'|^3 at the start, in the first two edges, of which the first is not 0",
        Known("p' is n times the first edge.", "curve/tangent/start"),
        Known("p'' is n (n - 1) times the second edge less the first.", "curve/second/start"),
        Known(
            "Each coordinate of p' x p'' is n^2 (n - 1) times that of the cross product of the two edges:",
            "curve/curvature/start/cross",
        ),
        "the other two coordinates are the same formula in other letters, and the plane has the third alone.",
        NO_POWER,
        "For a line, n = 1, there is no second edge; p'' is 0, and n - 1 with it.",
        Computed(
            "Only a check of instances: three plane curves of degree 2, 3, 4.", lambda: all(map(at_start, POLYGONS))
        ),
    ),
    from_edges("start", *(Symbol(name, real=True) for name in ("|Δb₀|", "|Δb₀×Δb₁|"))),
    claim(
        "curve/curvature/end/cross",
        "a coordinate of p' x p'' at the end, from two coordinates (x, y) and (v, w) of the last two edges",
        (cross(times(n, NEXT), BEND), AREA),
        twins=[(cross(times(n, NEXT), BEND), -AREA), (cross(times(n, EDGE), times(-1, BEND)), AREA)],
    ),
    argued(
        "curve/curvature/end/derivatives",
        "the curvature |p' x p''|/|p'|^3 at the end, in the last two edges, of which the last is not 0",
        Known("p' is n times the last edge.", "curve/tangent/end"),
        Known("p'' is n (n - 1) times the last edge less the one before.", "curve/second/end"),
        Known(
            "Each coordinate of p' x p'' is n^2 (n - 1) times that of the cross product of the two edges:",
            "curve/curvature/end/cross",
        ),
        "the other two coordinates are the same formula in other letters, and the plane has the third alone.",
        NO_POWER,
        "For a line, n = 1, there is no edge before; p'' is 0, and n - 1 with it.",
        Computed(
            "Only a check of instances: three plane curves of degree 2, 3, 4.", lambda: all(map(at_end, POLYGONS))
        ),
    ),
    from_edges("end", *(Symbol(name, real=True) for name in ("|Δbₙ₋₁|", "|Δbₙ₋₂×Δbₙ₋₁|"))),
]
