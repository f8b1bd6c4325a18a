"""What a board shows: points, parameters and layers as exact numbers, read from anywhere, refused if they are wrong."""

import re
from fractions import Fraction
from math import isfinite
from typing import NamedTuple

from . import knots as knot_line

LAYERS = {  # from the bottom of the picture to its top
    "hull": "convex hull and its box",
    "polygon": "control polygon",
    "curve": "curve",
    "elevated": "elevated polygons",
    "halving": "polygons after halving",
    "circle": "circle of curvature at an end",
    "point": "the point at t",
    "tangents": "tangents at 0, t and 1",
    "line": "a line and its crossings",
    "levels": "de Casteljau's levels at t",
    "halves": "both halves, cut at t",
    "part": "the part over [a, b]",
    "hodograph": "hodograph",
    "pieces": "cubics with common ends, over t and 1 - t in turn",
    "frames": "A-frames of these cubics",
    "local": "points as data: spline by the one-sixth rule",
    "natural": "points as data: natural spline",
}
OF_KNOTS = {  # likewise, of a B-spline curve
    "hull": LAYERS["hull"],
    "polygon": LAYERS["polygon"],
    "span": "what the span of t depends on, and its hull",
    "spline": "curve, span by span",
    "breaks": "joins of the spans, at the knots",
    "deboor": "de Boor's levels at t",
    "functions": "basis functions",
}
FEWEST, MOST = 2, 20
DEEPEST, HIGHEST = 6, 12  # halvings and elevations: more cannot be told apart on a screen
LARGEST = 10**9  # of a coordinate: the pictures are computed in floats
_NUMBER = re.compile(r"[+-]?[0-9]{1,300}(/[0-9]{1,300}|\.[0-9]{1,300})?")
FINEST = 1000  # the largest denominator that a float may stand for


class State(NamedTuple):
    """One moment of a board; every number is a Fraction or an int, a point a pair of them.

    ``level`` is the last level shown of de Casteljau's, None for all; ``end`` 0 or 1 bears the circle; ``line`` is two
    points; ``depth`` counts halvings and ``raised`` elevations. Without ``knots`` the curve is a Bézier curve and t in
    [0, 1]; with them it is a B-spline curve and t in their domain.
    """

    points: tuple
    t: Fraction = Fraction(1, 3)
    a: Fraction = Fraction(1, 4)
    b: Fraction = Fraction(3, 4)
    line: tuple = ((0, 0), (1, 1))
    level: int | None = None
    end: int = 0
    depth: int = 1
    raised: int = 1
    show: tuple = ("polygon", "curve")
    knots: tuple | None = None


