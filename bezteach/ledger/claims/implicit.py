"""Curves by an equation f(x, y) = 0 and by a parameter: the examples behind what the notes say of them."""

from sympy import Poly, Rational, diff, symbols

from bezteach.symbolic import t

from ..claim import Computed, Known, argued, claim
from ..planar import velocity

x, y = symbols("x y", real=True)
CIRCLE = x**2 + y**2 - 1
PARABOLA = y - x**2
ON_CIRCLE = ((1 - t**2), 2 * t, (1 + t**2))
TURN = {x: Rational(3, 5) * x - Rational(4, 5) * y, y: Rational(4, 5) * x + Rational(3, 5) * y}


def at(f, px, py):
    return f.subs({x: px, y: py}, simultaneous=True)


def turned_parabola():
    """Whether the parabola, turned, has an equation of degree 2 again, and two points over one x."""
    turned = PARABOLA.subs(TURN, simultaneous=True)
    over_zero = Poly(turned.subs(x, 0), y)
    return Poly(turned, x, y).total_degree() == 2 and over_zero.count_roots() == 2


def circle_by_parameter():
    """Whether the parameters 1, -1 and 0 give the points and the velocity that the argument names."""
    across, up = ON_CIRCLE[0] / ON_CIRCLE[2], ON_CIRCLE[1] / ON_CIRCLE[2]
    places = [(across.subs(t, value), up.subs(t, value)) for value in (1, -1)]
    speed = [diff(coordinate, t).subs(t, 0) for coordinate in (across, up)]
    return places == [(0, 1), (0, -1)] and speed == [0, 2]


CLAIMS = [
    argued(
        "implicit/several",
        "an equation f(x, y) = 0 may have several y to one x",
        Computed("x^2 + y^2 = 1 has (0, 1) and (0, -1).", lambda: at(CIRCLE, 0, 1) == 0 == at(CIRCLE, 0, -1)),
        "So the whole circle is the graph of no function y(x).",
    ),
    argued(
        "implicit/slope",
        "on f(x, y) = 0 the derivative dy/dx does not exist where the tangent is upright",
        "Where the derivative f_y is not 0, the implicit function theorem gives dy/dx = -f_x / f_y.",
        Computed(
            "On x^2 + y^2 = 1, at (1, 0), f_y is 0 and f_x is not.",
            lambda: at(CIRCLE, 1, 0) == 0 == at(diff(CIRCLE, y), 1, 0) != at(diff(CIRCLE, x), 1, 0),
        ),
        "There the quotient is undefined, though the circle has a tangent: the upright line x = 1.",
    ),
    argued(
        "implicit/axes",
        "in other axes an equation f(x, y) = 0 is another equation of the same degree; a graph may be none any more",
        "New axes are an invertible affine map T: the curve has the equation f(T(x, y)) = 0 in the new coordinates.",
        "Its degree is not higher, since T is of degree 1; by the inverse map it is not lower either.",
        Computed(
            "The graph y = x^2, turned by the angle with cosine 3/5 and sine 4/5: an equation of degree 2 again, "
            "but two points over x = 0. It is no graph y = g(x).",
            turned_parabola,
        ),
    ),
    claim(
        "implicit/circle",
        "x = (1 - t^2) / (1 + t^2), y = 2t / (1 + t^2) lies on the circle, both sides times (1 + t^2)^2",
        (ON_CIRCLE[0] ** 2 + ON_CIRCLE[1] ** 2, ON_CIRCLE[2] ** 2),
        twins=[(ON_CIRCLE[0] ** 2 + t**2, ON_CIRCLE[2] ** 2)],
    ),
    argued(
        "implicit/parametric",
        "with a parameter, several y to one x and upright tangents do no harm",
        Known("The circle again: x = (1 - t^2) / (1 + t^2), y = 2t / (1 + t^2).", "implicit/circle"),
        Computed(
            "t = 1 and t = -1 give the two points over x = 0, and at t = 0 the velocity is (0, 2), upright.",
            circle_by_parameter,
        ),
        "To each t there is one point and one velocity.",
    ),
    argued(
        "implicit/motion",
        "t as time: the curve is the track of a moving point, and one track can be run through in many ways",
        "p(t) is the place at the time t, p'(t) the velocity.",
        Computed(
            "The segment from (0, 0) to (2, 4) by the points (0, 0), (1, 2), (2, 4), evenly, and by (0, 0), (0, 0), "
            "(2, 4), from rest: the same track, other velocities at the start.",
            lambda: velocity([(0, 0), (1, 2), (2, 4)], 0) == (2, 4) and velocity([(0, 0), (0, 0), (2, 4)], 0) == (0, 0),
        ),
    ),
]
