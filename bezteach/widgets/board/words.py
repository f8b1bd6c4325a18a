"""What a board says beside its picture, in exact numbers: for each layer shown some titled rows."""

from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache
from html import escape
from math import isqrt
from typing import NamedTuple

import numpy as np

from ... import numeric
from ...display import number, point
from .counting import roots_inside, sign_changes
from .crossings import heights
from .scene import hull

WIDTH = 6  # cells in a row of a list


class Block(NamedTuple):
    """Rows of cells under a title, all of them text."""

    title: str
    rows: tuple


def blocks(state):
    """The blocks of the layers shown, in their order; the control points come first.

    >>> from .state import state_of
    >>> for block in blocks(state_of([(0, 0), (1, 2), (2, 0)], show=["curve", "elevated"])):
    ...     print(block.title, *block.rows)
    Control points ('(0, 0)', '(1, 2)', '(2, 0)')
    Control points in degree 3 (升阶) ('(0, 0)', '(2/3, 4/3)', '(4/3, 4/3)', '(2, 0)')
    """
    said = [Block("Control points", _points(state.points))]
    for name in state.show:
        said += SAID[name](state) if name in SAID else []
    return said


def html(said):
    """Blocks as HTML.

    >>> html([Block("Box", (("x < 1", "y"),))])
    '<b>Box</b><table><tr><td>x &lt; 1</td><td>y</td></tr></table>'
    """
    return "".join(f"<b>{escape(title)}</b><table>{''.join(map(_row, rows))}</table>" for title, rows in said)


def _row(cells):
    return f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>"


def text(said):
    """Blocks in one line of words.

    >>> text([Block("Box", (("x", "[0, 1]"), ("y", "[2, 3]")))])
    'Box: x [0, 1], y [2, 3]'
    """
    return "; ".join(f"{title}: {', '.join(' '.join(row) for row in rows)}" for title, rows in said)


def _cells(cells):
    """A list as rows that are not too long."""
    return tuple(tuple(cells[i : i + WIDTH]) for i in range(0, len(cells), WIDTH))


def _points(points):
    return _cells([point(p) for p in points])


def _exact(points):
    """Points as an array of exact numbers."""
    return np.array(points, dtype=object)


def _name(i, level=0):
    return f"b_{i}^{level}" if level else f"b_{i}"


def _root(square, sign=""):
    """The root of an exact number: exact if it is rational, else three digits, marked as such."""
    square = Fraction(square)
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if root * root == square:
        return number(-root if sign else root)
    exact = Context(prec=30)  # decimals, because a float ends at 1e308
    three = Context(prec=3).plus(exact.sqrt(exact.divide(Decimal(square.numerator), Decimal(square.denominator))))
    return f"about {sign}{three:{'f' if -5 <= three.adjusted() < 7 else 'e'}}"


def _times(count):
    return "once" if count == 1 else f"{count} times"


@lru_cache(maxsize=2)
def _triangle(points, t):
    """De Casteljau's levels, which three layers look at."""
    return numeric.de_casteljau(points, t)


def _cut(levels):
    """Control points of both halves: the first points of the levels, and the last ones from the last level back."""
    return _exact([level[0] for level in levels]), _exact([level[-1] for level in levels[::-1]])


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
        Block(f"Left half (前半段) {_over(0, state.t)}, circles", _points(left)),
        Block(f"Right half (后半段) {_over(state.t, 1)}, squares", _points(right)),
        Block("Cut point", ((f"p({number(state.t)})", point(right[0])),)),
    ]


def _over(start, end):
    interval = f"over [{number(start)}, {number(end)}]"
    return interval + ", one point" if start == end else interval


def _part(state):
    a, b = state.a, state.b
    where = f"from {number(a)} back to {number(b)}, run backwards" if a > b else _over(a, b)
    return [Block(f"Part (子曲线段) {where}", _points(_between(state.points, a, b))), *_local(a, b)]


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
        (f"edge {_name(0, n - 1)} {_name(1, n - 1)}", point(edge)),
        (f"p'({t}) = {n} times the edge", point(n * edge)),
    ]
    if not edge.any():
        rows.append((f"p'({t}) = 0", "the edge is one point and gives no tangent"))
    return [Block(f"Tangent (切线) at t = {t}", tuple(rows)), *(_ratios(levels, state.t) if n == 2 else [])]


def _ratios(levels, t):
    """How the middle tangent of a parabola divides the other two, and its point of contact the middle one."""
    (b0, b1, b2), (left, right), _ = levels
    ratio = f"{t.numerator} : {t.denominator - t.numerator}"
    divided = (("b_0^1", "b_0 b_1", b1 - b0), ("b_1^1", "b_1 b_2", b2 - b1), ("p(t)", "b_0^1 b_1^1", right - left))
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
        Block(f"Control points of the hodograph (速端曲线), degree {len(first) - 1}", _points(first)),
        Block("Derivatives", tuple((name, point(vector)) for name, vector in derivatives.items())),
    ]