def exact(value, name):
    """A number as a Fraction. A float must be within 1e-12 of a fraction with a denominator of at most 1000.

    >>> exact(1 / 3, "t"), exact("5/3", "t")
    (Fraction(1, 3), Fraction(5, 3))

    ``ValueError`` names what is no number, not finite, or a float that is no such fraction.
    """
    if isinstance(value, float) or type(value).__module__ == "numpy":
        value = float(value)
        if not isfinite(value):
            raise ValueError(f"{name} is {value}")
        near = Fraction(value).limit_denominator(FINEST)
        if abs(near - Fraction(value)) > 1e-12 * max(1, abs(near)):
            raise ValueError(
                f"{name} is {value}, which is no fraction with a denominator up to {FINEST}: write it exactly"
            )
        return near
    if isinstance(value, bool) or value is None:
        raise ValueError(f"{name} is {value}, not a number")
    if isinstance(value, str) and not _NUMBER.fullmatch(value):
        raise ValueError(f"{name} is {value[:30]!r}, not a number like 2, -5/3 or 0.25")
    try:
        return Fraction(value)
    except ZeroDivisionError:
        raise ValueError(f"{name} is {value!r}, a division by 0") from None
    except (TypeError, ValueError):
        pass
    try:
        return Fraction(int(value.p), int(value.q))  # SymPy's rational numbers
    except (AttributeError, TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, not a number") from None


def points_of(given, name="b"):
    """Control points in the plane as a tuple of pairs.

    ``ValueError`` names a point that has not two coordinates or no number as one, and a count outside 2..20.
    """
    rows = [_pair(row, f"control point {name}_{i}") for i, row in enumerate(_listed(given, "the control points"))]
    if not FEWEST <= len(rows) <= MOST:
        raise ValueError(f"a board shows {FEWEST} to {MOST} control points, and here are {len(rows)}")
    return tuple(rows)


def parameter_of(given, name, domain=(0, 1)):
    """A parameter in the domain as a Fraction; ``ValueError`` names one outside."""
    value, (first, last) = exact(given, name), domain
    if not first <= value <= last:
        raise ValueError(f"{name} = {value} lies outside [{first}, {last}]")
    return value


def knots_of(given, count):
    """Knots for so many control points as a tuple of Fractions; ``ValueError`` names the rule and the offender."""
    row = _listed(given, "the knots")
    return knot_line.checked(tuple(_coordinate(value, f"knot t_{i}") for i, value in enumerate(row)), count)


def line_of(given):
    """Two points of a line; ``ValueError`` if they are one."""
    rows = [_pair(row, f"point {i} of the line") for i, row in enumerate(_listed(given, "the line's points"))]
    if len(rows) != 2 or rows[0] == rows[1]:
        raise ValueError("a line goes through two different points")
    return tuple(rows)


def count_of(given, name, most, least=0):
    """A whole number from ``least`` to ``most``; ``ValueError`` names another."""
    if isinstance(given, bool) or not isinstance(given, int) or not least <= given <= most:
        raise ValueError(f"{name} is {given!r}, not a whole number from {least} to {most}")
    return given


def layers_of(given, knots=None):
    """Names of layers as a tuple in the order in which they are painted; ``ValueError`` names an unknown one."""
    there = LAYERS if knots is None else OF_KNOTS
    names = (given,) if isinstance(given, str) else tuple(given)
    for name in names:
        if name not in there:
            kind = "a Bézier curve" if knots is None else "a B-spline"
            raise ValueError(f"there is no layer {name!r} of {kind}: there are {', '.join(there)}")
    return tuple(name for name in there if name in names)


def _listed(given, what):
    try:
        return list(given)
    except TypeError:
        raise ValueError(f"{what} are {given!r}, not a list") from None


def _pair(row, name):
    numbers = list(row) if hasattr(row, "__len__") and not isinstance(row, str) else [row]
    if len(numbers) != 2:
        raise ValueError(f"{name} has {len(numbers)} coordinates, and the board is a plane")
    return tuple(_coordinate(value, f"a coordinate of {name}") for value in numbers)


def _coordinate(given, name):
    value = exact(given, name)
    if abs(value) > LARGEST:
        raise ValueError(f"{name} is larger than {LARGEST}: too far away for a picture")
    return value


def to_json(state):
    """A state as the browser has it: fractions as text.

    >>> to_json(State(((0, 0), (Fraction(1, 3), 1))))["points"]
    [['0', '0'], ['1/3', '1']]
    """

    def written(value):
        if isinstance(value, tuple):
            return list(map(written, value))
        return str(value) if isinstance(value, Fraction) else value

    texts = {name: written(value) for name, value in state._asdict().items()}
    texts |= {name: [list(map(str, row)) for row in getattr(state, name)] for name in ("points", "line")}
    return texts if state.knots is None else texts | {"knots": list(map(str, state.knots))}


def from_json(given):
    """The state that the browser sends; ``ValueError`` names what is wrong with it."""
    if not isinstance(given, dict) or set(given) != set(State._fields):
        raise ValueError(f"a state has the fields {', '.join(State._fields)}")
    return state_of(**given)


def state_of(points, *, t=None, show=None, line=None, level=None, knots=None, **settings):
    """A state of what a user gives; ``ValueError`` names the rule and the offender.

    Polygon and curve are shown if nothing else is said. Without a ``t``, it is 1/3, and in the middle of a domain of
    knots. Without a ``line``, it is horizontal, at half the height of the points.
    """
    points = points_of(points)
    knots = None if knots is None else knots_of(knots, len(points))
    domain = knot_line.domain_of(points, knots)
    middle, drawn = (Fraction(1, 3), "curve") if knots is None else (sum(domain) / 2, "spline")
    return State(
        points,
        parameter_of(middle if t is None else t, "t", domain),
        **{name: _READERS[name](given, name) for name, given in settings.items()},
        line=line_of(_across(points) if line is None else line),
        level=None if level in (None, len(points) - 1) else count_of(level, "level", len(points) - 1),
        show=layers_of(("polygon", drawn) if show is None else show, knots),
        knots=knots,
    )


def _across(points):
    """Two points at half the height of all, to the left and to the right of them."""
    (x0, x1), (y0, y1) = ((min(axis), max(axis)) for axis in zip(*points, strict=True))
    half = (y0 + y1) / 2
    aside = x0 - 1 if x0 > 0 else x0 + 1  # not farther away than a coordinate may be
    return ((x0, half), (x1 if x1 > x0 else aside, half))


_READERS = {
    "a": parameter_of,
    "b": parameter_of,
    "end": lambda given, name: count_of(given, name, 1),
    "depth": lambda given, name: count_of(given, name, DEEPEST),
    "raised": lambda given, name: count_of(given, name, HIGHEST),
}
