"""What a board says: exact numbers of every layer, against the slides, and against SymPy from scratch."""

import re
from fractions import Fraction as F
from itertools import pairwise, product
from math import comb, dist, sqrt

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.numeric import sign_changes
from bezteach.widgets.board.blocks import Block, cells, html, name_of, text
from bezteach.widgets.board.counting import roots_inside
from bezteach.widgets.board.state import LAYERS, State, state_of
from bezteach.widgets.board.words import blocks

SPLIT, SEGMENT = EXAMPLES["deck/split"], EXAMPLES["deck/segment"]
CUBIC, ARCH = SPLIT.given["points"], SEGMENT.given["points"]
PARABOLA = ((0, 0), (1, 2), (2, 0))
QUINTIC = ((0, 0), (F(1, 3), 2), (-1, 3), (4, F(-5, 2)), (2, 2), (5, 1))
QUIET = {"polygon", "curve"}  # layers that need no words of their own
T = sympy.Symbol("T")


def said(points, layer, **settings):
    """The layer's blocks as {title: rows}, without the control points."""
    return dict(blocks(state_of(points, show=[layer], **settings))[1:])


def titled(found, start):
    """The rows of the only block whose title begins so."""
    [rows] = [rows for title, rows in found.items() if title.startswith(start)]
    return rows


def value(rows, start):
    """The second cell of the only row whose first one begins so."""
    [cell] = [row[1] for row in rows if row[0].startswith(start)]
    return cell


def read(cell):
    """The numbers of a point."""
    return tuple(map(F, cell.strip("()").split(", ")))


def listed(rows):
    """Points over all rows."""
    return [read(cell) for row in rows for cell in row]


def along(values):
    """The polynomial in T with these coefficients in the Bernstein basis, written out."""
    n = len(values) - 1
    terms = (sympy.Rational(str(v)) * comb(n, i) * T**i * (1 - T) ** (n - i) for i, v in enumerate(values))
    return sympy.expand(sum(terms))


def curve(points):
    return sympy.Matrix([along(column) for column in zip(*points, strict=True)])


def same(point_read, vector):
    return all(sympy.Rational(str(x)) == y for x, y in zip(point_read, vector, strict=True))


# ---- The triangle, halves and parts ----


def test_only_the_control_points_stand_beside_polygon_and_curve():
    assert blocks(state_of(CUBIC)) == [Block("Control points", (("(0, 0)", "(1, 3)", "(2, 1)", "(3, 3)"),))]


def test_the_point_of_the_slide():
    assert said(CUBIC, "point") == {"The point at t = 1/3": (("(1, 5/3)",),)}


def test_the_triangle_of_the_slide():
    rows = said(CUBIC, "levels")["De Casteljau's triangle at t = 1/3"]
    columns = SPLIT.answer["triangle"]
    assert rows == tuple(tuple(point(columns[k][row - k]) for k in range(row + 1)) for row in range(4))
    assert said(CUBIC, "levels", level=1)["De Casteljau's triangle at t = 1/3"] == tuple(row[:2] for row in rows)


def test_the_halves_of_the_slide():
    assert said(CUBIC, "halves") == {
        "Left half (前半段) over [0, 1/3], circles": (("(0, 0)", "(1/3, 1)", "(2/3, 13/9)", "(1, 5/3)"),),
        "Right half (后半段) over [1/3, 1], squares": (("(1, 5/3)", "(5/3, 19/9)", "(7/3, 5/3)", "(3, 3)"),),
        "Cut point": (("p(1/3)", "(1, 5/3)"),),
    }


def test_a_cut_at_an_end_leaves_one_point():
    found = said(CUBIC, "halves", t=0)
    assert found["Left half (前半段) over [0, 0], one point, circles"] == (("(0, 0)",) * 4,)
    assert listed(titled(found, "Right half")) == list(CUBIC)
    found = said(CUBIC, "halves", t=1)
    assert found["Right half (后半段) over [1, 1], one point, squares"] == (("(3, 3)",) * 4,)
    assert listed(titled(found, "Left half")) == list(CUBIC)


