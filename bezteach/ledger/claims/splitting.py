"""Splitting a curve in two at the parameter t."""

from sympy import Add, Subs, Sum, binomial

from bezteach.symbolic import B, E, b, i, j, n, step, t, u

from ..claim import claim
from .casteljau import curve

G = step(t)


def curve_at(parameter):
    """The curve at a parameter other than t."""
    return Sum(B(i, n, parameter) * b[i], (i, 0, n))


FRONT_PLACE, BACK_PLACE = t * u, 1 - (1 - t) * (1 - u)
FRONT_POINTS = Sum(curve(j) * B(j, n, u), (j, 0, n))
BACK_POINTS = Sum(curve(n - j, j) * B(j, n, u), (j, 0, n))
WHOLE = u + t - t * u
FRONT = [
    FRONT_POINTS,
    Sum(B(j, n, u) * G**j * b[0], (j, 0, n)),
    Sum(binomial(n, j) * (1 - u) ** (n - j) * (u * (1 - t) + u * t * E) ** j * b[0], (j, 0, n)),
    Add(1 - u, u * (1 - t), u * t * E, evaluate=False) ** n * b[0],
    ((1 - t * u) + t * u * E) ** n * b[0],
    curve_at(FRONT_PLACE),
]
BACK = [
    BACK_POINTS,
    Sum(B(j, n, u) * G ** (n - j) * b[j], (j, 0, n)),
    Sum(binomial(n, j) * (1 - u) ** (n - j) * u**j * G ** (n - j) * E**j * b[0], (j, 0, n)),
    (Add(Add(1, -WHOLE, evaluate=False), WHOLE * E, evaluate=False)) ** n * b[0],
    curve_at(BACK_PLACE),
]

CLAIMS = [
    claim(
        "split/left",
        "the first points of all levels are the control points of the front part",
        (FRONT_POINTS, curve_at(FRONT_PLACE)),
        twins=[
            (FRONT_POINTS, curve_at(t + u - t * u)),
            (Sum(curve(n - j, j) * B(j, n, u), (j, 0, n)), curve_at(FRONT_PLACE)),
        ],
    ),
    claim(
        "split/left/proof",
        "the front part by powers of the step",
        FRONT,
        twins=[[*FRONT[:3], (u * (1 - t) + u * t * E) ** n * b[0]]],
    ),
    claim(
        "split/right",
        "the last points of all levels, from the last level to the first, are the control points of the back part",
        (BACK_POINTS, curve_at(BACK_PLACE)),
        twins=[
            (BACK_POINTS, curve_at(t * u)),
            (Sum(curve(j, n - j) * B(j, n, u), (j, 0, n)), curve_at(BACK_PLACE)),
        ],
    ),
    claim(
        "split/right/proof",
        "the back part by powers of the step",
        BACK,
        twins=[[*BACK[:2], Sum(B(j, n, u) * G ** (n - j) * b[n - j], (j, 0, n))]],
    ),
    claim(
        "split/left/start",
        "the front part begins where the curve begins",
        (Subs(curve_at(FRONT_PLACE), u, 0), curve_at(0)),
        twins=[(Subs(curve_at(FRONT_PLACE), u, 0), curve_at(t))],
    ),
    claim(
        "split/left/end",
        "the front part ends at t",
        (Subs(curve_at(FRONT_PLACE), u, 1), curve_at(t)),
        twins=[(Subs(curve_at(FRONT_PLACE), u, 1), curve_at(1))],
    ),
    claim(
        "split/right/start",
        "the back part begins at t",
        (Subs(curve_at(BACK_PLACE), u, 0), curve_at(t)),
        twins=[(Subs(curve_at(BACK_PLACE), u, 0), curve_at(1 - t))],
    ),
    claim(
        "split/right/end",
        "the back part ends where the curve ends",
        (Subs(curve_at(BACK_PLACE), u, 1), curve_at(1)),
        twins=[(Subs(curve_at(BACK_PLACE), u, 1), curve_at(t))],
    ),
]
