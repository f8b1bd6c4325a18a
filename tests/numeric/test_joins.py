"""Joins of two curves, judged by definitions that share nothing with the package; bad input to all of ``joins``."""

from fractions import Fraction as F

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import SMALL, curves, dot, few_fractions, slope, some_data, vectors

from bezteach.numeric import elevate, from_power, hodograph, segment, split
from bezteach.numeric.joins import catmull_rom, continuity, natural

ALL = ("C0", "G1", "C1", "G2", "C2")
DECK = [[0, 0], [1, 3], [2, 1], [3, 3]]
FLAT_OUT = [[0, 0], [1, 0], [2, 0]]  # a line run through evenly: velocity (2, 0)

law = settings(deadline=None, max_examples=30, database=None)
inside = few_fractions(F(1, 9), F(8, 9), 9)
lengths_of_intervals = st.tuples(*[few_fractions(F(1, 3), 3, 3)] * 2)


def verdicts(report):
    return {name: getattr(report, name).holds for name in ALL}


def residuals(report):
    return {name: np.asarray(getattr(report, name).residual).tolist() for name in ALL}


# The definitions, on lists of Fractions


def parallel(u, v):
    return all(u[i] * v[j] == u[j] * v[i] for i in range(len(u)) for j in range(i))


def curvature_vector(first, second):
    """Of the curve by arc length: what the second derivative has across the first, over the square of the speed."""
    speed2 = dot(first, first)
    return [(a * speed2 - v * dot(first, second)) / speed2**2 for v, a in zip(first, second, strict=True)]


def ends(left, right, lengths):
    """p, p', p'' and q, q', q'' from the powers of t of both curves."""
    h, k = lengths
    before = [[F(x) / F(h) ** r for x in slope(left, 1, r)] for r in range(3)]
    return before, [[F(x) / F(k) ** r for x in slope(right, 0, r)] for r in range(3)]


def expected(left, right, lengths=(1, 1)):
    (p, p1, p2), (q, q1, q2) = ends(left, right, lengths)
    c0, c1, c2 = p == q, p1 == q1, p2 == q2
    g1 = g2 = None
    if any(p1) and any(q1):
        g1 = c0 and parallel(p1, q1) and dot(p1, q1) > 0
        g2 = g1 and curvature_vector(p1, p2) == curvature_vector(q1, q2)
    return {"C0": c0, "G1": g1, "C1": c0 and c1, "G2": g2, "C2": c0 and c1 and c2}


def started(q, q1, q2, rest, length=1):
    """The curve over an interval of this length that starts with this point and these derivatives."""
    m = 2 + len(rest)
    edge = [F(length) * x / m for x in q1]
    bend = [F(length) ** 2 * x / (m * (m - 1)) for x in q2]
    near = [x + e for x, e in zip(q, edge, strict=True)]
    return [q, near, [x + e + b for x, e, b in zip(near, edge, bend, strict=True)], *rest]


@st.composite
def joins(draw):
    """Two curves for which each equation holds or fails by design: p, p', p'' may go on with beta, gamma and errors."""
    d = draw(st.integers(1, 3))
    left, rest, lengths = draw(curves(d)), draw(curves(d, 0, 2)), draw(lengths_of_intervals)
    p, p1, p2 = ends(left, left, lengths)[0]
    beta, gamma = draw(st.sampled_from([1, 1, 2, F(1, 2), 0, -1])), draw(st.sampled_from([0, 0, 1, F(-1, 2)]))
    off = [draw(st.one_of(st.just([0] * d), st.just([0] * d), st.just([0] * d), vectors(d))) for _ in range(3)]
    q = [x + e for x, e in zip(p, off[0], strict=True)]
    q1 = [beta * x + e for x, e in zip(p1, off[1], strict=True)]
    q2 = [beta**2 * a + gamma * x + e for a, x, e in zip(p2, p1, off[2], strict=True)]
    return left, started(q, q1, q2, rest, lengths[1]), lengths


# Joins written out