def test_the_part_of_the_slide_with_both_local_parameters():
    assert said(ARCH, "part", a=SEGMENT.given["start"], b=SEGMENT.given["end"]) == {
        "Part (子曲线段) over [1/4, 3/4]": (("(-9/2, 27/8)", "(-3/2, 39/8)", "(3/2, 39/8)", "(9/2, 27/8)"),),
        "Local parameter (局部参数) of the second cut": (
            ("cut at b, keep the left: then at", "a/b = 1/3"),
            ("cut at a, keep the right: then at", "(b - a)/(1 - a) = 2/3"),
        ),
    }


def test_local_parameters_that_are_not_each_other_s_complement():
    rows = titled(said(ARCH, "part", a=F(1, 5), b=F(1, 2)), "Local")
    assert [cell.split(" = ")[1] for _, cell in rows] == ["2/5", "3/8"]


@pytest.mark.parametrize(("a", "b"), list(product([F(0), F(1, 4), F(2, 3), F(1)], repeat=2)))
@pytest.mark.parametrize("points", [CUBIC, QUINTIC, ((0, 0), (1, 2))])
def test_every_part_is_the_curve_over_its_interval(points, a, b):
    found = said(points, "part", a=a, b=b)
    part = curve(listed(titled(found, "Part")))
    whole = curve(points).subs(T, sympy.Rational(str(a)) + sympy.Rational(str(b - a)) * T)
    assert sympy.expand(part - whole).is_zero_matrix
    title = next(iter(found))
    assert ("run backwards" in title) == (a > b) and ("one point" in title) == (a == b)
    assert ("Local parameter (局部参数) of the second cut" in found) == (0 < a < b < 1)


def test_a_part_that_runs_backwards_says_from_where_to_where():
    found = said(ARCH, "part", a=F(3, 4), b=F(1, 4))
    assert found["Part (子曲线段) from 3/4 back to 1/4, run backwards"][0][0] == "(9/2, 27/8)"


# ---- Tangents and derivatives ----


def test_the_tangent_of_the_slide_s_cubic():
    assert said(CUBIC, "tangents") == {
        "Tangent (切线) at t = 1/3": (
            ("p(1/3)", "(1, 5/3)"),
            ("edge b₀² b₁²", "(1, 2/3)"),
            ("p'(1/3) = 3 times the edge", "(3, 2)"),
        )
    }


@pytest.mark.parametrize("t", [F(0), F(2, 7), F(1)])
@pytest.mark.parametrize("points", [QUINTIC, PARABOLA, ((1, 1), (-2, 3))])
def test_point_and_derivatives_are_those_of_the_polynomial(points, t):
    p, at = curve(points), sympy.Rational(str(t))
    first, second = p.diff(T), p.diff(T, 2)
    rows = titled(said(points, "tangents", t=t), "Tangent")
    assert same(read(value(rows, f"p({t})")), p.subs(T, at))
    assert same(read(value(rows, f"p'({t}) =")), first.subs(T, at))
    found = said(points, "hodograph", t=t)
    hodograph = titled(found, "Control points of the hodograph (速端曲线), degree ")
    assert sympy.expand(curve(listed(hodograph)) - first).is_zero_matrix
    rows = dict(found["Derivatives"])
    assert set(rows) == {"p'(0)", "p'(1)", "p''(0)", "p''(1)", f"p'({t})"}
    for name, derivative, place in [("p'(0)", first, 0), (f"p'({t})", first, at), ("p'(1)", first, 1)]:
        assert same(read(rows[name]), derivative.subs(T, place))
    assert same(read(rows["p''(0)"]), second.subs(T, 0)) and same(read(rows["p''(1)"]), second.subs(T, 1))


def test_the_hodograph_of_the_slide_s_cubic():
    assert said(CUBIC, "hodograph") == {
        "Control points of the hodograph (速端曲线), degree 2": (("(3, 9)", "(3, -6)", "(3, 6)"),),
        "Derivatives": (
            ("p'(0)", "(3, 9)"),
            ("p'(1/3)", "(3, 2)"),
            ("p'(1)", "(3, 6)"),
            ("p''(0)", "(0, -30)"),
            ("p''(1)", "(0, 24)"),
        ),
    }


