"""What a board says beside its picture, in exact numbers: for each layer shown some titled rows."""

from fractions import Fraction
from functools import lru_cache

import numpy as np

from ... import numeric
from ...display import number, point
from .blocks import Block, exact_array, listed, name_of, power, root_of, times
from .join_words import frames_said, local_said, natural_said, pieces_said
from .shape_words import circle_said, hull_said, line_said
from .spline_words import breaks_said, deboor_said, functions_said, knots_said, span_said, spline_said

DATA = {"local", "natural"}  # layers for which the points are data


def blocks(state):
    """The blocks of the layers shown, in their order; the control points come first.

    >>> from .state import state_of
    >>> for block in blocks(state_of([(0, 0), (1, 2), (2, 0)], show=["curve", "elevated"])):
    ...     print(block.title, *block.rows)
    Control points ('(0, 0)', '(1, 2)', '(2, 0)')
    Control points in degree 3 (升阶) ('(0, 0)', '(2/3, 4/3)', '(4/3, 4/3)', '(2, 0)')
    """
    given = "Data points" if DATA & {*state.show} else "Control points"
    said = [Block(given, listed(state.points)), *([] if state.knots is None else knots_said(state))]
    for name in state.show:
        said += SAID[name](state) if name in SAID else []
    return said


@lru_cache(maxsize=2)
def _triangle(points, t):
    """De Casteljau's levels, which three layers look at."""
    return numeric.de_casteljau(points, t)


def _cut(levels):
    """Control points of both halves: the first points of the levels, and the last ones from the last level back."""
    return exact_array([level[0] for level in levels]), exact_array([level[-1] for level in levels[::-1]])


def _point(state):
    return [Block(f"The point at t = {number(state.t)}", ((point(numeric.evaluate(state.points, state.t)),),))]


def _levels(state):
    levels = _triangle(state.points, state.t)
    last = len(levels) - 1 if state.level is None else state.level
    size = len(levels[0])
    rows = tuple(tuple(point(levels[k][row - k]) for k in range(min(row, last) + 1)) for row in range(size))
    return [Block(f"De Casteljau's triangle at t = {number(state.t)}", rows)]


def _halves(state):
    left, right = _cut(_triangle(state.points, state.t))
    return [
        Block(f"Left half (前半段) {_over(0, state.t)}, circles", listed(left)),
        Block(f"Right half (后半段) {_over(state.t, 1)}, squares", listed(right)),
        Block("Cut point", ((f"p({number(state.t)})", point(right[0])),)),
    ]


def _over(start, end):
    interval = f"over [{number(start)}, {number(end)}]"
    return interval + ", one point" if start == end else interval


def _part(state):
    a, b = state.a, state.b
    where = f"from {number(a)} back to {number(b)}, run backwards" if a > b else _over(a, b)
    return [Block(f"Part (子曲线段) {where}", listed(_between(state.points, a, b))), *_local(a, b)]


def _between(points, a, b):
    """Control points over [a, b] by two cuts: those of ``numeric.segment`` in a third of its time."""
    if a == 1:  # no piece is behind a: back from the end is the piece behind b, turned round
        return _cut(numeric.de_casteljau(points, b))[1][::-1]
    behind = _cut(numeric.de_casteljau(points, a))[1]
    return _cut(numeric.de_casteljau(behind, Fraction(b - a) / (1 - a)))[0]


def _local(a, b):
    """Where the second of two cuts stands in the piece that the first one left, in either order."""
    if not 0 < a < b < 1:
        return []
    rows = (
        ("cut at b, keep the left: then at", f"a/b = {number(a / b)}"),
        ("cut at a, keep the right: then at", f"(b - a)/(1 - a) = {number((b - a) / (1 - a))}"),
    )
    return [Block("Local parameter (局部参数) of the second cut", rows)]


def _tangents(state):
    levels, n, t = _triangle(state.points, state.t), len(state.points) - 1, number(state.t)
    start, end = levels[-2]
    edge = end - start
    rows = [
        (f"p({t})", point(levels[-1][0])),
        (f"edge {name_of(0, n - 1)} {name_of(1, n - 1)}", point(edge)),
        (f"p'({t}) = {n} times the edge", point(n * edge)),
    ]
    if not edge.any():
        rows.append((f"p'({t}) = 0", "the edge is one point and gives no tangent"))
    return [Block(f"Tangent (切线) at t = {t}", tuple(rows)), *(_ratios(levels, state.t) if n == 2 else [])]


def _ratios(levels, t):
    """How the middle tangent of a parabola divides the other two, and its point of contact the middle one."""
    (b0, b1, b2), (left, right), _ = levels
    ratio = f"{t.numerator} : {t.denominator - t.numerator}"
    divided = (("b₀¹", "b₀ b₁", b1 - b0), ("b₁¹", "b₁ b₂", b2 - b1), ("p(t)", "b₀¹ b₁¹", right - left))
    rows = tuple(
        (f"{by} divides {leg}", ratio if along.any() else "no ratio: the leg is one point")
        for by, leg, along in divided
    )
    return [Block("Three tangents (三切线定理) in the ratio t : (1 - t)", rows)]


def _hodograph(state):
    first, second = numeric.hodograph(state.points), numeric.hodograph(state.points, 2)
    derivatives = {  # t may be an end: each is said once
        "p'(0)": first[0],
        f"p'({number(state.t)})": numeric.derivative(state.points, state.t),
        "p'(1)": first[-1],
        "p''(0)": second[0],
        "p''(1)": second[-1],
    }
    return [
        Block(f"Control points of the hodograph (速端曲线), degree {len(first) - 1}", listed(first)),
        Block("Derivatives", tuple((name, point(vector)) for name, vector in derivatives.items())),
    ]


def _elevated(state):
    raised = numeric.elevate(state.points, state.raised)
    return [Block(f"Control points in degree {len(raised) - 1} (升阶)", listed(raised))]


def _halving(state):
    """Polygon and curve are nowhere further apart than n D / (8 4^depth): the ledger's limit/halving."""
    n, pieces = len(state.points) - 1, 2**state.depth
    bend2 = max((bend @ bend for bend in np.diff(exact_array(state.points), 2, axis=0)), default=0)
    share = Fraction(n, 8 * pieces**2)
    rows = (
        ("pieces", f"2{power(state.depth)} = {pieces}"),
        ("control points, joints once", number(pieces * n + 1)),
        ("D, the longest second difference", root_of(bend2)),
        (f"polygon to curve at most {n} D / (8 × 4{power(state.depth)})", root_of(share * share * bend2)),
    )
    return [Block(f"All pieces halved {times(state.depth)} (分割极限定理)", rows)]


SAID = {
    "hull": hull_said,
    "elevated": _elevated,
    "halving": _halving,
    "circle": circle_said,
    "point": _point,
    "tangents": _tangents,
    "line": line_said,
    "levels": _levels,
    "halves": _halves,
    "part": _part,
    "hodograph": _hodograph,
    "pieces": pieces_said,
    "frames": frames_said,
    "local": local_said,
    "natural": natural_said,
    "spline": spline_said,
    "breaks": breaks_said,
    "span": span_said,
    "deboor": deboor_said,
    "functions": functions_said,
}