def test_same_direction_at_twice_the_speed_into_a_bend():
    """p' = (2, 0), p'' = (0, 0); q' = (4, 0), q'' = (0, 6)."""
    report = continuity(FLAT_OUT, [[2, 0], [4, 0], [6, 3]])
    assert verdicts(report) == {"C0": True, "G1": True, "C1": False, "G2": False, "C2": False}
    assert residuals(report) == {"C0": [0, 0], "G1": [0, 0], "C1": [2, 0], "G2": [0, 6], "C2": [0, 6]}
    assert (report.beta, report.gamma, report.vanishing, report.classes) == (2, 0, (), ("C0", "G1"))


def test_a_corner_and_its_residuals():
    """p' = (2, 0), p'' = (0, 4); q' = (4, 6), q'' = (1, 5): beta = 2, gamma = 1/2."""
    left, right = started([0, 0], [2, 0], [0, 4], []), started([1, 2], [4, 6], [1, 5], [])
    report = continuity(segment(left, -1, 0), right)  # the curve before the start of ``left``
    assert continuity(segment(left, -1, 0), left).classes == ALL
    assert residuals(report) == {"C0": [1, 2], "G1": [0, 6], "C1": [2, 6], "G2": [0, -11], "C2": [1, 1]}
    assert (report.beta, report.gamma, report.classes) == (2, F(1, 2), ())


def test_a_tangent_that_turns_round_is_not_g1_though_the_three_points_are_on_a_line():
    """The slides' condition, "three points on a line, equally far apart", met by a cusp."""
    report = continuity([[0, 0], [1, 1], [1, 0], [0, 0]], [[0, 0], [1, 0], [2, -1], [1, -2]])
    assert report.classes == ("C0",) and report.vanishing == () and report.beta == -1
    assert residuals(report)["G1"] == [3, 0] and residuals(report)["C1"] == [6, 0]


def test_a_tangent_at_a_right_angle_misses_by_all_of_itself():
    report = continuity(FLAT_OUT, [[2, 0], [2, 1]])
    assert report.classes == ("C0",) and report.beta == 0 and residuals(report)["G1"] == [0, 1]


@pytest.mark.parametrize(
    "right, classes, gamma",
    [
        ([[2, 0], [3, 0], [4, 0]], ALL, 0),
        ([[2, 0], [3, 0], [5, 0]], ("C0", "G1", "C1", "G2"), 1),  # evenly, then faster and faster
        ([[2, 0], [4, 0], [6, 0]], ("C0", "G1", "G2"), 0),  # twice as fast: the second derivatives agree, yet not C2
        ([[2, 0], [3, 0], [4, 1]], ("C0", "G1", "C1"), 0),
        ([[2, 0], [3, 1], [4, 2]], ("C0",), 0),
        ([[2, 1], [3, 1], [4, 1]], (), 0),
    ],
)
def test_a_line_goes_on(right, classes, gamma):
    report = continuity(FLAT_OUT, right)
    assert report.classes == classes and report.gamma == gamma
    assert all(holds is (name in classes) for name, holds in verdicts(report).items())


def test_bends_to_the_left_and_to_the_right_are_different_curvatures():
    """p' = q' = (4, 0), p'' = (4, 4), and q'' = (-4, 4) or (-4, -4)."""
    left = [[0, 2], [0, 0], [2, 0]]
    report = continuity(left, [[2, 0], [4, 0], [4, 2]])
    assert report.classes == ("C0", "G1", "C1", "G2") and report.gamma == -2
    assert continuity(left, [[2, 0], [4, 0], [4, -2]]).classes == ("C0", "G1", "C1")


def test_in_space_the_plane_of_the_bend_counts():
    left = segment(started([0, 0, 0], [2, 0, 0], [0, 2, 0], []), -1, 0)
    same, turned = (started([0, 0, 0], [4, 0, 0], bend, [[1, 1, 1]]) for bend in ([3, 8, 0], [3, 0, 8]))
    assert continuity(left, same).classes == ("C0", "G1", "G2") and continuity(left, same).gamma == F(3, 2)
    assert continuity(left, turned).classes == ("C0", "G1")
    assert residuals(continuity(left, turned))["G2"] == [0, -8, 8]