def _hull(state):
    corners = hull(state.points)
    names = {}
    for i, place in enumerate(state.points):
        names.setdefault(place, []).append(_name(i))
    rest = [place for place in names if place not in corners]
    boundary = {place for place in rest if _on_boundary(place, corners)}
    kind = {1: "a point", 2: "a segment with 2 ends"}.get(len(corners), f"{len(corners)} corners counter-clockwise")
    lists = {
        f"Convex hull (凸包), {kind}": corners,
        "On its boundary, no corners": [place for place in rest if place in boundary],
        "Inside": [place for place in rest if place not in boundary],
    }
    said = [Block(title, _cells([" = ".join(names[p]) for p in places])) for title, places in lists.items() if places]
    sides = (f"[{number(min(side))}, {number(max(side))}]" for side in zip(*state.points, strict=True))
    return [*said, Block("Its box", ((" × ".join(sides),),))]


def _on_boundary(place, corners):
    edges = zip(corners, corners[1:] + corners[:1], strict=True)
    return any(heights(_exact([place]), _exact(edge))[0] == 0 for edge in edges)


def _circle(state):
    n, end = len(state.points) - 1, state.end
    near, first = (state.points[-3:], max(n - 2, 0)) if end else (state.points[:3], 0)
    names = [_name(first + k) for k in range(len(near))]
    return [Block(f"Curvature (曲率) at t = {end}", _curvature(_exact(near), names, n, end))]


def _curvature(near, names, n, end):
    """Rows on the curvature at an end from the three points next to it: (n-1)/n area / L^3, positive to the left.

    L is the end edge's length, so the radius n L^3 / ((n-1) area) along the normal is a rational multiple of the edge.
    """
    own = slice(-2, None) if end else slice(0, 2)
    edge = near[own][1] - near[own][0]
    length2, area = edge @ edge, heights(near, near)[-1]
    if length2 == 0:
        return ((f"{' = '.join(names[own])}, so p'({end}) = 0: the end edge gives no curvature",),)
    if area == 0:
        why = "degree 1" if n == 1 else f"{', '.join(names)} lie on one line"
        return (("curvature", "0"), (f"{why}: the circle is a straight line",))
    away = Fraction(n, n - 1) * length2 / area
    radius2 = away * away * length2
    return (
        (f"length L of the edge {' '.join(names[own])}", _root(length2)),
        (f"area of the parallelogram {' '.join(names[:2])}, {' '.join(names[1:])}", number(area)),
        (f"curvature {number(Fraction(n - 1, n))} area / L^3", _root(1 / radius2, "-" if area < 0 else "")),
        ("its square", number(1 / radius2)),
        ("the curve turns", "left" if area > 0 else "right"),
        ("radius", _root(radius2)),
        ("its square", number(radius2)),
        ("centre", point(near[-end] + away * np.array([-edge[1], edge[0]]))),
    )


def _line(state):
    found = heights(_exact(state.points), _exact(state.line)).tolist()
    return [
        Block("Heights over the line, times the distance of its two points", _cells([number(h) for h in found])),
        Block("How often the line passes (变差缩减)", _passages(found)),
    ]


def _passages(found):
    inside = roots_inside(found)
    if inside is None:
        return (("polygon and curve lie on the line",),)
    passages, touches = inside
    ends = ((found[0], _name(0), "begin"), (found[-1], _name(len(found) - 1), "end"))
    rows = [
        ("through the polygon", _times(sign_changes(found))),
        ("through the curve", f"{_times(passages)}: never more than through the polygon"),
    ]
    rows += [("touches the curve", _times(touches))] if touches else []
    rows += [
        (f"{name} is on the line", f"polygon and curve {verb} there, not counted") for h, name, verb in ends if not h
    ]
    return tuple(rows)


def _elevated(state):
    raised = numeric.elevate(state.points, state.raised)
    return [Block(f"Control points in degree {len(raised) - 1} (升阶)", _points(raised))]


def _halving(state):
    """Polygon and curve are nowhere further apart than n D / (8 4^depth): the ledger's limit/halving."""
    n, pieces = len(state.points) - 1, 2**state.depth
    bend2 = max((bend @ bend for bend in np.diff(_exact(state.points), 2, axis=0)), default=0)
    share = Fraction(n, 8 * pieces**2)
    rows = (
        ("pieces", f"2^{state.depth} = {pieces}"),
        ("control points, joints once", number(pieces * n + 1)),
        ("D, the longest second difference", _root(bend2)),
        (f"polygon to curve at most {n} D / (8 × 4^{state.depth})", _root(share * share * bend2)),
    )
    return [Block(f"All pieces halved {_times(state.depth)} (分割极限定理)", rows)]


SAID = {
    "hull": _hull,
    "elevated": _elevated,
    "halving": _halving,
    "circle": _circle,
    "point": _point,
    "tangents": _tangents,
    "line": _line,
    "levels": _levels,
    "halves": _halves,
    "part": _part,
    "hodograph": _hodograph,
}
