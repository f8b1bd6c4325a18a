"""The knots of a board: read and checked, and the pieces of the spline between them."""

import numpy as np

from ...numeric import bspline

HIGHEST = 5  # degree of a spline on a board: the knots' line has room for stacks of one more
ROW = 0.2  # from a knot down to the next one of its stack, where a basis function reaches up to 1


def checked(knots, count):
    """Knots, a tuple of Fractions, that fit so many control points; ``ValueError`` names the rule and the offender."""
    degree = len(knots) - count - 1
    if not 1 <= degree <= HIGHEST:
        rule = f"a board shows degrees 1 to {HIGHEST}"
        raise ValueError(f"{len(knots)} knots for {count} control points make degree {degree}, and {rule}")
    bspline.averages(knots, degree)  # says what is wrong with the knots
    bspline.span(knots, degree, knots[degree])  # and with their domain
    return knots


def degree_of(state):
    return len(state.knots) - len(state.points) - 1


def domain_of(points, knots):
    """The first and the last parameter of the curve: t_p and t_{n+1}, without knots 0 and 1."""
    return (0, 1) if knots is None else (knots[len(knots) - len(points) - 1], knots[len(points)])


def span_of(state):
    """The index k of the span that t lies in, whose control points are b_{k-p}, ..., b_k."""
    return int(bspline.span(state.knots, degree_of(state), state.t))


def inner(state):
    """(knot, times) for each knot inside the domain."""
    first, last = domain_of(state.points, state.knots)
    values, times = bspline.multiplicities(state.knots)
    return [(u, int(m)) for u, m in zip(values, times, strict=True) if first < u < last]


def stacks(knots):
    """Places (t, y) of the knots in their line: equal ones stand under each other."""
    return [(float(knot), -ROW * (1 + knots[:i].count(knot))) for i, knot in enumerate(knots)]


def line_view(ends, degree):
    """The view (x0, y0, x1, y1) of the knots' line: knots between these ends, functions over them."""
    return (float(ends[0]), -ROW * (degree + 1.5), float(ends[1]), 1.2)


def graphs(knots, degree):
    """For each basis function the Bézier points of its graph, shape (K, p+1, 2), on the K spans of its support.

    With degree more knots on either side, apart from all, the domain is everything between the first and the last.
    """
    beyond = np.arange(1, degree + 1)
    longer = np.concatenate([knots[0] - beyond[::-1], knots, knots[-1] + beyond])
    count = len(knots) - degree - 1
    units = np.eye(count + 2 * degree)[degree : degree + count]
    places = np.broadcast_to(bspline.averages(longer, degree), units.shape)
    pieces, breaks = bspline.to_bezier(np.stack([places, units], axis=-1), longer)
    within = [(breaks[:-1] >= knots[i]) & (breaks[1:] <= knots[i + degree + 1]) for i in range(count)]
    return [pieces[i, spans] for i, spans in enumerate(within)]
