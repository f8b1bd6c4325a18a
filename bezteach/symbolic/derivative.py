"""Derivatives of a Bézier curve, at any parameter and at the ends, and its curvature, derived from the operator form.

As in ``curve``: call a function for its result, its ``steps`` for the lines. r is an integer >= 0, else ValueError.
"""

from sympy import (
    Derivative,
    Indexed,
    IndexedBase,
    Integer,
    Matrix,
    Sum,
    Symbol,
    diff,
    expand,
    factor,
    factor_terms,
    powsimp,
    sqrt,
    sympify,
)

from .basis import B
from .derivation import Step, derived, named, p
from .operator import apply, step
from .symbols import E, b
from .symbols import j as place
from .symbols import n as degree
from .symbols import t as parameter

COORDINATES = tuple(map(IndexedBase, "xyz"))
EDGES = IndexedBase("Δb")
CURVATURE = Symbol("kappa")


@derived
def derivative(n, t, r=1, points=b):
    """The r-th derivative of the curve at t, n!/(n-r)! (E - 1)^r g(t)^(n-r) b_0. Source: deck, 2.2.

    >>> from bezteach.symbolic import n, t
    >>> derivative(n, t)
    n*Sum((b[i + 1] - b[i])*B(i, n - 1, t), (i, 0, n - 1))
    >>> derivative(2, t, 2)
    2*b[0] - 4*b[1] + 2*b[2]
    """
    operator = yield from _differentiated(n, r, points)
    if t != parameter:
        operator = operator.subs(parameter, t)
        yield Step(operator * points[0], "at this parameter", _at(t, r))
    yield Step(apply(operator, points), "expanded in E")


@derived
def hodograph(n, r, j, points=b):
    """The control point c_j of the r-th derivative, a Bézier curve of degree n - r <= n. Source: deck, 2.2.

    >>> from bezteach.symbolic import j, n
    >>> hodograph(n, 1, j)
    n*(b[j + 1] - b[j])
    """
    n = sympify(n)
    operator = yield from _differentiated(n, r, points)
    if operator == 0:
        yield Step(operator, "a polynomial of degree n differentiated more than n times", named("c", j))
        return
    constant = powsimp(operator / step(parameter) ** (n - r))
    yield Step(
        Sum(B(place, n - r, parameter) * constant * E**place * points[0], (place, 0, n - r)),
        "binomial theorem for what is left of the power",
    )
    operator = factor_terms(constant * E**j)
    yield Step(operator * points[0], "what multiplies a basis function is its control point", named("c", j))
    yield Step(apply(operator, points), "expanded in E")


@derived
def end_derivative(n, r, at, points=b):
    """The r-th derivative at the end ``at``, which is 0 or 1; only the r + 1 points nearest to it enter.

    Source: deck, 1.2 and 2.2.

    >>> from bezteach.symbolic import n
    >>> end_derivative(n, 1, 1)
    n*(-b[n - 1] + b[n])
    >>> end_derivative(3, 2, 0)
    6*b[0] - 12*b[1] + 6*b[2]
    """
    if at not in (0, 1):
        raise ValueError(f"at is {at}: a curve ends at 0 and at 1")
    operator = yield from _differentiated(n, r, points)
    at_end = operator.subs(parameter, at)
    why = "g(0) = 1" if at == 0 else "g(1) = E"
    yield Step(at_end * points[0], f"at the end, where {why}", _at(at, r))
    yield Step(apply(at_end, points), "expanded in E")


@derived
def curvature(n, t, dimension=2):
    """The curvature at t: signed in the plane (points x_i, y_i), unsigned in space (x_i, y_i, z_i).

    Assumes that p'(t) is not 0. Its square is a rational function of everything in it. Source: deck, 2.2.

    >>> from bezteach.symbolic import t
    >>> curvature(1, t)
    0
    """
    first, second = ([derivative(n, t, r, c) for c in _coordinates(dimension)] for r in (1, 2))
    yield Step(
        _cross(first, second) / _speed(first) ** 3,
        "cross product of the derivatives over the cube of the speed",
        CURVATURE,
    )


@derived
def end_curvature(n, at, dimension=2):
    """The curvature at the end ``at`` (0 or 1); assumes that the edge of the polygon there is not 0. Source: deck, 2.2.

    >>> from bezteach.symbolic import n
    >>> x, y, _ = COORDINATES
    >>> end_curvature(n, 0).subs({x[0]: 0, y[0]: 0, x[1]: 1, y[1]: 0, x[2]: 2, y[2]: 1})
    (n - 1)/n
    """
    coordinates = _coordinates(dimension)
    first, second = (_weights_of_edges(n, r, at) for r in (1, 2))
    for r, weights in enumerate((first, second), 1):
        total = sum(weight * EDGES[place] for place, weight in weights.items())
        yield Step(total, "from the edges of the polygon", _at(at, r))
    (near,), (other,) = first, second.keys() - first.keys()
    scale = first[near] * second[other] / first[near] ** 3
    pair = (near, other)
    if scale.could_extract_minus_sign():
        scale, pair = -scale, (other, near)
    before, after = ([c[place + 1] - c[place] for c in coordinates] for place in pair)
    length = _speed([c[near + 1] - c[near] for c in coordinates])
    yield Step(
        scale * _cross(before, after) / length**3,
        "cross product over the cube of the speed; an edge does not count across itself",
        CURVATURE,
    )


def _weights_of_edges(n, r, at):
    """The r-th derivative at an end as {k: weight of the edge (E - 1) b_k}."""
    *_, line, _ = end_derivative.steps(degree, r, at)
    total = expand(apply(line.expression / b[0] / (E - 1), EDGES))
    return {edge.indices[0].subs(degree, n): factor(total.coeff(edge)).subs(degree, n) for edge in total.atoms(Indexed)}


def _coordinates(dimension):
    if dimension not in (2, 3):
        raise ValueError(f"dimension is {dimension}: curvature is for the plane (2) and for space (3)")
    return COORDINATES[:dimension]


def _cross(first, second):
    """The cross product of plane vectors, a signed number, or the length of that of space vectors."""
    if len(first) == 2:
        return first[0] * second[1] - first[1] * second[0]
    return sqrt(sum(c**2 for c in Matrix(first).cross(Matrix(second))))


def _speed(first):
    return sqrt(sum(c**2 for c in first))


def _differentiated(n, r, points):
    """Yield the lines of the r-th derivative at t and return its operator; SymPy differentiates, once a line."""
    if isinstance(r, bool) or not isinstance(r, (int, Integer)) or r < 0:
        raise ValueError(f"r is {r}: how often a curve is differentiated is an integer >= 0")
    operator = step(parameter) ** sympify(n)
    yield Step(operator * points[0], "the curve in its operator form", p(parameter))
    for order in range(1, int(r) + 1):
        operator = factor_terms(powsimp(diff(operator, parameter)))
        yield Step(operator * points[0], "differentiate the power; dg/dt = E - 1", _derivative_of_curve(order))
    return operator


def _derivative_of_curve(r):
    return Derivative(p(parameter), (parameter, r)) if r else p(parameter)


def _at(value, r):
    return _derivative_of_curve(r).subs(parameter, value)