def test_degrees_and_lengths_enter_the_derivatives():
    """A line over 2 has p' = (2, 1); a cubic over 3 has q' = 3 edge / 3."""
    left, right = [[0, 0], [4, 2]], [[4, 2], [6, 3], [8, 4], [7, 7]]
    assert continuity(left, right, (2, 3)).classes == ALL
    report = continuity(left, right)
    assert report.classes == ("C0", "G1", "G2") and report.beta == F(3, 2) and residuals(report)["C1"] == [2, 1]
    report = continuity(left, [*right[:2], [8, 7], [7, 7]], (3, F(1, 2)))
    assert report.classes == ("C0", "G1") and report.beta == F(6, 1) / F(2, 3)
    assert residuals(report)["C2"] == [0, 6 * 3 * 4] and residuals(report)["G2"] == [F(-144, 5), F(288, 5)]


def test_one_coordinate_is_a_line_on_which_only_the_direction_counts():
    report = continuity([0, 1, 3], [3, 4, 9])
    assert report.classes == ("C0", "G1", "G2") and (report.beta, report.C1.residual) == (F(1, 2), -2)
    assert continuity([0, 1], [1, 0]).classes == ("C0",) and continuity([0, 1], [1, 0]).G1.residual == -1


@pytest.mark.parametrize(
    "left, right, vanishing",
    [
        ([[0, 0], [1, 1], [1, 1]], [[1, 1], [2, 2]], ("left",)),
        ([[0, 0], [1, 1]], [[1, 1], [1, 1], [3, 4]], ("right",)),
        ([[1, 1]], [[1, 1]], ("left", "right")),
        ([[1, 1]], [[1, 2]], ("left", "right")),
    ],
)
def test_without_a_tangent_g1_and_g2_are_left_open(left, right, vanishing):
    report = continuity(left, right)
    assert report.vanishing == vanishing and report.beta is report.gamma is None
    assert tuple(report.G1) == tuple(report.G2) == (None, None)
    for name in ("C0", "C1", "C2"):
        assert getattr(report, name).holds is expected(left, right)[name]


def test_at_rest_on_both_sides_is_c1_and_may_be_c2():
    assert continuity([[1, 3], [1, 2], [1, 2]], [[1, 2], [1, 2], [1, 3]]).classes == ("C0", "C1", "C2")
    assert continuity([[1, 3], [1, 2], [1, 2]], [[1, 2], [1, 2], [3, 1]]).classes == ("C0", "C1")


def test_one_large_case():
    points = [[F(i * i - 40 * i, 3), F((-1) ** i * i, 7), i % 5] for i in range(41)]
    t = F(2, 7)
    left, right = split(points, t)
    report = continuity(left, elevate(right, 3), (t, 1 - t))
    assert report.classes == ALL and not np.concatenate(list(residuals(report).values())).any()
    assert (report.beta, report.gamma) == (1, 0)
    report = continuity(left, right)
    assert report.classes == ("C0", "G1", "G2") and report.beta == (1 - t) / t
    right[2, 2] += F(1, 10**30)
    assert continuity(left, right).classes == ("C0", "G1")


# Laws of joins


@settings(law, max_examples=150)
@given(joins())
def test_the_classes_are_those_of_the_definitions(join):
    assert verdicts(continuity(*join)) == expected(*join)


@law
@given(st.integers(1, 3).flatmap(lambda d: st.tuples(curves(d), curves(d), lengths_of_intervals)))
def test_the_classes_of_any_two_curves(join):
    assert verdicts(continuity(*join)) == expected(*join)


@law
@given(joins())
def test_residuals_are_what_the_equations_leave_over(join):
    (p, p1, p2), (q, q1, q2) = (list(map(np.array, side)) for side in ends(*join))
    report = continuity(*join)
    c0, g1, c1, g2, c2 = (getattr(report, name).residual for name in ALL)
    assert (c0 == q - p).all() and (c1 == q1 - p1).all() and (c2 == q2 - p2).all()
    if not report.vanishing:
        beta, gamma = report.beta, report.gamma
        assert dot(q1 - beta * p1, p1) == 0 == dot(g2, p1)
        assert (g1 == q1 - max(beta, 0) * p1).all()
        assert (q2 == beta**2 * p2 + gamma * p1 + g2).all()


