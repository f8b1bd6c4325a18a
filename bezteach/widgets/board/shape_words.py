"""What a board says of its shape: hull, curvature at an end, a line through polygon and curve."""

from fractions import Fraction

import numpy as np

from ... import numeric
from ...display import number, point
from ...numeric import sign_changes
from ...numeric.hull import hull
from .blocks import Block, cells, exact_array, name_of, root_of, times
from .counting import roots_inside
from .crossings import heights


def hull_said(state):
    corners = hull(state.points)
    names = {}
    for i, place in enumerate(state.points):
        names.setdefault(place, []).append(name_of(i))
    rest = [place for place in names if place not in corners]
    boundary = {place for place in rest if _on_boundary(place, corners)}
    kind = {1: "a point", 2: "a segment with 2 ends"}.get(len(corners), f"{len(corners)} corners counter-clockwise")
    lists = {
        f"Convex hull (凸包), {kind}": corners,
        "On its boundary, no corners": [place for place in rest if place in boundary],
        "Inside": [place for place in rest if place not in boundary],
    }
    said = [Block(title, cells([" = ".join(names[p]) for p in places])) for title, places in lists.items() if places]
    sides = (f"[{number(min(side))}, {number(max(side))}]" for side in zip(*state.points, strict=True))
    return [*said, Block("Its box", ((" × ".join(sides),),))]


def _on_boundary(place, corners):
    edges = zip(corners, corners[1:] + corners[:1], strict=True)
    return any(heights(exact_array([place]), exact_array(edge))[0] == 0 for edge in edges)


def circle_said(state):
    n, end = len(state.points) - 1, state.end
    near, first = (state.points[-3:], max(n - 2, 0)) if end else (state.points[:3], 0)
    names = [name_of(first + k) for k in range(len(near))]
    return [Block(f"Curvature (曲率) at t = {end}", _curvature(exact_array(near), names, n, end))]


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
        (f"length L of the edge {' '.join(names[own])}", root_of(length2)),
        (f"area of the parallelogram {' '.join(names[:2])}, {' '.join(names[1:])}", number(area)),
        (f"curvature {number(Fraction(n - 1, n))} area / L³", root_of(1 / radius2, "-" if area < 0 else "")),
        ("its square", number(1 / radius2)),
        ("the curve turns", "left" if area > 0 else "right"),
        ("radius", root_of(radius2)),
        ("its square", number(radius2)),
        ("centre", point(near[-end] + away * np.array([-edge[1], edge[0]]))),
    )


def line_said(state):
    found = heights(exact_array(state.points), exact_array(state.line)).tolist()
    raised = numeric.elevate(found, state.raised).tolist() if "elevated" in state.show else None
    return [
        Block("Heights over the line, times the distance of its two points", cells([number(h) for h in found])),
        Block("The line passes, the curve never more often (变差缩减)", _passages(found, raised)),
    ]


def _passages(found, raised):
    inside = roots_inside(found)
    if inside is None:
        return (("polygon and curve lie on the line",),)
    passages, touches = inside
    ends = ((found[0], name_of(0), "begin"), (found[-1], name_of(len(found) - 1), "end"))
    rows = [("through the polygon", times(sign_changes(found)))]
    rows += [(f"through the polygon in degree {len(raised) - 1}", times(sign_changes(raised)))] if raised else []
    rows += [("through the curve", times(passages))]
    rows += [("touches the curve", times(touches))] if touches else []
    rows += [
        (f"{name} is on the line", f"polygon and curve {verb} there, not counted") for h, name, verb in ends if not h
    ]
    return tuple(rows)
