"""Matrix forms with the highest power of t first, and the change from powers of t as a triangular matrix."""

from sympy import Derivative, ImmutableMatrix, IndexedBase, MatMul, Sum, binomial

from bezteach.symbolic import B, i, j, n, t

from ..claim import claim
from ..forms import WITHIN, curve, curve_of

V = IndexedBase("V")
POINTS = ImmutableMatrix([V[0], V[1], V[2], V[3]])
DESCENDING = ImmutableMatrix([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]])
CURVE = curve_of(POINTS)


def product(*powers, matrix=DESCENDING):
    """A row of powers times the matrix times the column of the control points."""
    return MatMul(ImmutableMatrix([powers]), matrix, POINTS)


CLAIMS = [
    claim(
        "matrix/cubic",
        "a cubic curve, term by term",
        (curve(3, points=V), CURVE),
        twins=[(Sum(V[i] * B(i, 3, t), (i, 1, 3)), CURVE)],
    ),
    claim(
        "matrix/descending",
        "the cubic curve as a product of matrices, the highest power first",
        (CURVE, product(t**3, t**2, t, 1)),
        twins=[(CURVE, product(1, t, t**2, t**3)), (CURVE, product(t**3, t**2, t, 1, matrix=DESCENDING[::-1, :]))],
    ),
    claim(
        "matrix/tangent",
        "the tangent vector of the cubic curve as a product of matrices",
        (Derivative(CURVE, t), product(3 * t**2, 2 * t, 1, 0)),
        twins=[
            (Derivative(CURVE, t), product(t**2, t, 1, 0)),
            (Derivative(CURVE, t), product(0, 1, 2 * t, 3 * t**2)),
        ],
    ),
    claim(
        "matrix/triangular",
        "the matrix from powers of t to the basis: its entries, which are 0 above the diagonal",
        (B(i, n, t), Sum(t**j * ((-1) ** (i + j) * binomial(n, j) * binomial(j, i)), (j, 0, n))),
        WITHIN,
        twins=[
            (B(i, n, t), Sum(t**j * ((-1) ** (i + j) * binomial(n, i) * binomial(i, j)), (j, 0, n))),
            (B(i, n, t), Sum(t**j * (binomial(n, j) * binomial(j, i)), (j, 0, n))),
        ],
    ),
]