@law
@given(joins())
def test_each_class_includes_the_lower_ones(join):
    holds = verdicts(continuity(*join))
    for higher, lower in [("C1", "C0"), ("C2", "C1"), ("G1", "C0"), ("G2", "G1"), ("C1", "G1"), ("C2", "G2")]:
        assert not holds[higher] or holds[lower] is not False, (higher, lower)
        assert not holds[higher] or holds[lower] or holds["G1"] is None


@law
@given(joins())
def test_c_is_g_with_factors_one_and_zero(join):
    report = continuity(*join)
    if not report.vanishing:
        assert report.C1.holds == (report.G1.holds and report.beta == 1)
        assert report.C2.holds == (report.G2.holds and (report.beta, report.gamma) == (1, 0))


@law
@given(joins())
def test_another_length_makes_any_g1_join_c1_and_keeps_g(join):
    left, right, (h, k) = join
    before = continuity(left, right, (h, k))
    if before.G1.holds:
        after = continuity(left, right, (h, k * before.beta))
        assert after.C1.holds and after.beta == 1 and after.G2.holds == before.G2.holds


@law
@given(some_data(1, 7), inside)
def test_a_cut_curve_is_one_curve_in_every_derivative(points, t):
    left, right = split(points, t)
    report = continuity(left, right, (t, 1 - t))
    assert report.C2.holds and (report.vanishing == ("left", "right") if report.vanishing else report.classes == ALL)
    for r in range(len(points) + 1):
        assert (hodograph(left, r)[-1] / t**r == hodograph(right, r)[0] / (1 - t) ** r).all()


@law
@given(joins(), st.lists(SMALL, min_size=12, max_size=12))
def test_an_affine_map_keeps_all_classes(join, entries):
    left, right, lengths = join
    d = len(left[0])
    triangle = np.array([[entries[3 * i + j] if j < i else int(i == j) for j in range(d)] for i in range(d)])
    matrix = triangle @ triangle.T * 2  # an invertible one
    before = continuity(left, right, lengths)
    after = continuity(
        np.array(left) @ matrix + entries[9 : 9 + d], np.array(right) @ matrix + entries[9 : 9 + d], lengths
    )
    assert verdicts(after) == verdicts(before) and after.vanishing == before.vanishing
    if before.G2.holds:
        assert (after.beta, after.gamma) == (before.beta, before.gamma)


@law
@given(joins())
def test_running_backwards_keeps_all_classes(join):
    left, right, (h, k) = join
    before, after = continuity(left, right, (h, k)), continuity(right[::-1], left[::-1], (k, h))
    assert verdicts(after) == verdicts(before) and len(after.vanishing) == len(before.vanishing)
    assert (after.C0.residual == -before.C0.residual).all() and (after.C2.residual == -before.C2.residual).all()
    assert (after.C1.residual == before.C1.residual).all()
    if before.G1.holds:
        assert after.beta == 1 / before.beta


@law
@given(joins(), st.integers(0, 2), st.integers(0, 2))
def test_elevation_on_either_side_changes_nothing(join, r, s):
    left, right, lengths = join
    before, after = continuity(*join), continuity(elevate(left, r), elevate(right, s), lengths)
    assert residuals(after) == residuals(before) and verdicts(after) == verdicts(before)


# Joins of symbols


def test_a_change_of_parameter_is_g2_by_sympy_from_scratch():
    """q(s) = p(1 + phi(s)) with phi(0) = 0, phi'(0) = beta > 0, phi''(0) = gamma, to the second order in s."""
    s, gamma, c = sympy.symbols("s gamma c")
    beta = sympy.Symbol("beta", positive=True)
    for d in (1, 2, 3):
        left = [list(sympy.symbols(f"x{i} y{i} z{i}")[:d]) for i in range(4)]
        u = 1 + beta * s + gamma * s**2 / 2
        moved = [
            sum(sympy.binomial(3, i) * u**i * (1 - u) ** (3 - i) * b[k] for i, b in enumerate(left)) for k in range(d)
        ]
        taylor = [[sympy.diff(x, s, r).subs(s, 0) / sympy.factorial(r) for x in moved] for r in range(3)]
        report = continuity(left, from_power(taylor))
        assert report.G2.holds and report.C1.holds is report.C2.holds is None
        assert (report.beta, report.gamma) == (beta, gamma)
        bent = [taylor[0], taylor[1], [x + c * int(k == 0) for k, x in enumerate(taylor[2])]]
        assert continuity(left, from_power(bent)).classes == (("C0", "G1", "G2") if d == 1 else ("C0", "G1"))


