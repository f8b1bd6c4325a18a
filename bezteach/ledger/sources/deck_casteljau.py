"""The deck, section 2.1: the three-tangent theorem, de Casteljau's algorithm and its operator form."""

from sympy import Rational, Sum

from bezteach.symbolic import B, E, b, i, j, k, n, t

from ..forms import FROM_ONE, G, curve
from ..reading import amended, row

THIRD = Rational(1, 3)


def loose_combination(printed):
    """The slip of a curve as a linear combination of two of lower degree."""
    return amended(
        printed,
        "a linear combination has numbers for factors; here they are 1 - t and t and change along the curve: with "
        "numbers the degree could not rise",
    )


def two_levels(printed):
    """The slip of two steps of the algorithm with no word on the degree."""
    return amended(printed, "n >= 2 is left out: a line has only one level above its points", FROM_ONE)


ROWS = [
    row("2.1, three-tangent theorem, (1)", "three-tangents/first-level"),
    row("2.1, three-tangent theorem, (2)", "three-tangents/first-level"),
    row("2.1, three-tangent theorem, (3)", "three-tangents/second-level"),
    row("2.1, three-tangent theorem, (1) and (2) put into (3)", "three-tangents/quadratic"),
    row("2.1, three-tangent theorem, conclusion 1, first edge", "three-tangents/ratio/edge"),
    row("2.1, three-tangent theorem, conclusion 1, second edge", "three-tangents/ratio/edge"),
    row("2.1, three-tangent theorem, conclusion 1, line between", "three-tangents/ratio/tangent"),
    row(
        "2.1, three-tangent theorem, conclusion 1, value t/(1 - t)",
        "three-tangents/ratio/edge",
        amended(
            (G * b[0] - b[0], t / (1 - t) * (b[1] - G * b[0])),
            "t < 1 is left out, and that b_0, b_1, b_2 are different, and b_0^1 and b_1^1: else a ratio has no value",
        ),
    ),
    row("2.1, three-tangent theorem, conclusion 2, first edge", "three-tangents/tangent/start"),
    row("2.1, three-tangent theorem, conclusion 2, second edge", "three-tangents/tangent/end"),
    row(
        "2.1, three-tangent theorem, conclusion 2, line between",
        "three-tangents/tangent/inner",
        amended(
            "for any three points, b_0 b_1, b_1 b_2 and b_0^1 b_1^1 are tangents",
            "that the two points of each are different is left out: else there is no line, and the derivative is 0",
        ),
    ),
    row("2.1, three-tangent theorem, consequence 1, three interpolations", "casteljau/interpolations"),
    row(
        "2.1, three-tangent theorem, consequence 2, two linear curves",
        "casteljau/combination",
        loose_combination("a quadratic curve is a linear combination of two linear ones"),
    ),
    row("2.1, algorithm, n + 1 control points", "curve/count"),
    row("2.1, algorithm, level 0", "casteljau/start"),
    row("2.1, algorithm, level k", "casteljau/step"),
    row("2.1, algorithm, the point of the curve", "casteljau/curve"),
    row("2.1, algorithm, picture, one point less with each level", "casteljau/levels"),
    row("2.1, algorithm, picture, the last point", "casteljau/curve"),
    row("2.1, algorithm, note 1, the path of the last point", "casteljau/curve"),
    row(
        "2.1, algorithm, note 2, first n and last n control points",
        "casteljau/combination",
        loose_combination("a curve of degree n is a linear combination of two curves of degree n - 1"),
    ),
    row(
        "2.1, algorithm, worked example",
        "examples/split/point",
        amended(
            (curve(3, at=THIRD), Sum(B(i, n, THIRD) * b[i], (i, 0, 3))),
            "n stands for 3, the degree of this curve, as in the same example in 2.3",
        ),
    ),
    row("2.1, operator form, identity", "operator/identity"),
    row(
        "2.1, operator form, shift",
        "operator/shift",
        amended((E * b[j], b[j + 1]), "j < n is left out: after b_n there is no control point"),
    ),
    row(
        "2.1, operator form, k shifts",
        "operator/shift-often",
        amended((E**k * b[j], b[j + k]), "j + k <= n is left out: after b_n there is no control point"),
    ),
    row(
        "2.1, operator form, shift back",
        "operator/shift-back",
        amended((b[j] / E, b[j - 1]), "j >= 1 is left out: before b_0 there is no control point"),
    ),
    row("2.1, operator form, first step", "casteljau/combination"),
    row(
        "2.1, operator form, second step",
        "casteljau/combination",
        two_levels((curve(n - 1), G * curve(n - 2))),
    ),
    row("2.1, operator form, two steps", "casteljau/operator", two_levels((curve(n), G**2 * curve(n - 2)))),
    row(
        "2.1, operator form, n steps",
        "casteljau/operator",
        amended(
            "the last line is the n-th power applied to b_0(t)",
            "b_0 is meant, the control point b_0^0, which does not depend on t",
        ),
    ),
    row("2.1, operator form, intermediate points", "casteljau/points"),
    row(
        "2.1, operator form, path of the intermediate points",
        "casteljau/points",
        amended(
            "the path of the points of level k is one curve of degree k",
            "each point of level k has a path of its own: they are n + 1 - k curves of degree k",
        ),
    ),
]