def test_three_tangents_of_a_parabola_in_one_ratio():
    rows = said(PARABOLA, "tangents", t=F(1, 4))["Three tangents (三切线定理) in the ratio t : (1 - t)"]
    assert rows == tuple(
        (f"{by} divides {leg}", "1 : 3") for by, leg in [("b₀¹", "b₀ b₁"), ("b₁¹", "b₁ b₂"), ("p(t)", "b₀¹ b₁¹")]
    )


def test_the_ratio_is_that_of_the_tangents_crossings():
    """The tangent, drawn from p(t) and p'(t), meets the legs in points whose distances have the ratio said."""
    points, t = ((0, 0), (1, 2), (4, -1)), sympy.Rational(2, 5)
    p, velocity = (vector.subs(T, t) for vector in (curve(points), curve(points).diff(T)))
    tangent = sympy.Line(sympy.Point(*p), sympy.Point(*(p + velocity)))
    corners = [sympy.Point(*b) for b in points]
    cuts = [sympy.Line(*leg).intersection(tangent)[0] for leg in pairwise(corners)]
    pieces = [(corners[0], cuts[0], corners[1]), (corners[1], cuts[1], corners[2]), (cuts[0], sympy.Point(*p), cuts[1])]
    ratios = {start.distance(by) / by.distance(end) for start, by, end in pieces}
    assert ratios == {sympy.Rational(2, 3)}
    assert {cell for _, cell in titled(said(points, "tangents", t=F(2, 5)), "Three")} == {"2 : 3"}


def test_a_point_at_rest_has_no_tangent_and_a_leg_of_one_point_no_ratio():
    cusp = said(((0, 0), (1, 1), (0, 1), (1, 0)), "tangents", t=F(1, 2))
    assert titled(cusp, "Tangent")[-1] == ("p'(1/2) = 0", "the edge is one point and gives no tangent")
    assert "= 0" not in str(said(CUBIC, "tangents"))
    rows = titled(said(((0, 0), (0, 0), (2, 1)), "tangents", t=F(1, 2)), "Three")
    assert [cell for _, cell in rows] == ["no ratio: the leg is one point", "1 : 1", "1 : 1"]


# ---- The hull ----


def test_the_hull_of_the_slide_s_cubic_has_all_four_corners():
    assert said(CUBIC, "hull") == {
        "Convex hull (凸包), 4 corners counter-clockwise": (("b₀", "b₂", "b₃", "b₁"),),
        "Its box": (("[0, 3] × [0, 3]",),),
    }


def test_corners_boundary_and_inside_are_told_apart_exactly():
    points = ((0, 0), (3, 0), (1, 1), (1, 0), (0, 3), (F(1, 3), F(8, 3)), (0, 0), (1, 1))
    found = said(points, "hull")
    assert found == {
        "Convex hull (凸包), 3 corners counter-clockwise": (("b₀ = b₆", "b₁", "b₄"),),
        "On its boundary, no corners": (("b₃", "b₅"),),
        "Inside": (("b₂ = b₇",),),
        "Its box": (("[0, 3] × [0, 3]",),),
    }
    nearly = (*points[:5], (F(1, 3), F(8, 3) - F(1, 10**20)), *points[6:])
    assert "b₅" in str(said(nearly, "hull")["Inside"])  # floats cannot tell these


def test_a_hull_of_one_point_and_of_a_segment():
    assert said(((1, 2), (1, 2)), "hull")["Convex hull (凸包), a point"] == (("b₀ = b₁",),)
    found = said(((1, 1), (0, 0), (3, 3), (1, 1)), "hull")
    assert found["Convex hull (凸包), a segment with 2 ends"] == (("b₁", "b₂"),)
    assert found["On its boundary, no corners"] == (("b₀ = b₃",),)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=9))
def test_the_corners_are_those_of_sympy(points):
    outer = sympy.convex_hull(*(sympy.Point(*p) for p in points))
    if not isinstance(outer, sympy.Polygon):
        return
    found = said(points, "hull")
    places = {name_of(i): sympy.Point(*p) for i, p in enumerate(points)}
    corners, inside = (re.findall("b[₀-₉]", str(rows)) for rows in (titled(found, "Convex"), found.get("Inside")))
    assert {places[name] for name in corners} == set(outer.vertices)
    assert set(inside) == {name for name, place in places.items() if outer.encloses_point(place)}


