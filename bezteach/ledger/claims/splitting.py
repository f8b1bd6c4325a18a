"""Splitting a curve in two at the parameter t."""

from sympy import Add, Subs, Sum, binomial

from bezteach.symbolic import B, E, b, j, n, t, u

from ..claim import claim
from ..forms import G, curve

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
    curve(at=FRONT_PLACE),
]
BACK = [
    BACK_POINTS,
    Sum(B(j, n, u) * G ** (n - j) * b[j], (j, 0, n)),
    Sum(binomial(n, j) * (1 - u) ** (n - j) * u**j * G ** (n - j) * E**j * b[0], (j, 0, n)),
    (Add(Add(1, -WHOLE, evaluate=False), WHOLE * E, evaluate=False)) ** n * b[0],
    curve(at=BACK_PLACE),
]

CLAIMS = [
    claim(
        "split/left",
        "the first points of all levels are the control points of the front part",
        (FRONT_POINTS, curve(at=FRONT_PLACE)),
        twins=[
            (FRONT_POINTS, curve(at=t + u - t * u)),
            (BACK_POINTS, curve(at=FRONT_PLACE)),
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
        (BACK_POINTS, curve(at=BACK_PLACE)),
        twins=[
            (BACK_POINTS, curve(at=t * u)),
            (Sum(curve(j, n - j) * B(j, n, u), (j, 0, n)), curve(at=BACK_PLACE)),
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
        (Subs(curve(at=FRONT_PLACE), u, 0), curve(at=0)),
        twins=[(Subs(curve(at=FRONT_PLACE), u, 0), curve())],
    ),
    claim(
        "split/left/end",
        "the front part ends at t",
        (Subs(curve(at=FRONT_PLACE), u, 1), curve()),
        twins=[(Subs(curve(at=FRONT_PLACE), u, 1), curve(at=1))],
    ),
    claim(
        "split/right/start",
        "the back part begins at t",
        (Subs(curve(at=BACK_PLACE), u, 0), curve()),
        twins=[(Subs(curve(at=BACK_PLACE), u, 0), curve(at=1 - t))],
    ),
    claim(
        "split/right/end",
        "the back part ends where the curve ends",
        (Subs(curve(at=BACK_PLACE), u, 1), curve(at=1)),
        twins=[(Subs(curve(at=BACK_PLACE), u, 1), curve())],
    ),
]
