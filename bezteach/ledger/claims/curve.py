"""The Bézier curve: what it is, and how it goes with its control points and its parameter."""

from sympy import Interval, KroneckerDelta, Mul, Sum, Symbol, binomial, oo, symbols

from bezteach.symbolic import B, b, i, j, k, n, t, u

from ..claim import claim
from ..forms import FROM_ONE, curve, difference

a, c, h, p, q, v = symbols("a c h p q v", real=True)
A = Symbol("A", real=True)

CURVE = curve(index=j)
AT_U = curve(at=u, index=j)
LOCAL = Mul(difference(a + h * t, a), 1 / h, evaluate=False)
MOVED_BY = difference(Sum(B(i, n, t) * (b[i] + v * KroneckerDelta(i, j)), (i, 0, n)), curve())

CLAIMS = [
    claim(
        "curve/definition",
        "the curve: its control points, weighted by the Bernstein functions",
        (CURVE, Sum(binomial(n, j) * t**j * (1 - t) ** (n - j) * b[j], (j, 0, n))),
        twins=[
            (CURVE, Sum(binomial(n, j) * t ** (n - j) * (1 - t) ** j * b[j], (j, 0, n))),
            (CURVE, Sum(binomial(n, j) * t**j * (1 - t) ** (n - j) * b[j], (j, 1, n))),
        ],
    ),
    claim(
        "curve/powers",
        "each coordinate is a polynomial in t of degree n at most",
        (
            CURVE,
            Sum(t**k * binomial(n, k) * Sum((-1) ** (k - j) * binomial(k, j) * b[j], (j, 0, k)), (k, 0, n)),
        ),
        twins=[
            (CURVE, Sum(t**k * binomial(n, k) * Sum((-1) ** j * binomial(k, j) * b[j], (j, 0, k)), (k, 0, n))),
            (CURVE, Sum(t**k * Sum((-1) ** (k - j) * binomial(k, j) * b[j], (j, 0, k)), (k, 0, n))),
        ],
    ),
    claim(
        "curve/affine",
        "the map x -> A x + c takes the curve to the curve of the mapped control points",
        (A * CURVE + c, Sum(B(j, n, t) * (A * b[j] + c), (j, 0, n))),
        twins=[
            (A * CURVE + c, Sum(B(j, n, t) * (A * b[j] + c), (j, 1, n))),
            (CURVE**2, Sum(B(j, n, t) * b[j] ** 2, (j, 0, n))),
        ],
    ),
    claim(
        "curve/symmetry",
        "the control points in reverse order give the same curve, run through backwards",
        (AT_U, Sum(B(j, n, 1 - u) * b[n - j], (j, 0, n))),
        twins=[(AT_U, Sum(B(j, n, u) * b[n - j], (j, 0, n))), (AT_U, curve(at=1 - u, index=j))],
    ),
    claim(
        "curve/linear-precision",
        "control points at equal steps from p to q give the segment, run through evenly",
        (Sum(B(j, n, u) * ((1 - j / n) * p + j / n * q), (j, 0, n)), (1 - u) * p + u * q),
        FROM_ONE,
        twins=[
            (Sum(B(j, n, u) * ((1 - j / n) * p + j / n * q), (j, 0, n)), (1 - u) * q + u * p),
            (Sum(B(j, n, u) * ((1 - j / n) * p + j / n * q), (j, 1, n)), (1 - u) * p + u * q),
        ],
    ),
    claim(
        "curve/reparametrised",
        "the curve over [a, a + h]: the parameter a + h t there is t on [0, 1]",
        (curve(), curve(at=LOCAL)),
        {h: Interval.open(0, oo)},
        twins=[(curve(), curve(at=(a + h * t) / h)), (curve(), curve(at=difference(a + h * t, a)))],
    ),
    claim(
        "curve/moved",
        "moving b_j by v moves the point at t by B_j,n(t) times v",
        (MOVED_BY, v * B(j, n, t)),
        {j: (0, n)},
        twins=[(MOVED_BY, v), (MOVED_BY, v * B(n - j, n, t))],
    ),
    claim(
        "curve/moved/together",
        "moving all control points by v moves the whole curve by v",
        (Sum(B(j, n, t) * (b[j] + v), (j, 0, n)), CURVE + v),
        twins=[(Sum(B(j, n, t) * (b[j] + v), (j, 0, n)), CURVE + n * v)],
    ),
]
