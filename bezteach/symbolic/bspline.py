"""B-splines with symbolic knots: the pieces by Cox-de Boor's recursion, and the blossom, each with its steps.

``knots`` is a sequence of numbers and symbols that do not decrease in the order in which they stand; different symbols
are different knots, and a multiple knot is one symbol repeated. Span k is [t_k, t_{k+1}), the degree is an integer.
A quotient whose denominator is 0 counts as 0: it stands before a function that is 0 everywhere.
"""

from itertools import combinations, pairwise
from math import comb

from sympy import Add, Derivative, Mul, Piecewise, Poly, Symbol, sympify

from .derivation import Step, derived, named
from .symbols import b


def terms(i, p, knots, t, span):
    """The terms of the piece of N_{i,p} on a span, each a product of p quotients; none elsewhere than on its support.

    A term is a way down the recursion from N_{i,p} to the one function of degree 0 that is 1 on the span. On the span
    no factor of it is negative. Any arithmetic will do for the knots and t, also that of a field of fractions.

    >>> from sympy.abc import t
    >>> terms(0, 2, range(4), t, 1)
    [t*(2 - t)/2, (3/2 - t/2)*(t - 1)]
    """
    if p == 0:
        return [t**0] if i == span and knots[span] != knots[span + 1] else []
    found = []
    for place, share in ((i, _rise), (i + 1, _fall)):
        if place <= span < place + p and knots[place] != knots[place + p]:
            found += [share(place, p, knots, t) * term for term in terms(place, p - 1, knots, t, span)]
    return found


def _rise(place, p, knots, t):
    """How far t has come on the way from a knot to the p-th after it."""
    return (t - knots[place]) / (knots[place + p] - knots[place])


def _fall(place, p, knots, t):
    return (knots[place + p] - t) / (knots[place + p] - knots[place])


@derived
def piece(i, p, knots, t, span):
    """The polynomial that N_{i,p} is on a span, left as the sum of its terms. Source: transcript, Cox-de Boor.

    >>> from sympy.abc import a, b, c, d, t
    >>> piece(0, 2, (a, b, c, d), t, 0)
    (-a + t)**2/((-a + b)*(-a + c))
    >>> piece(0, 2, (a, a, b, b), t, 1)
    2*(-a + t)*(b - t)/(-a + b)**2
    """
    knots, t = _checked(i, p, knots, t, span)
    if p:
        lower = [(place, _name(place, p - 1)) for place in (i, i + 1)]
        yield Step(_blend(i, p, knots, t, lower), "the recursion; a quotient over 0 is left out", _name(i, p))
        lower = [(place, Add(*terms(place, p - 1, knots, t, span))) for place in (i, i + 1)]
        yield Step(_blend(i, p, knots, t, lower), f"what the functions of degree {p - 1} are on span {span}")
    found = Add(*terms(i, p, knots, t, span))
    reason = "multiplied out: one term for each way down the recursion" if p else f"1 on span {i}, 0 elsewhere"
    yield Step(found, reason, None if p else _name(i, p))


@derived
def derivative_piece(i, p, knots, t, span):
    """The derivative of N_{i,p} on a span, p >= 1, from two functions of one degree less. Source: transcript.

    >>> from sympy.abc import t
    >>> derivative_piece(0, 2, range(4), t, 0), derivative_piece(0, 2, range(4), t, 1)
    (t, 3 - 2*t)
    """
    knots, t = _checked(i, p, knots, t, span)
    if p == 0:
        raise ValueError("degree p is 0: the derivative formula is for p >= 1")
    yield Step(Derivative(Add(*terms(i, p, knots, t, span)), t), "the piece of this span", Derivative(_name(i, p), t))
    yield Step(_difference(i, p, knots, _name), "p times the two lower functions, each over the length of its support")
    found = _difference(i, p, knots, lambda place, lower: Add(*terms(place, lower, knots, t, span)))
    yield Step(found, f"what the functions of degree {p - 1} are on span {span}")


@derived
def N(i, p, knots, t):
    """N_{i,p}(t) as a ``Piecewise`` in t: 0, then its pieces span after span, then 0 again.

    >>> from sympy.abc import t
    >>> N(0, 1, range(3), t)
    Piecewise((0, t < 0), (t, t < 1), (2 - t, t < 2), (0, True))
    >>> N(1, 1, (0, 0, 1, 1), t)
    Piecewise((0, t < 0), (t, t < 1), (0, True))
    """
    knots, t = _checked(i, p, knots, t)
    spans = [k for k in range(i, i + p + 1) if knots[k] != knots[k + 1]]
    for k in spans:
        yield Step(piece(i, p, knots, t, k), f"on span {k}", _name(i, p))
    pieces = [(piece(i, p, knots, t, k), t < knots[k + 1]) for k in spans]
    yield Step(Piecewise((0, t < knots[i]), *pieces, (0, True)), "piece by piece; 0 off the support", _name(i, p))