def test_the_residual_of_g2_is_the_jump_of_the_curvature_in_the_plane():
    """Across p' it is the square of the new speed times the jump, for any quadratic curves with one tangent."""
    x1, y1, x2, y2, x3, y3 = sympy.symbols("x1 y1 x2 y2 x3 y3", real=True)
    beta = sympy.Symbol("beta", positive=True)
    left = segment(started([0, 0], [x1, y1], [x2, y2], []), -1, 0)
    report = continuity(left, started([0, 0], [beta * x1, beta * y1], [x3, y3], []))
    speed = sympy.sqrt(x1**2 + y1**2)
    jump = (x1 * y3 - y1 * x3) * beta / (beta * speed) ** 3 - (x1 * y2 - y1 * x2) / speed**3
    across = (report.G2.residual[1] * x1 - report.G2.residual[0] * y1) / speed
    assert sympy.simplify(across - (beta * speed) ** 2 * jump) == 0
    assert report.classes == ("C0", "G1") and report.G2.holds is None


def test_a_cut_of_symbols_at_a_symbol():
    t = sympy.Symbol("t")
    points = [list(sympy.symbols(f"x{i} y{i}")) for i in range(4)]
    left, right = split(points, t)
    report = continuity(left, right, (t, 1 - t))
    assert report.classes == ALL and (report.beta, report.gamma) == (1, 0)
    assert all(x == 0 for row in residuals(report).values() for x in row)
    open_ = continuity(left, right)  # beta = (1 - t) / t is positive for t between 0 and 1 only
    assert verdicts(open_) == {"C0": True, "G1": None, "C1": None, "G2": None, "C2": None}
    assert residuals(open_)["G1"] == residuals(open_)["G2"] == [0, 0]
    assert sympy.cancel(open_.beta - (1 - t) / t) == 0


def test_what_depends_on_symbols_is_left_open_and_what_does_not_is_decided():
    x = sympy.Symbol("x")
    up, down = sympy.Symbol("up", positive=True), sympy.Symbol("down", negative=True)
    assert verdicts(continuity([0, 1], [1, x])) == {"C0": True, "G1": None, "C1": None, "G2": None, "C2": None}
    assert continuity([0, 1], [1, x]).C1.residual == x - 2
    assert set(verdicts(continuity([0, 1], [2, x])).values()) == {False}
    assert verdicts(continuity([0, 1], [1, 1 + up])) == {"C0": True, "G1": True, "C1": None, "G2": True, "C2": None}
    turned = continuity([0, 1], [1, 1 + down])
    assert (turned.G1.holds, turned.G2.holds, turned.G1.residual) == (False, False, down)
    assert continuity([0, 0], [up, 1]).C0.holds is False  # known not to be 0
    assert continuity([0, 0, 5], [x, 1, 2]).C0.holds is None
    assert continuity([0, (x + 1) ** 2], [x**2 + 2 * x + 1, 0]).C0 == (True, 0)
    unlike = [(x + 1) ** 2, x**2 + 2 * x + 1]
    assert continuity(unlike, [0, 1]).vanishing == ("left",) and continuity([0, 1], unlike).vanishing == ("right",)


def test_roots_are_exact_numbers():
    root = sympy.sqrt(2)
    assert continuity([0, root], [root, 2 * root]).classes == ALL
    report = continuity([0, 1], [1, root], (1, 1 / (1 + root)))
    assert report.classes == ALL and report.beta.equals(1)
    assert continuity([0, 1], [1, root]).C1.holds is False
    nested = sympy.sqrt(5 + 2 * sympy.sqrt(6))
    report = continuity([0, root + sympy.sqrt(3)], [nested, 2 * nested])
    assert report.classes == ALL and report.C0.residual == report.C1.residual == 0
    one = sympy.sin(1) ** 2 + sympy.cos(1) ** 2
    assert continuity([0, 1], [one, 2 * one]).classes == ALL and continuity([1, 1], [1, one]).vanishing == (
        "left",
        "right",
    )
    assert continuity([0, 1], [1, 2], (1, sympy.Rational(1, 3))).C1.residual == 2


