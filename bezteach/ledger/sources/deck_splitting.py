"""The deck, section 2.3: splitting a curve, parts of a curve, and the limit of splitting."""

from fractions import Fraction

from ..claims.limit import pieces
from ..claims.segments import BEHIND_AS_PRINTED, FROM_T1, t2
from ..reading import amended, refuted, refuted_words, row

LINE = [(Fraction(0),), (Fraction(1),)]


def open_range():
    """The slip of the open range of the new parameter."""
    return amended(
        "0 < u < 1",
        "0 <= u <= 1 is meant: the proof puts in u = 0 and u = 1, and without its ends neither part is a Bézier curve",
    )


def without_index(place):
    """The slip of the last line of both proofs."""
    return amended(f"b^n({place})", f"the lower index 0 is left out: b_0^n({place}) is meant")


def shared_joint():
    """A line cut in halves has three control points, not four."""
    return len({point for piece in pieces(LINE, 1) for point in piece}) != 2 * len(LINE)


ROWS = [
    row("2.3, why to split, no local change", "influence/everywhere"),
    row("2.3, split theorem, control points of the front", "split/left", open_range()),
    row("2.3, split theorem, control points of the back", "split/right"),
    row("2.3, split theorem, first points of the columns", "split/left"),
    row("2.3, split theorem, last points of the columns, in reverse", "split/right"),
    row("2.3, split theorem, proof, p_1(u) = p(t* u)", "split/left"),
    row("2.3, split theorem, proof, p_2(u) = p[1 - (1 - t*)(1 - u)]", "split/right", open_range()),
    row("2.3, split theorem, proof, p_1(0)", "split/left/start"),
    row("2.3, split theorem, proof, p_1(1)", "split/left/end"),
    row("2.3, split theorem, proof, p_2(0)", "split/right/start"),
    row("2.3, split theorem, proof, p_2(1)", "split/right/end"),
    row("2.3, split theorem, proof, the front", "split/left/proof", without_index("t* u")),
    row("2.3, split theorem, proof, the back", "split/right/proof", without_index("1 - (1 - t*)(1 - u)")),
    row("2.3, split, worked example, point at 1/3", "examples/split/point"),
    row("2.3, split, worked example, triangle", "examples/split/triangle"),
    row("2.3, split, worked example, front", "examples/split/front"),
    row("2.3, split, worked example, back", "examples/split/back"),
    row("2.3, any part, its control points", "segment/points"),
    row("2.3, any part, scheme 1, first cut", "split/left"),
    row(
        "2.3, any part, scheme 1, step 1, u = t/t_2",
        "segment/first-scheme/range",
        amended(
            "the points of the front are those of a new curve p(u)",
            "the letter p is that of the whole curve already: the new curve at u is p(t_2 u)",
        ),
    ),
    row("2.3, any part, scheme 1, step 2, u* = t_1/t_2", "segment/first-scheme/parameter"),
    row("2.3, any part, scheme 1, step 2, the part", "segment/first-scheme"),
    row("2.3, any part, scheme 2, first cut", "split/right"),
    row(
        "2.3, any part, scheme 2, local parameter t_1/t_2",
        "segment/second-scheme/parameter",
        refuted((BEHIND_AS_PRINTED, t2), FROM_T1),
    ),
    row("2.3, any part, scheme 2, the part", "segment/second-scheme"),
    row("2.3, any part, worked example, triangle at 3/4", "examples/part/first-triangle"),
    row(
        "2.3, any part, worked example, front",
        "examples/part/front",
        amended(
            "the control points for t from 0 to 3/4",
            "the parameter of the curve is u in the problem and t in its solution, where u is that of the front",
        ),
    ),
    row("2.3, any part, worked example, u = 1/3", "examples/part/parameter"),
    row("2.3, any part, worked example, triangle at 1/3", "examples/part/second-triangle"),
    row("2.3, any part, worked example, the part", "examples/part/middle"),
    row(
        "2.3, limit theorem, number of pieces",
        "limit/pieces",
        amended(
            "k cuts divide the curve into 2^k pieces",
            "k rounds are meant, in each of which every piece is cut; k cuts make k + 1 pieces",
        ),
    ),
    row(
        "2.3, limit theorem, number of control points",
        "limit/points",
        refuted_words(
            "the 2^k pieces have 2^k (n + 1) control points altogether",
            "n = 1, k = 1: the line from 0 to 1 has the halves 0, 1/2 and 1/2, 1, which are three control points and "
            "not four: neighbours share one, and there are 2^k n + 1",
            shared_joint,
        ),
    ),
    row(
        "2.3, limit theorem, the limit",
        "limit/halving",
        amended(
            "the control points of the pieces tend to p(t), as k grows",
            "tends to the whole curve, as a set, is meant, and pieces that become short, as halves do: if round i cuts "
            "the first piece at 1 - 1/(i + 1)^2, it keeps the part from 0 to (k + 2)/(2 k + 2), more than a half, and "
            "its polygon stays away from the curve",
        ),
    ),
]
