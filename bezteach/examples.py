"""The sources' worked examples as exact data: where each stands, what it starts from, what it prints, what is true.

Numbers are ints and Fractions; a point is a tuple, a polynomial the tuple of its coefficients in ascending powers. What
a source prints wrongly stays under ``printed`` as it stands there; ``corrected`` has the truth for those entries alone,
and ``answer`` the truth for all. Sources by their short names: deck, games, notes, transcript.

>>> EXAMPLES["deck/split"].answer["left"][-1]
(1, Fraction(5, 3))
>>> [example.id for example in EXAMPLES.values() if example.corrected]
['deck/quartic', 'deck/segment', 'deck/derivatives', 'notes/second-difference']
"""

from fractions import Fraction as F
from typing import NamedTuple


class Example(NamedTuple):
    """One worked example; ``given``, ``printed`` and ``corrected`` map names to exact data."""

    id: str
    source: str
    place: str
    about: str
    given: dict
    printed: dict
    corrected: dict

    @property
    def answer(self):
        """The true values: those printed, with the corrections put in."""
        return self.printed | self.corrected


def _example(id, place, about, *, given, printed, corrected=None):
    return Example(id, id.split("/")[0], place, about, given, printed, corrected or {})


_BERNSTEIN_CUBIC = ((1, -3, 3, -1), (0, 3, -6, 3), (0, 0, 3, -3), (0, 0, 0, 1))

_SPLIT_POINTS = ((0, 0), (1, 3), (2, 1), (3, 3))
_SPLIT_TRIANGLE = (
    _SPLIT_POINTS,
    ((F(1, 3), 1), (F(4, 3), F(7, 3)), (F(7, 3), F(5, 3))),
    ((F(2, 3), F(13, 9)), (F(5, 3), F(19, 9))),
    ((1, F(5, 3)),),
)

_SEGMENT_POINTS = ((-9, 0), (-3, 6), (3, 6), (9, 0))
_SEGMENT_FIRST_TRIANGLE = (
    _SEGMENT_POINTS,
    ((F(-9, 2), F(9, 2)), (F(3, 2), 6), (F(15, 2), F(3, 2))),
    ((0, F(45, 8)), (6, F(21, 8))),
    ((F(9, 2), F(27, 8)),),
)
_SEGMENT_SECOND_TRIANGLE = (
    ((-9, 0), (F(-9, 2), F(9, 2)), (0, F(45, 8)), (F(9, 2), F(27, 8))),
    ((F(-15, 2), F(3, 2)), (-3, F(39, 8)), (F(3, 2), F(39, 8))),
    ((-6, F(21, 8)), (F(-3, 2), F(39, 8))),
    ((F(-9, 2), F(27, 8)),),
)