# ---- Curvature ----


def test_the_curvature_at_the_start_of_the_slide_s_cubic():
    assert said(CUBIC, "circle")["Curvature (曲率) at t = 0"] == (
        ("length L of the edge b₀ b₁", "about 3.16"),
        ("area of the parallelogram b₀ b₁, b₁ b₂", "-5"),
        ("curvature 2/3 area / L³", "about -0.105"),
        ("its square", "1/90"),
        ("the curve turns", "right"),
        ("radius", "about 9.49"),
        ("its square", "90"),
        ("centre", "(9, -3)"),
    )


def test_the_curvature_at_the_end_has_its_own_names_and_sign():
    rows = said(CUBIC, "circle", end=1)["Curvature (曲率) at t = 1"]
    assert rows[0] == ("length L of the edge b₂ b₃", "about 2.24")
    assert rows[1] == ("area of the parallelogram b₁ b₂, b₂ b₃", "4")
    assert value(rows, "curvature") == "about 0.239" and value(rows, "the curve turns") == "left"


def test_a_rational_curvature_is_not_about():
    rows = titled(said(((3, 4), (0, 0), (0, 5)), "circle"), "Curvature")
    assert value(rows, "length") == "5" and value(rows, "radius") == "50/3"
    assert value(rows, "curvature 1/2 area / L³") == "-3/50"


@pytest.mark.parametrize("end", [0, 1])
@pytest.mark.parametrize("points", [CUBIC, ARCH, PARABOLA, QUINTIC, tuple((-x, y) for x, y in QUINTIC)])
def test_curvature_and_circle_are_those_of_the_polynomial(points, end):
    rows = titled(said(points, "circle", end=end), "Curvature")
    p = curve(points)
    (x1, y1), (x2, y2) = (p.diff(T, r).subs(T, end) for r in (1, 2))
    kappa2 = (x1 * y2 - y1 * x2) ** 2 / (x1**2 + y1**2) ** 3
    squares = [sympy.Rational(row[1]) for row in rows if row[0] == "its square"]
    assert squares == [kappa2, 1 / kappa2]
    kappa = float(value(rows, "curvature").removeprefix("about "))
    assert kappa == pytest.approx(float(numeric.curvature(points, end)), rel=5e-3)
    assert value(rows, "the curve turns") == ("left" if kappa > 0 else "right")
    where = p.subs(T, end)
    to_centre = sympy.Matrix([sympy.Rational(str(c)) for c in read(value(rows, "centre"))]) - where
    assert to_centre.dot(to_centre) == 1 / kappa2 and to_centre.dot(sympy.Matrix([x1, y1])) == 0
    assert (to_centre[1] * x1 - to_centre[0] * y1 > 0) == (kappa > 0)


@pytest.mark.parametrize(
    ("points", "end", "words"),
    [
        (((0, 0), (1, 2)), 0, "degree 1: the circle is a straight line"),
        (((0, 0), (1, 2)), 1, "degree 1: the circle is a straight line"),
        (((0, 0), (0, 0)), 0, "b₀ = b₁, so p'(0) = 0: the end edge gives no curvature"),
        (((0, 0), (1, 1), (2, 2), (0, 5)), 0, "b₀, b₁, b₂ lie on one line: the circle is a straight line"),
        (((5, 0), (1, 1), (2, 2), (3, 3)), 1, "b₁, b₂, b₃ lie on one line: the circle is a straight line"),
        (((5, 0), (1, 1), (3, 3), (3, 3)), 1, "b₂ = b₃, so p'(1) = 0: the end edge gives no curvature"),
    ],
)
def test_an_end_without_a_circle_says_why(points, end, words):
    rows = titled(said(points, "circle", end=end), "Curvature")
    assert rows[-1] == (words,)
    assert (("curvature", "0") in rows) == ("straight" in words)


