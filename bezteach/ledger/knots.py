"""B-splines whose knots are letters, exact: for what arguments compute in a field of fractions of the knots and t.

A knot vector is given by multiplicities: (1, 2, 1) is a, c, c, d. What holds for the letters holds for all knots that
increase as the letters stand, as no denominator is 0 then.
"""

from functools import cache

from sympy import QQ, field

from bezteach.symbolic.bspline import affine_step, terms

DEGREES = range(5)  # the degrees that the arguments try


@cache
def letters(*times, zero=None, one=None):
    """The knots with these multiplicities and t; the letters of the places ``zero`` and ``one`` are these numbers.

    >>> letters(1, 2, zero=0)
    ([0, t1, t1], t)
    """
    names = [f"t{place}" for place in range(len(times)) if place not in (zero, one)]
    numbers, *generators, t = field([*names, "t"], QQ)
    free = iter(generators)
    fixed = {zero: numbers.zero, one: numbers.one}
    values = [fixed[place] if place in fixed else next(free) for place in range(len(times))]
    return [value for value, count in zip(values, times, strict=True) for _ in range(count)], t


def one_span(p):
    """2p + 2 simple knots, whose span p is [0, 1], and t: what a curve on one span depends on."""
    return letters(*[1] * (2 * p + 2), zero=p, one=p + 1)


def piece(i, p, knots, t, span):
    """N_{i,p} on a span, an element of the field.

    >>> piece(0, 1, *letters(1, 1, 1), 1)
    (-t2 + t)/(t1 - t2)
    """
    return sum(terms(i, p, knots, t, span), 0 * t)


def spans(knots):
    """The spans that are not empty."""
    return [k for k in range(len(knots) - 1) if knots[k] != knots[k + 1]]


def indices(p, knots):
    """The indices of the functions of degree p."""
    return range(len(knots) - p - 1)


def all_multiplicities(total):
    """All ways to have this many knots, as multiplicities.

    >>> list(all_multiplicities(3))
    [(1, 1, 1), (1, 2), (2, 1), (3,)]
    """
    if total == 0:
        return [()]
    return [(first, *rest) for first in range(1, total + 1) for rest in all_multiplicities(total - first)]


def blossom(level, knots, span, arguments):
    """The value of the blossom of a span from its p + 1 control points.

    >>> blossom([0, 1, 4], (0, 0, 0, 1, 2, 2), 2, [1, 1])
    2.5
    """
    for u in arguments:
        level = affine_step(level, knots, span, u)
    return level[0]


def as_printed(i, p, knots, at):
    """N_{i,p} at a number by the recursion as it is printed, with half-open spans and 0/0 as 0.

    >>> as_printed(0, 1, [0, 1, 2], 0.5), as_printed(0, 1, [0, 1, 1], 1)
    (0.5, 0.0)
    """
    if p == 0:
        return int(knots[i] <= at < knots[i + 1])
    rise, fall = knots[i + p] - knots[i], knots[i + p + 1] - knots[i + 1]
    left = (at - knots[i]) / rise * as_printed(i, p - 1, knots, at) if rise else 0
    right = (knots[i + p + 1] - at) / fall * as_printed(i + 1, p - 1, knots, at) if fall else 0
    return left + right


def point(points, knots, span, arguments):
    """The blossom of a span at these arguments, for control points with coordinates.

    >>> point([(0, 0), (2, 4), (4, 0)], (0, 0, 0, 1, 1, 1), 2, [0, 1])
    (2.0, 4.0)
    """
    p = len(knots) - len(points) - 1
    return tuple(
        blossom(list(level), knots, span, arguments) for level in zip(*points[span - p : span + 1], strict=True)
    )


def units(p, one):
    """p + 1 lists of control points: one of them ``one`` and the others 0; what holds of them holds of all curves."""
    return [[one * (place == which) for place in range(p + 1)] for which in range(p + 1)]


def order(element, t):
    """The power of t that divides an element, None for 0: t must not divide the denominator.

    >>> t = letters(1)[1]
    >>> order(3 * t**2 + t**4, t), order(0 * t, t)
    (2, None)
    """
    place = t.numer.ring.gens.index(t.numer)
    if not element:
        return None
    if element.denom.degree(t.numer):
        raise ValueError(f"{element} is no polynomial in t")
    return min(powers[place] for powers in element.numer.monoms())


def jump_orders(p, times):
    """The powers of t - s that divide the jumps of the functions of degree p at a knot s of this multiplicity.

    All other knots are simple; functions without a jump are left out. The power r + 1 says that r derivatives agree.

    >>> jump_orders(2, 1)
    [2, 2, 2, 2]
    """
    knots, t = letters(*[1] * (p + 1), times, *[1] * (p + 1), zero=p + 1)
    jumps = (piece(i, p, knots, t, p + times) - piece(i, p, knots, t, p) for i in indices(p, knots))
    return [found for jump in jumps if (found := order(jump, t)) is not None]
