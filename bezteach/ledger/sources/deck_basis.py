"""The deck, section 1: the definition of the curve, and the properties of its basis."""

from sympy import Le, Sum, binomial

from bezteach.symbolic import B, i, j, n, t

from ..claims import bezier, degrees, slopes
from ..forms import FROM_ONE, WITHIN
from ..reading import amended, refuted, row

RECURSION = degrees.RECURSION
PRINTED_RECURSION = [
    *RECURSION[:3],
    binomial(n - 1, i) * t**i * (1 - t) ** (n - i) + binomial(n - 1, i - 1) * t ** (i - 1) * (1 - t) ** (n - i + 1),
    RECURSION[-1],
]


def recursion_without_range():
    """The slip of the recursion, which the deck prints twice."""
    return amended(
        (RECURSION[0], RECURSION[-1]),
        "n >= 1 is left out: the only function of degree 0 does not come from a lower degree",
        WITHIN,
    )


ROWS = [
    row("1, introduction, a curve of polynomials", "curve/powers"),
    row("1.1, 1, the curve in relative vectors", "bezier/form"),
    row("1.1, 1, control polygon", "bezier/vertices"),
    row(
        "1.1, 1, the functions f_i",
        "bezier/basis",
        amended(
            (bezier.TAIL, bezier.IN_POWERS),
            "at i = 0 the term j = 0 holds C(-1, -1), which has no value unless it is agreed to be 1; f_0 = 1 stands "
            "apart, and the formula is right for i = 1, ..., n",
            WITHIN,
        ),
    ),
    row("1.1, 1, the function f_0", "bezier/basis/first"),
    row("1.1, 1, n = 3, f_0", "bezier/cubic/0"),
    row("1.1, 1, n = 3, f_1", "bezier/cubic/1"),
    row("1.1, 1, n = 3, f_2", "bezier/cubic/2"),
    row("1.1, 1, n = 3, f_3", "bezier/cubic/3"),
    row("1.1, 2, absolute vectors b_j = b_{j-1} + a_j", "bezier/vertices"),
    row("1.1, 2, the equation becomes", "bezier/to-bernstein"),
    row("1.1, 2, the curve", "curve/definition"),
    row("1.1, 2, Bernstein basis", "basis/definition"),
    row("1.1, 2, n = 3, B_0", "cubic/basis/0"),
    row("1.1, 2, n = 3, B_1", "cubic/basis/1"),
    row("1.1, 2, n = 3, B_2", "cubic/basis/2"),
    row("1.1, 2, n = 3, B_3", "cubic/basis/3"),
    row("1.1, 2, n = 3, matrix form", "cubic/matrix"),
    row("1.2, basis property 1, not negative", "basis/non-negative"),
    row("1.2, basis property 1, at most 1", "basis/at-most-one"),
    row("1.2, basis property 2, sum", "basis/unity"),
    row("1.2, basis property 2, proof", "basis/unity/proof"),
    row("1.2, basis property 3, symmetry", "basis/symmetry"),
    row("1.2, basis property 4, derivative", "basis/derivative"),
    row(
        "1.2, basis property 4, proof",
        "basis/derivative/proof",
        amended(
            slopes.SLOPE,
            "at i = n a power of 1 - t has the exponent -1 beside the factor 0, and no value at t = 1: the lines hold "
            "as they stand for i = 1, ..., n - 1; the last function is differentiated apart",
            FROM_ONE | {i: (1, n)},
        ),
    ),
    row("1.2, basis property 4, proof, the last function", "basis/derivative/proof/last"),
    row(
        "1.2, basis property 5, greatest value",
        "basis/maximum",
        amended(
            Le(B(i, n, t), B(i, n, i / n), evaluate=False),
            "n >= 1 is left out, without which i/n is no number, and so is t in [0, 1], outside of which the values "
            "have no bound",
            WITHIN,
        ),
    ),
    row("1.2, basis property 5, from property 4", "basis/maximum/from-derivative"),
    row("1.2, basis property 6, recursion", "basis/recursion", recursion_without_range()),
    row("1.2, basis property 6, picture of B_{0,2}", "quadratic/recursion/0"),
    row("1.2, basis property 6, picture of B_{1,2}", "quadratic/recursion/1"),
    row("1.2, basis property 6, picture of B_{2,2}", "quadratic/recursion/2"),
    row("1.2, basis property 6, recursion, printed again", "basis/recursion", recursion_without_range()),
    row(
        "1.2, basis property 6, proof, third line",
        "basis/recursion/proof",
        refuted(PRINTED_RECURSION, FROM_ONE | {i: (1, n)}),
    ),
    row("1.2, basis property 7, elevation, first", "basis/elevation/first"),
    row("1.2, basis property 7, elevation, second", "basis/elevation/second"),
    row("1.2, basis property 7, elevation, third", "basis/elevation/third"),
    row("1.2, basis property 8, subdivision", "basis/subdivision"),
    row("1.2, basis property 9, integral", "basis/integral"),
    row(
        "1.2, basis property 10, a power in the basis",
        "basis/from-powers",
        amended(
            (t**i, Sum(binomial(j, i) / binomial(n, i) * B(j, n, t), (j, i, n))),
            "i <= n is left out: a higher power of t is no combination of functions of degree n",
        ),
    ),
    row(
        "1.2, basis property 10, t in the basis",
        "basis/linear-precision",
        amended(
            (t, Sum(j / n * B(j, n, t), (j, 1, n))),
            "n >= 1 is left out: for n = 0 the sum is empty",
        ),
    ),
    row("1.2, basis property 10, in powers, first form", "basis/to-powers"),
    row("1.2, basis property 10, in powers, second form", "basis/to-powers/second"),
    row("1.2, basis property 10, in powers, the chain", "basis/to-powers/both"),
    row("1.2, basis property 11, at 0, i = 0", "basis/start/first"),
    row("1.2, basis property 11, at 0, i = 1, ..., n", "basis/start/others"),
    row("1.2, basis property 11, at 1, i = n", "basis/end/last"),
    row("1.2, basis property 11, at 1, i = 0, ..., n - 1", "basis/end/others"),
    row("1.2, basis property 12, independent", "basis/independent"),
    row("1.2, basis property 12, every polynomial", "basis/spans"),
    row(
        "1.2, basis property 12, a basis",
        "basis/is-basis",
        amended(
            "a basis of the space of the polynomials of degree n",
            "degree at most n is meant: those of degree exactly n are no space, as t + (1 - t) has the degree 0",
        ),
    ),
]