def test_large_and_small_sizes_are_said():
    rows = titled(said(((0, 0), (10**9, 0), (10**9, F(1, 10**9))), "circle"), "Curvature")
    assert value(rows, "curvature") == value(rows, "curvature 1/2 area / L³") == f"1/{2 * 10**27}"
    rows = titled(said(((0, 0), (10**9, 1), (10**9, 2)), "circle"), "Curvature")
    assert value(rows, "length") == "about 1.00e+9" and value(rows, "curvature") == "about 5.00e-19"


# ---- A line ----

AXIS = ((0, 0), (1, 0))


def graph(*values):
    """A curve whose heights over the axis are these."""
    return tuple(enumerate(values))


def bernstein(polynomial):
    """The coefficients in the Bernstein basis of a polynomial in T."""
    powers = sympy.Poly(polynomial, T).all_coeffs()[::-1]
    return numeric.from_power([F(int(c.p), int(c.q)) for c in powers]).tolist()


@pytest.mark.parametrize(
    ("values", "polygon", "through", "touches"),
    [
        ((-3, 3, -1, 3), "3 times", "once", None),
        ((1, -1, 1), "2 times", "0 times", "once"),
        ((1, 0, 1), "0 times", "0 times", None),
        ((-1, 0, 0, 1), "once", "once", None),
        ((1, 1, 1), "0 times", "0 times", None),
        ((-2, -1), "0 times", "0 times", None),
        (bernstein((2 * T - 1) ** 3), "3 times", "once", None),
        (bernstein((2 * T - 1) ** 2 * (3 * T - 1)), "3 times", "once", "once"),
        (bernstein(T**2 * (2 * T - 1) * (1 - T)), "once", "once", None),
        (bernstein((4 * T - 1) * (2 * T - 1) * (4 * T - 3)), "3 times", "3 times", None),
        (bernstein((3 * T - 1) ** 2 * (3 * T - 2) ** 2), "4 times", "0 times", "2 times"),
        (bernstein(T * (1 - T) * (3 * T - 1) * (3 * T - 2)), "2 times", "2 times", None),
        (bernstein(T**2 * (1 - T) * (2 * T - 1) ** 2), "2 times", "0 times", "once"),
        (bernstein((T**2 + 1) * (T - 2)), "0 times", "0 times", None),
    ],
)
def test_passages_and_touches_are_counted_apart(values, polygon, through, touches):
    rows = said(graph(*values), "line", line=AXIS)["The line passes, the curve never more often (变差缩减)"]
    assert value(rows, "through the polygon") == polygon
    assert value(rows, "through the curve") == through
    assert [row[1] for row in rows if row[0] == "touches the curve"] == ([touches] if touches else [])


def test_heights_are_signed_and_exact():
    """Positive to the left of the line, twice the area of the triangle with its two points."""
    title = "Heights over the line, times the distance of its two points"
    assert said(CUBIC, "line", line=((0, 1), (F(1, 2), 1)))[title] == (("-1/2", "1", "0", "1"),)
    assert said(CUBIC, "line", line=((F(1, 2), 1), (0, 1)))[title] == (("1/2", "-1", "0", "-1"),)
    assert said(CUBIC, "line", line=((0, 0), (2, 2)))[title] == (("0", "4", "-2", "0"),)


def test_ends_on_the_line_are_said_and_not_counted():
    rows = titled(said(graph(0, 1, -1, 0), "line", line=AXIS), "The line")
    assert rows == (
        ("through the polygon", "once"),
        ("through the curve", "once"),
        ("b₀ is on the line", "polygon and curve begin there, not counted"),
        ("b₃ is on the line", "polygon and curve end there, not counted"),
    )
    rows = titled(said(graph(0, 1, -1), "line", line=AXIS), "The line")
    assert [row[0] for row in rows[2:]] == ["b₀ is on the line"]


@pytest.mark.parametrize(("raised", "elevated"), [(0, "3 times"), (2, "3 times"), (3, "once"), (12, "once")])
def test_beside_elevated_polygons_the_last_of_them_is_counted_too(raised, elevated):
    """The heights are -2, 1, -1, 1; in degree 5 -2, -1/5, 1/10, -1/5, -1/5, 1, and in degree 6 the third is 0."""
    state = state_of(CUBIC, show=["elevated", "line"], line=((0, 2), (1, 2)), raised=raised)
    assert titled(dict(blocks(state)), "The line passes") == (
        ("through the polygon", "3 times"),
        (f"through the polygon in degree {3 + raised}", elevated),
        ("through the curve", "once"),
    )


