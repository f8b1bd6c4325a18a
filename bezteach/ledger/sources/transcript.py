"""The transcript of lecture 5: Bézier curves, their joins, the one-sixth rule; B-splines from the files beside it."""

from ..claims.interpolation import touched
from ..claims.joins import PARABOLA_IN_TWO, TURNING_BACK, curvatures_agree, tangents_oppose, velocities_agree
from ..reading import amended, refuted_words, row
from .deck_curve import places_for_passages
from .transcript_knots import CLOSING, KNOTS, SUMMARY
from .transcript_splines import CURVE, DEFINITION, LOCAL

ORDER = "order for degree: the lecture itself says later that the order is the degree plus 1"


def direction(end):
    """The slip on a tangent and its edge."""
    return amended(
        f"the tangent at the {end} has the direction of the edge there",
        "an edge that is zero has no direction: its two points must differ",
    )


def smooth(printed):
    """The slip on how smooth a curve is."""
    return amended(
        printed,
        "it has all derivatives, and may have a cusp where the first is 0, as (0, 0), (1, 1), (0, 1), (1, 0) does",
    )


def whole(printed):
    """The slip on what one control point moves."""
    return amended(printed, "the start stays unless b_0 moves, the end unless b_n does; every other point moves")


ROWS = [
    row("overview, the space of quadratic functions", "examples/quadratic/bases"),
    row("overview, parametric form", "implicit/parametric"),
    row("overview, coefficients as vertices", "examples/power-points"),
    row("basis, definition", "basis/definition"),
    row("basis, n + 1 functions", "examples/exact-degree"),
    row("basis, of the polynomials of degree at most n", "basis/is-basis"),
    row("basis, of the polynomials of degree at most n, independent", "basis/independent"),
    row("basis, of the polynomials of degree at most n, all of them", "basis/spans"),
    row("basis, to powers", "basis/to-powers"),
    row("basis, from powers", "basis/from-powers"),
    row("basis, order 0", "constant/basis/0", amended("order 0: the constant function 1", ORDER)),
    row("basis, order 1, first", "linear/basis/0", amended("order 1: B_0 = 1 - t", ORDER)),
    row("basis, order 1, second", "linear/basis/1", amended("order 1: B_1 = t", ORDER)),
    row("basis, order 2, three", "examples/exact-degree", amended("order 2: three quadratic functions", ORDER)),
    row("basis, order 3, four", "examples/exact-degree", amended("order 3: four cubic functions", ORDER)),
    row("basis, not negative", "basis/non-negative"),
    row("basis, sum", "basis/unity"),
    row("curve, definition", "curve/definition"),
    row("curve, first point", "curve/start"),
    row("curve, last point", "curve/end"),
    row("curve, convex combination and convex hull", "curve/hull"),
    row("curve, tangent at the start", "curve/tangent/direction", direction("start")),
    row("curve, tangent at the end", "curve/tangent/direction", direction("end")),
    row("curve, cubic, three times the edge at the start", "examples/cubic-speed/start"),
    row("curve, cubic, three times the edge at the end", "examples/cubic-speed/end"),
    row("curve, independent of the coordinates", "curve/affine/coordinates"),
    row(
        "curve, variation diminishing",
        "curve/variation-diminishing",
        places_for_passages("a line meets a plane curve in no more points than its control polygon"),
    ),
    row("de Casteljau, stable", "algorithm/stable"),
    row("de Casteljau, level 0", "casteljau/start"),
    row("de Casteljau, a step", "casteljau/step"),
    row("de Casteljau, the point of the curve", "casteljau/curve"),
    row(
        "de Casteljau, convergence",
        "casteljau/curve",
        amended(
            "it converges to the point of the curve",
            "no limit is taken: after n rounds the point itself is left",
        ),
    ),
    row("de Casteljau, first part", "split/left"),
    row("de Casteljau, second part", "split/right"),
    row("de Casteljau, use, polygons for the curve", "limit/halving"),
    row("de Casteljau, use, intersections", "curve/hull/disjoint"),
    row("joins, more points by a higher degree", "curve/count"),
    row(
        "joins, oscillation at high degree",
        "curve/variation-diminishing",
        amended(
            "a curve of high degree may oscillate needlessly",
            "true of interpolation: a Bézier curve meets no line more often than its polygon passes it, at any degree",
        ),
    ),
    row(
        "joins, a local change moves the whole", "influence/everywhere", whole("a local change affects the whole curve")
    ),
    row("joins, C0 and G0", "joins/c0"),
    row(
        "joins, G1",
        "joins/g1",
        refuted_words(
            "G1: P_2, P_3 = Q_0 and Q_1 are on one line, that is, the tangents have the same direction",
            "P_2 = (1, 0), P_3 = Q_0 = (0, 0), Q_1 = (1, 0) are on one line, and the tangents (-3, 0) and (3, 0) have "
            "opposite directions: P_3 must lie strictly between P_2 and Q_1",
            lambda: tangents_oppose(*TURNING_BACK),
        ),
    ),
    row(
        "joins, C1",
        "joins/c1",
        amended(
            "C1: G1, and |P_3 - P_2| = |Q_1 - Q_0|",
            "true if G1 means one direction, P_3 - P_2 = Q_1 - Q_0, and both cubics run over intervals of one length: "
            "with G1 as it is printed, three points on a line, P_2 = Q_1 would be C1",
        ),
    ),
    row(
        "joins, C2, its name",
        "joins/g2",
        refuted_words(
            "C2 is continuity of the curvature",
            "the parabola (0, 0), (3, 6), (9, 0) cut at 1/3, each part on [0, 1]: the curvature is continuous and "
            "the velocity is not; continuous curvature is G2",
            lambda: curvatures_agree(*PARABOLA_IN_TWO) and not velocities_agree(*PARABOLA_IN_TWO),
        ),
    ),
    row(
        "joins, C2, five points",
        "joins/c2",
        amended(
            "C2 ties P_1, P_2, P_3, Q_1, Q_2: the second derivatives are equal",
            "C1 is needed too: in the second derivatives alone P_3 = Q_0 cancels, and they tie four points",
        ),
    ),
    row("one-sixth rule, C1", "interpolation/c1"),
    row(
        "one-sixth rule, the control points",
        "interpolation/one-sixth",
        amended(
            "at D_i, on both sides, at the distance |D_{i+1} - D_{i-1}| / 6 in the direction of D_{i+1} - D_{i-1}",
            "the first and the last data point have one neighbour only and need a rule of their own; if both "
            "neighbours are one point there is no direction, and the distance is 0",
        ),
    ),
    row(
        "one-sixth rule, local",
        "interpolation/reach",
        refuted_words(
            "changing a data point affects only the segments next to it",
            "two segments meet in D_3, and four change with it, all those from D_1 to D_5: the control points beside "
            "D_2 and D_4 depend on it",
            lambda: touched(3, 8) == [1, 2, 3, 4],
        ),
    ),
    row(
        "B-splines, a Bézier curve is moved as a whole",
        "influence/everywhere",
        whole("moving any control point affects the whole curve"),
    ),
    row(
        "B-splines, less influence with the distance",
        "influence/falls",
        amended(
            "the influence falls with the distance",
            "with the distance of the parameter t from i/n, on either side: it is no distance in the plane",
        ),
    ),
    *LOCAL,
    row(
        "B-splines, why the influence is global",
        "basis/positive-inside",
        amended(
            "the Bernstein functions are not identically 0 on the whole interval [0, 1]",
            "too weak, B-spline functions are not either: the Bernstein functions are 0 at no t between 0 and 1",
        ),
    ),
    *DEFINITION,
    *CURVE,
    *KNOTS,
    row("summary, weighted averages", "curve/barycentric"),
    row(
        "summary, smooth curves",
        "points/cusp",
        smooth("the weighted averages of the control points make a smooth curve"),
    ),
    row("summary, first point", "curve/start"),
    row("summary, last point", "curve/end"),
    row("summary, convex hull", "curve/hull"),
    row("summary, the algorithm evaluates", "casteljau/curve"),
    row("summary, the algorithm cuts", "algorithm/parts"),
    *SUMMARY,
    row("summary, basis functions combine control points", "curve/definition"),
    row(
        "summary, smooth curves again",
        "points/cusp",
        smooth("basis functions and control points make the smooth curve that is wanted"),
    ),
    *CLOSING,
]