# What goes in and what comes out

BAD_JOINS = {
    "nan": ([1, 2], [2, np.nan], (1, 1), "control point Q_1 has coordinate nan: a finite real number is needed"),
    "text": ([[1, "2"]], [[1, 2]], (1, 1), "control point P_0 has coordinate '2': a finite real number is needed"),
    "empty": ([], [1], (1, 1), "control point P: empty, nested too deep, or a list that holds itself"),
    "batch": ([[1, 2]], [[[1, 2]]] * 3, (1, 1), "the right curve is a batch of 3: a join is of two single curves"),
    "batches": ([[[1, 2]]], [[1, 2]], (1, 1), "the left curve is a batch of 1: a join is of two single curves"),
    "plane and space": (
        [[1, 2]],
        [[1, 2, 3]],
        (1, 1),
        "coordinates of a point: 2 in the left curve, 3 in the right: they must agree",
    ),
    "flat and not": (
        [1, 2],
        [[1], [2]],
        (1, 1),
        "coordinates of a point: numbers in the left curve, 1 in the right: they must agree",
    ),
    "one length": (
        [1],
        [1],
        1,
        "parameter lengths has shape (): two numbers are needed, one for each curve",
    ),
    "three lengths": (
        [1],
        [1],
        (1, 2, 3),
        "parameter lengths has shape (3,): two numbers are needed, one for each curve",
    ),
    "zero": ([1], [1], (1, 0), "parameter lengths[1] is 0: it must be positive"),
    "zero float": ([1], [1], np.array([0.0, 1]), "parameter lengths[0] is 0.0: it must be positive"),
    "negative": ([1], [1], (F(-1, 2), 1), "parameter lengths[0] is Fraction(-1, 2): it must be positive"),
    "negative root": ([1], [1], (1 - sympy.sqrt(2), 1), "parameter lengths[0] is 1 - sqrt(2): it must be positive"),
    "negative symbol": (
        [1],
        [1],
        (1, sympy.Symbol("h", nonpositive=True)),
        "parameter lengths[1] is h: it must be positive",
    ),
    "true": ([1], [1], (True, 1), "parameter lengths[0] is True: a finite real number is needed"),
    "float and symbol": (
        [0.5, 1],
        [sympy.Symbol("x")],
        (1, 1),
        "a float beside x: write the float as a fraction to stay exact",
    ),
    "beyond float64": (
        [1e308, -1e308],
        [1e308, 2],
        (1, 1),
        "a number is too large for float64: write the floats beside it as fractions",
    ),
}
BAD_DATA = {
    "one": ([[1, 2]], "there is 1 data point: at least 2 are needed"),
    "one number": ([1.0], "there is 1 data point: at least 2 are needed"),
    "none": ([0, None], "data point D_1 has coordinate None: a finite real number is needed"),
    "infinity": ([[1, 2], [3, np.inf]], "data point D_1 has coordinate inf: a finite real number is needed"),
    "ragged": ([[1, 2], [3]], "data point D: ragged, the entry [1] has not the length of the first"),
    "empty": (np.ones((0, 2)), "data point D: there are none, the array is empty"),
    "a number": (3, "data point D: 0 axes; 1 (a coordinate), 2 (a curve) or 3 (a batch) are needed"),
    "large": ([1e308, -1e308, 1e308], "the result is too large for float64: give the numbers as int or Fraction"),
}


@pytest.mark.parametrize("left, right, lengths, message", BAD_JOINS.values(), ids=BAD_JOINS)
def test_bad_joins(left, right, lengths, message):
    with pytest.raises(ValueError) as caught:
        continuity(left, right, lengths)
    assert str(caught.value) == message


@pytest.mark.parametrize("function", [catmull_rom, natural])
@pytest.mark.parametrize("data, message", BAD_DATA.values(), ids=BAD_DATA)
def test_bad_data(function, data, message):
    with pytest.raises(ValueError) as caught:
        function(data)
    assert str(caught.value) == message