def test_a_curve_on_the_line():
    assert titled(said(graph(0, 0, 0), "line", line=AXIS), "The line") == (("polygon and curve lie on the line",),)


heights = st.lists(st.fractions(-3, 3, max_denominator=4), min_size=2, max_size=8)


@settings(max_examples=60, deadline=None)
@given(heights, heights)
def test_a_curve_is_passed_no_more_often_than_its_polygon(xs, ys):
    points = list(zip(xs, ys, strict=False))
    rows = titled(said(points, "line"), "The line")
    if rows != (("polygon and curve lie on the line",),):
        polygon, through = (count(row[1]) for row in rows[:2])
        assert through <= polygon and (polygon - through) % 2 == 0


def count(cell):
    """How many times: "once: never more" is 1, "3 times" is 3."""
    return int(cell.replace("once", "1").split(":")[0].split()[0])


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(-3, 3), min_size=1, max_size=7).filter(any))
def test_roots_are_those_that_sympy_isolates(values):
    roots = sympy.real_roots(sympy.Poly(along(values), T), multiple=False)
    inside = [power for root, power in roots if root > 0 and root < 1]
    assert roots_inside(values) == (sum(k % 2 for k in inside), sum(k % 2 == 0 for k in inside))
    assert sum(inside) <= sign_changes(values) and (sum(inside) - sign_changes(values)) % 2 == 0


# ---- Elevation and halving ----


def test_elevation_of_a_parabola():
    assert said(PARABOLA, "elevated", raised=2) == {
        "Control points in degree 4 (升阶)": (("(0, 0)", "(1/2, 1)", "(1, 4/3)", "(3/2, 1)", "(2, 0)"),)
    }
    assert said(PARABOLA, "elevated", raised=0) == {
        "Control points in degree 2 (升阶)": (("(0, 0)", "(1, 2)", "(2, 0)"),)
    }


@pytest.mark.parametrize("raised", [1, 5])
def test_elevated_points_have_the_same_curve(raised):
    points = listed(said(QUINTIC, "elevated", raised=raised)[f"Control points in degree {5 + raised} (升阶)"])
    assert len(points) == 6 + raised and sympy.expand(curve(points) - curve(QUINTIC)).is_zero_matrix


def test_halving_of_the_slide_s_cubic():
    """Its second differences are (0, -5) and (0, 4)."""
    assert said(CUBIC, "halving", depth=2) == {
        "All pieces halved 2 times (分割极限定理)": (
            ("pieces", "2² = 4"),
            ("control points, joints once", "13"),
            ("D, the longest second difference", "5"),
            ("polygon to curve at most 3 D / (8 × 4²)", "15/128"),
        )
    }


@pytest.mark.parametrize("depth", range(4))
def test_no_polygon_is_further_from_the_curve_than_is_said(depth):
    """At the same parameter; the bound of the parabola is met."""
    for points in (CUBIC, QUINTIC, PARABOLA):
        rows = titled(said(points, "halving", depth=depth), "All pieces")
        bound = value(rows, "polygon to curve at most")
        bound = float(F(bound)) if "about" not in bound else 1.01 * float(bound.removeprefix("about "))
        found = max(map(apart, numeric.subdivide(points, depth).tolist()))
        assert found <= bound * (1 + 1e-12)
        assert points is not PARABOLA or found == pytest.approx(bound)