@derived
def blossom(p, knots, span, arguments, points=b):
    """f(u_1, ..., u_p) of the polynomial of a span: one affine step for each argument, in any order.

    The lines are the levels: the control points f(t_{i+1}, ..., t_{i+p}), then one argument more in place of a knot at
    each step. With all arguments t it is de Boor's algorithm. Source: Ramshaw, Blossoms are polar forms, 1989.

    >>> from sympy.abc import t, u, v
    >>> blossom(1, (0, 0, 1, 1), 1, [t])
    t*b[1] + (1 - t)*b[0]
    >>> blossom(2, (0, 0, 0, 1, 1, 1), 2, [0, 1])
    b[1]
    """
    knots, arguments = [sympify(knot) for knot in knots], [sympify(u) for u in arguments]
    check_span(p, knots, span)
    if len(arguments) != p:
        raise ValueError(f"a blossom of degree {p} has {p} arguments: {len(arguments)} are given")
    level = [points[i] for i in range(span - p, span + 1)]
    for r, u in enumerate(arguments):
        level = affine_step(level, knots, span, u)
        for place, point in enumerate(level if r + 1 < p else ()):
            yield Step(point, f"step {r + 1}: {u} in place of a knot", named("d", span - p + r + 1 + place, r + 1))
    yield Step(level[0], "the one value that is left", Symbol(f"f({', '.join(map(str, arguments))})"))


def affine_step(level, knots, span, u):
    """The next level: each two neighbours blended as u lies between the two knots in which they differ.

    >>> from sympy.abc import u
    >>> affine_step([0, 1, 4], (0, 0, 0, 1, 2, 2), 2, u)
    [u, 3*u/2 + 1]
    """
    p = len(level) - 1
    places = range(span + 1 - p, span + 1)
    shares = [(knots[place], knots[place + p]) for place in places]
    return [
        (high - u) / (high - low) * before + (u - low) / (high - low) * after
        for (low, high), (before, after) in zip(shares, pairwise(level), strict=True)
    ]


def polar(polynomial, p, t, arguments):
    """The blossom of a polynomial of degree <= p in t, from its powers: t^k becomes the mean product of k arguments.

    It is symmetric and affine in each argument, and with all of them t it is the polynomial.

    >>> from sympy.abc import t, u, v
    >>> polar(t**2 + 2 * t + 3, 2, t, [u, v])
    u*v + u + v + 3
    """
    if len(arguments) != p or (degree := Poly(polynomial, t).degree()) > p:
        raise ValueError(f"{polynomial} with {len(arguments)} arguments: degree <= {p} and {p} arguments are needed")
    return Add(
        *[
            Poly(polynomial, t).coeff_monomial(t**k)
            * Add(*[Mul(*some) for some in combinations(arguments, k)])
            / comb(p, k)
            for k in range(max(degree, 0) + 1)
        ]
    )


def check_span(p, knots, span):
    """``ValueError`` unless the span is not empty and has p knots before it and after it: level 0 is p + 1 points."""
    if type(p) is not int or type(span) is not int or not 0 <= p <= span < len(knots) - p - 1:
        raise ValueError(f"span {span}, degree {p}, {len(knots)} knots: p + 1 knots are needed on either side")
    if knots[span] == knots[span + 1]:
        raise ValueError(f"span {span} is empty: both its ends are {knots[span]}")


def _checked(i, p, knots, t, span=0):
    """The knots and t as SymPy takes them; ``ValueError`` for an index, a degree, a span or knots that do not fit."""
    knots = [sympify(knot) for knot in knots]
    for name, value, end in (("degree p", p, len(knots) - 1), ("index i", i, len(knots) - 1 - p)):
        if type(value) is not int or not 0 <= value < end:
            raise ValueError(f"{name} is {value}: with {len(knots)} knots it is an integer from 0 to {end - 1}")
    if type(span) is not int or not 0 <= span < len(knots) - 1:
        raise ValueError(f"span {span}: with {len(knots)} knots the spans are 0 to {len(knots) - 2}")
    for k, (low, high) in enumerate(pairwise(knots)):
        if (high - low).is_negative or (low != high and high in knots[:k]):
            raise ValueError(f"knots decrease: t_{k + 1} = {high} follows t_{k} = {low}")
    return knots, sympify(t)


def _name(i, p):
    return named("N", f"{i},{p}")


def _blend(i, p, knots, t, lower):
    """The recursion with these for the two lower functions; a quotient whose denominator is 0 is left out."""
    shares = zip((_rise, _fall), lower, strict=True)
    return Add(*[share(k, p, knots, t) * below for share, (k, below) in shares if knots[k] != knots[k + p]])


def _difference(i, p, knots, lower):
    """p times the lower functions, each over the length of its support, the second with the sign -."""
    signed = ((1, i), (-1, i + 1))
    return Add(*[p * s * lower(k, p - 1) / (knots[k + p] - knots[k]) for s, k in signed if knots[k] != knots[k + p]])