EXAMPLES = {
    example.id: example
    for example in [
        _example(
            "deck/bezier-basis",
            "1.1, Bézier's original definition, n = 3",
            "Bézier's own basis f_0 .. f_3, each the sum of the Bernstein functions from i on",
            given={"degree": 3},
            printed={"basis": ((1,), (0, 3, -3, 1), (0, 0, 3, -2), (0, 0, 0, 1))},
        ),
        _example(
            "deck/bernstein-cubic",
            "1.1, Bernstein-Bézier curves, n = 3",
            "the cubic Bernstein basis and the matrix for [1 t t^2 t^3]",
            given={"degree": 3},
            printed={
                "basis": _BERNSTEIN_CUBIC,
                "matrix": ((1, 0, 0, 0), (-3, 3, 0, 0), (3, -6, 3, 0), (-1, 3, -3, 1)),
            },
        ),
        _example(
            "deck/recursion",
            "1.2, property 6 of the basis",
            "the quadratic basis from the linear one: which function counts with 1 - u, and which one with u",
            given={"degree": 2},  # B_{i,2} = (1 - u) B_{stay,1} + u B_{move,1}, without the term that is None
            printed={"stay": (0, 1, None), "move": (None, 0, 1)},
        ),
        _example(
            "deck/quartic",
            "1.2, property 6 of the curve, note on the convexity theorem",
            "a quartic with a free height w: y and y'' in powers, and for which w it is convex",
            given={
                "points": ((0, 0), (F(1, 4), F(1, 4)), (F(1, 2), "w"), (F(3, 4), F(1, 4)), (1, 0)),
                "degree": 4,
            },
            printed={  # y = y_plain + w y_beside_w, and y'' likewise
                "x": (0, 1),
                "y_plain": (0, 1, -3, 4, -2),
                "y_beside_w": (0, 0, 6, 0, -6),
                "second_plain": (-6, 24, -24),
                "second_beside_w": (12, -72, 72),
                "convex_for_w": (0, F(1, 2)),
            },
            corrected={"y_beside_w": (0, 0, 6, -12, 6)},
        ),
        _example(
            "deck/quadratic-by-steps",
            "2.1, three-tangent theorem",
            "two rounds of interpolation written out: what stands beside b_0, b_1 and b_2",
            given={"degree": 2},
            printed={"basis": ((1, -2, 1), (0, 2, -2), (0, 0, 1))},
        ),
        _example(
            "deck/split",
            "2.3, example of splitting (and 2.1, worked example of the algorithm)",
            "a cubic split at t = 1/3: the whole triangle and both halves",
            given={"points": _SPLIT_POINTS, "t": F(1, 3)},
            printed={
                "triangle": _SPLIT_TRIANGLE,
                "point": (1, F(5, 3)),
                "left": ((0, 0), (F(1, 3), 1), (F(2, 3), F(13, 9)), (1, F(5, 3))),
                "right": ((1, F(5, 3)), (F(5, 3), F(19, 9)), (F(7, 3), F(5, 3)), (3, 3)),
            },
        ),
        _example(
            "deck/segment",
            "2.3, example of an arbitrary part, and the scheme 2 before it",
            "the part of a cubic between 1/4 and 3/4 by two cuts, the second in the local parameter; for scheme 2 "
            "(front cut first) the deck prints the local parameter t1/t2",
            given={"points": _SEGMENT_POINTS, "start": F(1, 4), "end": F(3, 4)},
            printed={
                "first_triangle": _SEGMENT_FIRST_TRIANGLE,
                "front": ((-9, 0), (F(-9, 2), F(9, 2)), (0, F(45, 8)), (F(9, 2), F(27, 8))),
                "local_parameter": F(1, 3),
                "second_triangle": _SEGMENT_SECOND_TRIANGLE,
                "part": ((F(-9, 2), F(27, 8)), (F(-3, 2), F(39, 8)), (F(3, 2), F(39, 8)), (F(9, 2), F(27, 8))),
                "scheme_2_local_parameter": F(1, 3),
            },
            corrected={"scheme_2_local_parameter": F(2, 3)},
        ),
        _example(
            "deck/derivatives",
            "2.2, derivatives as a by-product, n = 3",
            "the factor and the weights of the points of a level of the triangle in p', p'' and p''' of a cubic",
            given={"degree": 3},
            printed={
                "factors": (3, 6, 6),
                "weights": ((-1, 1), (1, -2, 1), (1, 3, -3, 1)),
            },
            corrected={"weights": ((-1, 1), (1, -2, 1), (-1, 3, -3, 1))},
        ),
        _example(
            "games/parabola",
            "power basis against Bernstein basis",
            "one parabola in both bases: coefficients of t^0, t^1, t^2, and control points",
            given={"coefficients": ((1, 0), (-2, 0), (1, 1))},
            printed={"points": ((1, 0), (0, 0), (0, 1))},
        ),
        _example(
            "games/low-degrees",
            "the first few Bernstein functions",
            "the bases of degree 0, 1 and 2",
            given={"degrees": (0, 1, 2)},
            printed={"bases": (((1,),), ((1, -1), (0, 1)), ((1, -2, 1), (0, 2, -2), (0, 0, 1)))},
        ),
        _example(
            "games/quadratic",
            "another example",
            "the control points of a quadratic, drawn only",
            given={"points": ((0, 1), (1, 1), (0, 2))},
            printed={},
        ),
        _example(
            "notes/matrix",
            "2.4, matrix form",
            "the cubic basis, its matrix for [t^3 t^2 t 1], and the row [3t^2 2t 1 0] of the tangent",
            given={"degree": 3},
            printed={
                "basis": _BERNSTEIN_CUBIC,
                "matrix_descending": ((-1, 3, -3, 1), (3, -6, 3, 0), (-3, 3, 0, 0), (1, 0, 0, 0)),
                "tangent_row": ((0, 0, 3), (0, 2), (1,), (0,)),
            },
        ),
        _example(
            "notes/second-difference",
            "2.3.2, differences",
            "the second difference as weights of p_i, p_{i+1}, p_{i+2}; printed with p_{i+1} twice",
            given={"order": 2},
            printed={"weights": (1, -1, 0)},
            corrected={"weights": (1, -2, 1)},
        ),
        _example(
            "transcript/low-degrees",
            "Bernstein basis, pictures of low degree",
            "the bases of degree 0 and 1",
            given={"degrees": (0, 1)},
            printed={"bases": (((1,),), ((1, -1), (0, 1)))},
        ),
        _example(
            "transcript/end-tangent",
            "properties of the Bézier curve",
            "how many times as long as the first edge the end tangent of a cubic is",
            given={"degree": 3},
            printed={"factor": 3},
        ),
        _example(
            "transcript/one-sixth",
            "joining Bézier curves: interpolation",
            "the inner control points beside a data point: this fraction of the chord of its two neighbours",
            given={"degree": 3},
            printed={"factor": F(1, 6)},
        ),
        _example(
            "transcript/uniform-knots",
            "knot vectors, uniform",
            "a uniform knot vector",
            given={"first": 0, "step": 1, "length": 6},
            printed={"knots": (0, 1, 2, 3, 4, 5)},
        ),
        _example(
            "transcript/clamped-knots",
            "knot vectors, quasi-uniform",
            "a clamped knot vector of degree 2: for six control points",
            given={"degree": 2, "count": 6},
            printed={"knots": (0, 0, 0, 1, 2, 3, 4, 4, 4)},
        ),
        _example(
            "transcript/bezier-knots",
            "B-splines and Bézier curves",
            "the knots with which a B-spline of degree n is a Bézier curve: n + 1 of each, here n = 3",
            given={"degree": 3},
            printed={"knots": (0, 0, 0, 0, 1, 1, 1, 1)},
        ),
    ]
}