@pytest.mark.parametrize("dtype", [object, np.int8, np.uint64])
def test_integers_give_fractions_and_never_overflow(dtype):
    big = np.array([[0, 1], [100, 127], [100, 127]], dtype)
    for function in (catmull_rom, natural):
        assert {type(x) for x in function(big).flat} == {F}
    report = continuity(big[:2], big[1:2], np.array([1, 2], dtype))
    assert {type(x) for name in ("C0", "C1", "C2") for x in getattr(report, name).residual} == {F}
    report = continuity([0, 2**62], np.array([2**62, -(2**62)]))
    assert report.C1.residual == -3 * 2**62 and {type(x) for x in (report.beta, report.gamma)} == {F}
    assert {type(getattr(report, name).residual) for name in ALL} == {F}


@pytest.mark.parametrize("x", [0.5, np.float32(0.5), sympy.Float(0.5)])
def test_one_float_makes_everything_float64(x):
    for join in (
        ([[0, 0], [1, x]], DECK),
        (DECK, [[0, x]] * 2),
        (DECK[:2], DECK[1:], (x, 1)),
        (DECK, DECK[::-1], [1, x]),
    ):
        report = continuity(*join)
        found = [getattr(report, name).residual for name in ALL] + [report.beta, report.gamma]
        assert {np.asarray(r).dtype for r in found if r is not None} == {np.dtype(float)}
    assert isinstance(continuity([0, x], [1, 2]).C0.residual, float)
    for function in (catmull_rom, natural):
        assert function([[0, 1], [x, F(1, 3)], [1, 1]]).dtype == np.dtype(float)


def test_floats_are_judged_as_the_fractions_that_they_are():
    report = continuity([[-0.1, -0.2], [0, 0]], [[0, 0], [0.3, 0.6]])  # 0.2 is twice 0.1, and 0.6 twice 0.3
    assert report.classes == ("C0", "G1", "G2") and report.beta == pytest.approx(3, rel=1e-15)
    report = continuity([0, 0.1 + 0.2], [0.3, 1])
    assert report.C0.holds is False and report.C0.residual == float(F(0.3) - F(0.1 + 0.2)) != 0
    left, right = split(np.array(DECK, float), 0.25)  # no rounding here
    assert continuity(left, right, (0.25, 0.75)).classes == ALL


@law
@given(joins())
def test_floats_give_the_rounded_residuals_of_their_fractions(join):
    left, right, lengths = (np.array(part, float) for part in join)
    exactly = continuity(
        *([list(map(F, row)) for row in points.tolist()] for points in (left, right)), list(map(F, lengths))
    )
    rounded = continuity(left, right, lengths)
    assert verdicts(rounded) == verdicts(exactly) and rounded.vanishing == exactly.vanishing
    for name in ALL:
        residual = getattr(exactly, name).residual
        assert residual is None or getattr(rounded, name).residual.tolist() == [float(x) for x in residual]
    assert exactly.beta is None or (rounded.beta, rounded.gamma) == (float(exactly.beta), float(exactly.gamma))


def test_shapes():
    data = np.arange(10).reshape(5, 2) ** 2
    for function in (catmull_rom, natural):
        for kind in (int, float):
            whole = function(data.astype(kind))
            assert whole.shape == (4, 4, 2)
            assert (function(data[:, 1].astype(kind)) == whole[..., 1]).all()
            batch = function(np.stack([data, 2 * data, data[::-1]]).astype(kind))
            assert batch.shape == (3, 4, 4, 2) and (batch[0] == whole).all() and (batch[1] == 2 * whole).all()
            assert (batch[2] == function(data[::-1].astype(kind))).all()
    assert continuity(DECK, DECK).C0.residual.shape == (2,)
    assert continuity([[1], [2]], [[2], [4]]).C1.residual.shape == (1,)
    assert np.shape(continuity([1, 2], [2, 4]).C1.residual) == ()


@pytest.mark.parametrize("kind", [float, object])
def test_results_are_the_callers_own(kind):
    data = np.array(DECK, kind)
    for function in (catmull_rom, natural):
        function(data)[...] = 77
    report = continuity(data, data)
    for name in ALL:
        getattr(report, name).residual[...] = 77
    assert data.tolist() == DECK
