"""The Bernstein basis from one degree to another: recursion, elevation, subdivision, products, sums with the index."""

from sympy import Integral, Sum, Symbol, binomial

from bezteach.symbolic import B, i, j, n, r, t, u

from ..claim import claim
from ..forms import FROM_ONE, WITHIN

c = Symbol("c", real=True)
m = Symbol("m", integer=True, nonnegative=True)

RECURSION = [
    B(i, n, t),
    binomial(n, i) * t**i * (1 - t) ** (n - i),
    (binomial(n - 1, i) + binomial(n - 1, i - 1)) * t**i * (1 - t) ** (n - i),
    binomial(n - 1, i) * t**i * (1 - t) ** (n - i) + binomial(n - 1, i - 1) * t**i * (1 - t) ** (n - i),
    (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, t),
]
WHY = ["", "definition", "rule of Pascal's triangle", "multiplied out", "a factor 1 - t or t stands in front"]
LEFT = (1 - i / (n + 1)) * B(i, n + 1, t)
RIGHT = (i + 1) / (n + 1) * B(i + 1, n + 1, t)

CLAIMS = [
    claim(
        "basis/recursion",
        "each from two neighbours one degree lower",
        (RECURSION[0], RECURSION[-1]),
        FROM_ONE | WITHIN,
        twins=[
            (B(i, n, t), t * B(i, n - 1, t) + (1 - t) * B(i - 1, n - 1, t)),
            (B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, 1 - t)),
            (B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i + 1, n - 1, t)),
        ],
    ),
    claim(
        "basis/recursion/proof",
        "the recursion from the rule of Pascal's triangle",
        list(zip(RECURSION, WHY, strict=True)),
        FROM_ONE | WITHIN,
        twins=[[*RECURSION[:2], (binomial(n - 1, i) + binomial(n - 1, i + 1)) * t**i * (1 - t) ** (n - i)]],
    ),
    claim(
        "basis/pascal",
        "the rule of Pascal's triangle",
        (binomial(n - 1, i) + binomial(n - 1, i - 1), binomial(n, i)),
        FROM_ONE | WITHIN,
        twins=[(binomial(n - 1, i) + binomial(n - 1, i + 1), binomial(n, i))],
    ),
    claim(
        "quadratic/recursion/0",
        "the first of degree 2 from degree 1",
        (B(0, 2, t), (1 - t) * B(0, 1, t)),
        twins=[(B(0, 2, t), t * B(0, 1, t))],
    ),
    claim(
        "quadratic/recursion/1",
        "the middle one of degree 2 from degree 1",
        (B(1, 2, t), (1 - t) * B(1, 1, t) + t * B(0, 1, t)),
        twins=[(B(1, 2, t), (1 - t) * B(0, 1, t) + t * B(1, 1, t))],
    ),
    claim(
        "quadratic/recursion/2",
        "the last of degree 2 from degree 1",
        (B(2, 2, t), t * B(1, 1, t)),
        twins=[(B(2, 2, t), t * B(0, 1, t))],
    ),
    claim(
        "basis/elevation/first",
        "times 1 - t it is a multiple of the one with the same index, a degree higher",
        ((1 - t) * B(i, n, t), LEFT),
        WITHIN,
        twins=[((1 - t) * B(i, n, t), i / (n + 1) * B(i, n + 1, t)), ((1 - t) * B(i, n, t), RIGHT)],
    ),
    claim(
        "basis/elevation/second",
        "times t it is a multiple of the one with the next index, a degree higher",
        (t * B(i, n, t), RIGHT),
        WITHIN,
        twins=[
            (t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t)),
            (t * B(i, n, t), i / (n + 1) * B(i + 1, n + 1, t)),
        ],
    ),
    claim(
        "basis/elevation/third",
        "each from two neighbours one degree higher",
        (B(i, n, t), LEFT + RIGHT),
        WITHIN,
        twins=[(B(i, n, t), LEFT - RIGHT), (B(i, n, t), LEFT + i / (n + 1) * B(i + 1, n + 1, t))],
    ),
    claim(
        "basis/subdivision",
        "on the part [0, c] it is a combination of the same basis",
        (B(i, n, c * u), Sum(B(i, j, c) * B(j, n, u), (j, 0, n))),
        WITHIN,
        twins=[
            (B(i, n, c * u), Sum(B(j, i, c) * B(j, n, u), (j, 0, n))),
            (B(i, n, c * u), Sum(B(i, n, c) * B(j, n, u), (j, 0, n))),
        ],
    ),
    claim(
        "basis/quotient",
        "two neighbours have a rational quotient",
        ((i + 1) * (1 - t) * B(i + 1, n, t), (n - i) * t * B(i, n, t)),
        WITHIN,
        twins=[((i + 1) * t * B(i + 1, n, t), (n - i) * (1 - t) * B(i, n, t))],
    ),
    claim(
        "basis/elevation/by-r",
        "each from r + 1 neighbours r degrees higher",
        (
            B(i, n, t),
            Sum(binomial(n, i) * binomial(r, j - i) / binomial(n + r, j) * B(j, n + r, t), (j, i, i + r)),
        ),
        WITHIN,
        twins=[(B(i, n, t), Sum(binomial(r, j - i) / binomial(n + r, j) * B(j, n + r, t), (j, i, i + r)))],
    ),
    claim(
        "basis/product",
        "the product of two is a multiple of one of the sum of the degrees",
        (
            B(i, n, t) * B(j, m, t),
            binomial(n, i) * binomial(m, j) / binomial(n + m, i + j) * B(i + j, n + m, t),
        ),
        WITHIN | {j: (0, m)},
        twins=[(B(i, n, t) * B(j, m, t), B(i + j, n + m, t))],
    ),
    claim(
        "basis/gram",
        "the integral of the product of two",
        (
            Integral(B(i, n, t) * B(j, n, t), (t, 0, 1)),
            binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j) / (2 * n + 1),
        ),
        WITHIN | {j: (0, n)},
        twins=[
            (
                Integral(B(i, n, t) * B(j, n, t), (t, 0, 1)),
                binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j) / (n + 1),
            )
        ],
    ),
    claim(
        "basis/second-moment",
        "the squares of i/n, weighted by the basis",
        (Sum(i**2 / n**2 * B(i, n, t), (i, 0, n)), t**2 + t * (1 - t) / n),
        FROM_ONE,
        twins=[(Sum(i**2 / n**2 * B(i, n, t), (i, 0, n)), t**2)],
    ),
    claim(
        "basis/variance",
        "the spread of the index about its mean nt",
        (Sum((i - n * t) ** 2 * B(i, n, t), (i, 0, n)), n * t * (1 - t)),
        twins=[(Sum((i - n * t) ** 2 * B(i, n, t), (i, 0, n)), t * (1 - t))],
    ),
]