def apart(piece):
    """The distance of a polygon from its curve at the same parameter, at some of them."""
    n, most = len(piece) - 1, 0
    for k in range(8 * n + 1):
        i = min(k // 8, n - 1)
        ahead = F(k, 8) - i
        corner = [(1 - ahead) * p + ahead * q for p, q in zip(piece[i], piece[i + 1], strict=True)]
        most = max(most, dist(map(float, corner), map(float, numeric.evaluate(piece, F(k, 8 * n)))))
    return most


def test_a_bound_that_is_no_fraction_is_about():
    rows = titled(said(((0, 0), (1, 1), (1, 0)), "halving", depth=1), "All pieces")
    assert rows[2][1] == "about 2.24" and rows[3][1] == f"about {sqrt(5) * 2 / 32:.3f}"


# ---- Lists ----


@pytest.mark.parametrize(("length", "width"), [(1, 6), (8, 6), (14, 4), (18, 3), (100, 1)])
def test_long_entries_stand_in_fewer_columns(length, width):
    rows = cells(["x" * length] * 7)
    assert [len(row) for row in rows] == [width] * (7 // width) + [7 % width] * (7 % width > 0)


# ---- All layers ----

DEGENERATE = {
    "two points": ((0, 0), (1, 2)),
    "one place twice": ((1, 2), (1, 2)),
    "one place, degree 2": ((F(1, 3), 0),) * 3,
    "one place, degree 4": ((0, 0),) * 5,
    "on a line": ((0, 0), (1, 1), (2, 2), (3, 3)),
    "there and back": ((0, 0), (1, 1), (0, 0)),
    "both end edges vanish": ((0, 0), (0, 0), (1, 2), (1, 2)),
    "closed": ((0, 0), (1, 0), (0, 1), (0, 0)),
}


@pytest.mark.parametrize("layer", LAYERS)
@pytest.mark.parametrize("name", DEGENERATE)
def test_degenerate_boards_have_words(name, layer):
    points = DEGENERATE[name]
    lines = [None, (points[0], (points[0][0], points[0][1] + 1)), ((0, 0), (1, 1))]
    for where, end, line in product((F(0), F(1, 2), F(1)), (0, 1), lines):
        settings = {"t": where, "a": where, "b": 1 - where, "end": end, "line": line, "depth": end, "raised": end}
        found = blocks(state_of(points, show=[layer], **settings))
        assert (len(found) > 1) == (layer not in QUIET)
        for block in found:
            assert block.title and block.rows and all(row and all(row) for row in block.rows)
            assert not re.search(r"nan|inf\b|None|Fraction|\d\.\d{4}", str(block))


def test_a_state_of_whole_numbers_stays_exact():
    """Python divides whole numbers into floats."""
    points = ((0, 0), (1, 3), (2, 1), (3, 3))
    whole = State(points, t=0, a=1, b=0, line=((0, 0), (1, 2)), show=tuple(LAYERS))
    read_in = state_of(points, t=0, a=1, b=0, line=((0, 0), (1, 2)), show=LAYERS)
    assert blocks(whole) == blocks(read_in)
    assert blocks(whole._replace(a=0, b=1)) == blocks(read_in._replace(a=F(0), b=F(1)))


def test_the_largest_board():
    """Twenty points that zigzag about the axis: every list is broken into rows, and each root is found."""
    wiggle = 1
    for k in range(1, 20):
        wiggle *= 20 * T - k
    ys = bernstein(wiggle)
    points = tuple((F(i), y / max(map(abs, ys))) for i, y in enumerate(ys))
    state = state_of(points, t=F(5, 24), show=LAYERS, line=AXIS, raised=12, depth=6)
    found = blocks(state)
    narrow = [block for block in found if not block.title.startswith("De Casteljau")]
    assert max(len(row) for block in narrow for row in block.rows) == 6
    assert len({len(row) for row in found[0].rows}) <= 2 and sum(len(row) for row in found[0].rows) == 20
    assert ("through the curve", "19 times") in [r for b in found for r in b.rows]
    assert ("control points, joints once", str(64 * 19 + 1)) in [row for block in found for row in block.rows]
    part = listed(titled(dict(found), "Part"))
    assert part == [tuple(p) for p in numeric.segment(points, F(1, 4), F(3, 4)).tolist()]


def test_what_is_said_can_be_read_aloud_and_set():
    found = blocks(state_of(CUBIC, show=["curve", "hodograph"]))
    assert text(found).startswith("Control points: (0, 0) (1, 3) (2, 1) (3, 3); Control points of the hodograph")
    assert "p''(1) (0, 24)" in text(found)
    assert "<td>p&#x27;(0)</td><td>(3, 9)</td>" in html(found) and html([Block("a < b", ())]).startswith("<b>a &lt; b")
