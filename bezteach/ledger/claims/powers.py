"""Between the Bernstein basis and the powers of t, and that the Bernstein functions are a basis."""

from sympy import Ge, IndexedBase, KroneckerDelta, MatMul, Matrix, Sum, binomial

from bezteach.symbolic import B, b, i, j, k, n, r, t

from ..claim import Known, Shown, argued, claim
from ..forms import FALLING, FROM_ONE, WITHIN, curve, derivative_at

a, c = IndexedBase("a"), IndexedBase("c")

TO_POWERS = [
    B(i, n, t),
    Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * t**j, (j, i, n)),
    Sum((-1) ** (i + j) * binomial(n, i) * binomial(n - i, j - i) * t**j, (j, i, n)),
]
WHY = ["", "the power of 1 - t multiplied out", "C(n, j) C(j, i) = C(n, i) C(n - i, j - i)"]
POWERS = Matrix([[1, t, t**2, t**3]])
CUBIC = Matrix([[1, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]])


def coefficient(at):
    """The coefficient c_k, read off the derivatives of order 0 to k of the combination, at 0 or at 1."""
    derivative = derivative_at(at, curve(points=c, index=j), r)
    return Sum(binomial(k, r) / FALLING * derivative, (r, 0, k))


CLAIMS = [
    claim(
        "basis/from-powers",
        "a power of t in the Bernstein basis",
        (t**i, Sum(binomial(j, i) / binomial(n, i) * B(j, n, t), (j, i, n))),
        WITHIN,
        twins=[
            (t**i, Sum(binomial(n, i) / binomial(j, i) * B(j, n, t), (j, i, n))),
            (t**i, Sum(binomial(j, i) * B(j, n, t), (j, i, n))),
        ],
    ),
    claim(
        "basis/linear-precision",
        "with the weights j/n they give t",
        (t, Sum(j / n * B(j, n, t), (j, 1, n))),
        FROM_ONE,
        twins=[(t, Sum(j / (n + 1) * B(j, n, t), (j, 1, n))), (t, Sum(j / n * B(j, n, t), (j, 2, n)))],
    ),
    claim(
        "basis/to-powers",
        "a Bernstein function in powers of t",
        (TO_POWERS[0], TO_POWERS[1]),
        WITHIN,
        twins=[
            (TO_POWERS[0], Sum((-1) ** i * binomial(n, j) * binomial(j, i) * t**j, (j, i, n))),
            (TO_POWERS[0], Sum((-1) ** (i + j) * binomial(n, i) * binomial(j, i) * t**j, (j, i, n))),
        ],
    ),
    claim(
        "basis/to-powers/second",
        "a Bernstein function in powers of t, the other way to write it",
        (TO_POWERS[0], TO_POWERS[2]),
        WITHIN,
        twins=[(TO_POWERS[0], Sum((-1) ** (i + j) * binomial(n, i) * binomial(n, j - i) * t**j, (j, i, n)))],
    ),
    claim(
        "basis/to-powers/both",
        "both ways to write a Bernstein function in powers of t",
        list(zip(TO_POWERS, WHY, strict=True)),
        WITHIN,
        twins=[[*TO_POWERS[:2], Sum((-1) ** (i + j) * binomial(n, j) * binomial(n - i, j - i) * t**j, (j, i, n))]],
    ),
    claim(
        "basis/independent",
        "linearly independent: the derivatives of a combination at 0 give back each coefficient",
        (c[k], coefficient(0)),
        {k: (0, n)},
        twins=[(c[k], coefficient(1)), (c[k + 1], coefficient(0))],
    ),
    claim(
        "basis/spans",
        "every polynomial of degree at most n is a combination of them",
        (
            Sum(binomial(n, k) * a[k] * t**k, (k, 0, n)),
            Sum(B(j, n, t) * Sum(binomial(j, k) * a[k], (k, 0, j)), (j, 0, n)),
        ),
        twins=[
            (Sum(a[k] * t**k, (k, 0, n)), Sum(B(j, n, t) * Sum(binomial(j, k) * a[k], (k, 0, j)), (j, 0, n))),
            (
                Sum(binomial(n, k) * a[k] * t**k, (k, 0, n)),
                Sum(B(j, n, t) * Sum(binomial(n, k) * a[k], (k, 0, j)), (j, 0, n)),
            ),
        ],
    ),
    argued(
        "basis/is-basis",
        "they are a basis of the polynomials of degree at most n",
        Known("Each of them is a combination of 1, t, ..., t^n, so it lies in that space.", "basis/to-powers"),
        Known("The derivatives at 0 of a combination give back its coefficients.", "basis/independent"),
        "If a combination is 0 for all t, so are its derivatives, hence each coefficient: they are independent.",
        Shown(
            "No binomial coefficient C(n, k) with k from 0 to n is 0, so every polynomial of degree at most n can be "
            "written with the coefficients C(n, k) a_k.",
            Ge(binomial(n, k), 1, evaluate=False),
            {k: (0, n)},
        ),
        Known("Written so, it is a combination of the Bernstein functions: they span the space.", "basis/spans"),
        "Independent functions that span a space are a basis of it.",
    ),
    claim(
        "powers/there-and-back",
        "to the Bernstein basis and back: the two changes of basis undo each other",
        (
            Sum((-1) ** (j + k) * binomial(n, k) * binomial(k, j) * (binomial(j, i) / binomial(n, i)), (j, i, k)),
            KroneckerDelta(i, k),
        ),
        {k: (0, n), i: (0, n)},
        twins=[
            (
                Sum(binomial(n, k) * binomial(k, j) * (binomial(j, i) / binomial(n, i)), (j, i, k)),
                KroneckerDelta(i, k),
            )
        ],
    ),
    claim(
        "powers/back-and-there",
        "to the powers and back: the two changes of basis undo each other",
        (
            Sum(binomial(j, k) / binomial(n, k) * ((-1) ** (i + k) * binomial(n, k) * binomial(k, i)), (k, i, j)),
            KroneckerDelta(i, j),
        ),
        {j: (0, n), i: (0, n)},
        twins=[
            (
                Sum(binomial(j, k) / binomial(n, k) * (binomial(n, k) * binomial(k, i)), (k, i, j)),
                KroneckerDelta(i, j),
            )
        ],
    ),
    *(
        claim(f"cubic/basis/{place}", f"number {place} of the cubic basis", (B(place, 3, t), function), twins=[twin])
        for place, function, twin in (
            (0, (1 - t) ** 3, (B(0, 3, t), 1 - t**3)),
            (1, 3 * t * (1 - t) ** 2, (B(1, 3, t), 3 * t**2 * (1 - t))),
            (2, 3 * t**2 * (1 - t), (B(2, 3, t), t**2 * (1 - t))),
            (3, t**3, (B(3, 3, t), (1 - t) ** 3)),
        )
    ),
    claim(
        "cubic/matrix",
        "the cubic curve as a product of matrices",
        (curve(3), MatMul(POWERS, CUBIC, Matrix([b[0], b[1], b[2], b[3]]))),
        twins=[
            (curve(3), MatMul(POWERS, CUBIC.T, Matrix([b[0], b[1], b[2], b[3]]))),
            (curve(3), MatMul(POWERS, CUBIC, Matrix([b[3], b[2], b[1], b[0]]))),
        ],
    ),
    claim(
        "cubic/matrix/inverse",
        "the cubic in powers of t as a product of matrices with the Bernstein functions",
        (
            Sum(a[k] * t**k, (k, 0, 3)),
            MatMul(
                Matrix([[B(0, 3, t), B(1, 3, t), B(2, 3, t), B(3, 3, t)]]),
                CUBIC.inv(),
                Matrix([a[0], a[1], a[2], a[3]]),
            ),
        ),
        twins=[
            (
                Sum(a[k] * t**k, (k, 0, 3)),
                MatMul(
                    Matrix([[B(0, 3, t), B(1, 3, t), B(2, 3, t), B(3, 3, t)]]),
                    CUBIC,
                    Matrix([a[0], a[1], a[2], a[3]]),
                ),
            )
        ],
    ),
]
