"""B-splines, what goes in and comes out: shapes, kinds of numbers, ownership, a one-line error for each bad input."""

from fractions import Fraction as F
from functools import partial

import numpy as np
import pytest
import sympy

from bezteach.numeric import bspline
from bezteach.numeric.bspline import (
    averages,
    basis,
    blossom,
    clamped,
    de_boor,
    derivative,
    evaluate,
    insert,
    multiplicities,
    span,
    to_bezier,
    uniform,
)

KNOTS = [0, 0, 0, 1, 2, 3, 4, 4, 4]
POINTS = [[0, 0], [1, 3], [2, 1], [3, 3], [5, 5], [6, 0]]
x = sympy.Symbol("x")

# Every function, as a function of its points and knots, of its knots, or of its parameter alone.
OF_CURVES = {
    "evaluate": lambda p, k: evaluate(p, k, 2),
    "derivative": lambda p, k: derivative(p, k, 2),
    "derivative 0": lambda p, k: derivative(p, k, 2, 0),
    "derivative 9": lambda p, k: derivative(p, k, 2, 9),
    "de_boor": lambda p, k: de_boor(p, k, 2),
    "blossom": lambda p, k: blossom(p, k, 3, *[1] * (len(k) - len(p) - 1)),
    "insert": lambda p, k: insert(p, k, F(1, 2)),
    "insert 0": lambda p, k: insert(p, k, F(1, 2), 0),
    "to_bezier": to_bezier,
}
OF_KNOTS = {
    **{name: partial(f, POINTS) for name, f in OF_CURVES.items() if name != "blossom"},
    "blossom": lambda k: blossom(POINTS, k, 3, 1, 1),
    "basis": lambda k: basis(k, 2, 2),
    "span": lambda k: span(k, 2, 2),
    "averages": lambda k: averages(k, 2),
    "multiplicities": multiplicities,
}
OF_SCALAR = {
    "de_boor": lambda t: de_boor(POINTS, KNOTS, t),
    "insert": lambda t: insert(POINTS, KNOTS, t),
    "blossom": lambda t: blossom(POINTS, KNOTS, 3, 1, t),
}
OF_PARAMETER = {
    "basis": lambda t: basis(KNOTS, 2, t),
    "evaluate": lambda t: evaluate(POINTS, KNOTS, t),
    "derivative": lambda t: derivative(POINTS, KNOTS, t),
    "span": lambda t: span(KNOTS, 2, t),
}
of_curves = pytest.mark.parametrize("function", OF_CURVES.values(), ids=OF_CURVES)


def parts(result):
    return list(result) if isinstance(result, tuple) else [result]


def leaves(result):
    return [v for part in parts(result) for v in np.asarray(part).ravel().tolist()]


def message(call):
    with pytest.raises(ValueError) as caught:
        call()
    assert type(caught.value) is ValueError and "\n" not in str(caught.value) and len(str(caught.value)) < 200
    return str(caught.value)


def rejects(call, *words):
    text = message(call)
    for word in words:
        assert word in text, text


def test_what_is_public_has_a_docstring():
    names = "averages basis blossom clamped de_boor derivative evaluate insert multiplicities span to_bezier uniform"
    assert all(getattr(bspline, name).__doc__ for name in names.split())


# Shapes


@pytest.mark.parametrize("kind", [float, object])
@pytest.mark.parametrize("shape", [(), (1,), (6,), (2, 3), (1, 2, 2)])
def test_shapes_of_functions_of_t(kind, shape):
    t = np.ones(shape, kind)
    for points, lead, last in ((range(6), (), ()), (POINTS, (), (2,)), ([POINTS] * 5, (5,), (2,))):
        assert np.shape(evaluate(points, KNOTS, t)) == (*lead, *shape, *last)
        assert np.shape(evaluate(points, KNOTS, t, span=4)) == (*lead, *shape, *last)
        for r in (0, 1, 2, 3):
            assert np.shape(derivative(points, KNOTS, t, r)) == (*lead, *shape, *last)
    assert basis(KNOTS, 2, t).shape == (*shape, 6) and basis(KNOTS, 5, t).shape == (*shape, 3)
    assert np.shape(span(KNOTS, 2, t)) == shape


@pytest.mark.parametrize("kind", [float, object])
@pytest.mark.parametrize("points, lead, last", [(range(6), (), ()), (POINTS, (), (2,)), ([POINTS] * 5, (5,), (2,))])
def test_shapes_of_functions_of_points(kind, points, lead, last):
    points = np.array(points, kind)
    assert [np.shape(level) for level in de_boor(points, KNOTS, 1)] == [(*lead, k, *last) for k in (3, 2, 1)]
    assert np.shape(blossom(points, KNOTS, 3, 1, 2)) == (*lead, *last)
    assert [part.shape for part in insert(points, KNOTS, 1, 2)] == [(*lead, 8, *last), (11,)]
    assert [part.shape for part in insert(points, KNOTS, 1, 0)] == [(*lead, 6, *last), (9,)]
    assert [part.shape for part in to_bezier(points, KNOTS)] == [(*lead, 4, 3, *last), (5,)]


def test_degree_0_has_no_arguments():
    points, knots = [5, 7], [0, 1, 3]
    assert [level.tolist() for level in de_boor(points, knots, 2)] == [[7]]
    assert blossom(points, knots, 1) == 7
    assert [part.tolist() for part in insert(points, knots, 2)] == [[5, 7, 7], [0, 1, 2, 3]]
    assert [part.tolist() for part in to_bezier(points, knots)] == [[[5], [7]], [0, 1, 3]]
    assert derivative(points, knots, [0, 3]).tolist() == [0, 0]


# Kinds of numbers


@of_curves
@pytest.mark.parametrize("dtype", [np.int8, np.uint64, object])
def test_integers_stay_exact_and_become_python_numbers(function, dtype):
    for v in leaves(function(np.array(POINTS, dtype), np.array(KNOTS, dtype))):
        assert type(v) in (int, F)
        assert type(v.numerator) is type(v.denominator) is int


@of_curves
@pytest.mark.parametrize("points, knots", [(float, int), (int, float), (np.float32, np.int8), (float, float)])
def test_a_float_anywhere_makes_everything_float64(function, points, knots):
    got = parts(function(np.array(POINTS, points), np.array(KNOTS, knots)))
    assert {np.asarray(part).dtype for part in got} == {np.dtype(float)}


def test_a_float_parameter_makes_everything_float64():
    for f in (*OF_PARAMETER.values(), *OF_SCALAR.values()):
        for t in (1.0, np.float32(1), sympy.Float(1)):
            kinds = {np.asarray(part).dtype for part in parts(f(t))}
            assert kinds == ({np.dtype(np.intp)} if f is OF_PARAMETER["span"] else {np.dtype(float)})


def test_nothing_overflows():
    big = np.array([2**62, -(2**62), 2**62], np.int64)
    assert derivative(big, clamped(3, 2), 0) == -(2**64)
    assert evaluate([0, 10**400], [0, 0, 10**300, 10**300], 10**299) == 10**399
    rejects(lambda: evaluate([0, 10**400], [0, 0, 1, 1], 0.5), "too large")


@of_curves
@pytest.mark.parametrize("kind", [float, object])
def test_results_are_the_callers_own(function, kind):
    points, knots = np.array(POINTS, kind), np.array(KNOTS, kind)
    first = parts(function(points, knots))
    copies = [np.copy(part) for part in first]
    for part in first:
        assert not np.shares_memory(part, points) and not np.shares_memory(part, knots)
        part[...] = 77
    assert points.tolist() == POINTS and knots.tolist() == KNOTS
    for again, before in zip(parts(function(points, knots)), copies, strict=True):
        assert np.array_equal(again, before)


# Errors


@pytest.mark.parametrize(
    "bad",
    [np.nan, -np.inf, 1j, "1", None, True, sympy.oo, sympy.I, x < 1, [1], {1}, np.datetime64("2020-01-01")],
    ids=repr,
)
def test_what_is_no_number_is_refused(bad):
    for f in OF_KNOTS.values():
        rejects(lambda f=f: f([*KNOTS[:5], bad, *KNOTS[6:]]), "knots")
        rejects(
            lambda f=f: f(np.array([*KNOTS[:5], bad, *KNOTS[6:]], object) if not isinstance(bad, list) else [bad, 1])
        )
    for f in OF_CURVES.values():
        rejects(lambda f=f: f([*POINTS[:2], [1, bad], *POINTS[3:]], KNOTS), "control point b")
    for f in (*OF_PARAMETER.values(), *OF_SCALAR.values()):
        if not isinstance(bad, list):
            rejects(lambda f=f: f(bad), "parameter ")
    for f in OF_SCALAR.values():
        rejects(lambda f=f: f([bad]), "parameter ")


@pytest.mark.parametrize(
    "bad", [[], [[]], 3, None, "0011", [[0, 0, 1, 1]], np.ones((2, 3)), [[0, 1], [2]], {0, 1}], ids=repr
)
def test_what_is_no_row_of_knots(bad):
    for f in OF_KNOTS.values():
        rejects(lambda f=f: f(bad), "knots")


@pytest.mark.parametrize("bad", [-1, 1.0, True, "1", None, F(1), [1], 10**30, 1j], ids=repr)
def test_whole_numbers(bad):
    for f in (clamped, uniform):
        rejects(lambda f=f: f(bad, 2), "count")
        rejects(lambda f=f: f(5, bad), "degree p")
    for f in (basis, span):
        rejects(lambda f=f: f(KNOTS, bad, 1), "degree p")
    rejects(lambda: averages(KNOTS, bad), "degree p")
    rejects(lambda: blossom(POINTS, KNOTS, bad, 1, 1), "span k")
    if type(bad) is not int or bad < 0:
        rejects(lambda: derivative(POINTS, KNOTS, 1, bad), "order r")
        rejects(lambda: insert(POINTS, KNOTS, 1, bad), "times")
    if bad is not None:
        for f in (evaluate, de_boor):
            rejects(lambda f=f: f(POINTS, KNOTS, 1, span=bad), "span k")
        rejects(lambda: basis(KNOTS, 2, 1, span=bad), "span k")


def test_messages_of_knots():
    assert message(lambda: evaluate(POINTS, [0, 0, 0, 1, 3, 2, 4, 4, 4], 1)) == (
        "knot t_5 = 2 is below t_4 = 3: knots must not decrease"
    )
    assert message(lambda: multiplicities([0.0, -1.5])) == "knot t_1 = -1.5 is below t_0 = 0.0: knots must not decrease"
    assert message(lambda: evaluate(POINTS, [0, 0, 0, 0, 2, 3, 4, 4, 4], 1)) == (
        "knot 0 stands 4 times: at degree 2 it may stand at most 3 times"
    )
    assert message(lambda: basis([0, 1, 2, 2, 2, 2, 3], 2, 1)) == (
        "knot 2 stands 4 times: at degree 2 it may stand at most 3 times"
    )
    assert message(lambda: evaluate([1, 2, 3], KNOTS, 1)) == (
        "9 knots do not fit 3 control points: 4 to 6 are needed, degree+1 more"
    )
    assert message(lambda: evaluate(range(9), KNOTS, 1)) == (
        "9 knots do not fit 9 control points: 10 to 18 are needed, degree+1 more"
    )
    assert message(lambda: evaluate([1, 2, 3], range(7), 3)) == (
        "7 knots do not fit 3 control points: 4 to 6 are needed, degree+1 more"
    )
    assert message(lambda: basis([0, 1, 2], 2, 1)) == "3 knots are too few: degree 2 needs at least 4"
    assert message(lambda: averages([0, 1, 2], 2)) == "3 knots are too few: degree 2 needs at least 4"
    assert message(lambda: span([0, 1, 2, 3], 2, 1)) == "1 control points are too few: degree 2 needs at least 3"
    assert message(lambda: evaluate([1, 2], [0, 1, 1, 2], 1)) == "the domain [t_1, t_2] is empty: both knots are 1"
    assert message(lambda: evaluate([1, 2], [0, 0, x, 1], 0)) == (
        "knot t_2 is x: an integer, a fraction or a float is needed"
    )
    assert message(lambda: evaluate([1, 2], [-1e308, -1e308, 1e308, 1e308], 0)) == (
        "the knots are too far apart for float64: give the numbers as int or Fraction"
    )
    assert message(lambda: evaluate(POINTS, [*KNOTS[:5], np.nan, 4, 4, 4], 1)) == (
        "parameter knots[5] is nan: a finite real number is needed"
    )
    assert message(lambda: evaluate(POINTS, [KNOTS], 1)) == "knots have 2 axes: one row of numbers is needed"
    assert message(lambda: clamped(2, 2)) == "count is 2: it must be between 3 and 100000000"
    rejects(lambda: evaluate([1, x], [0, 0, 0.5, 1], 0), "a float beside x")
    rejects(lambda: evaluate([1, 2], [0, 0, 1, 1], [0.5, x]), "a float beside x")


def test_fractions_that_meet_as_floats_are_counted_as_floats():
    near = [0, 0, F(1), 1 + F(1, 10**30), 1 + F(2, 10**30), 2, 2]
    assert evaluate([0, 1, 2, 3, 4], near, F(1, 2)) == F(1, 2)
    rejects(lambda: evaluate([0, 1, 2, 3, 4], near, 0.5), "knot 1.0 stands 3 times")


@pytest.mark.parametrize(
    "bad", [-1, 5, F(-1, 10**9), 4 + F(1, 10**9), -5e-324, np.nextafter(4, 5), sympy.sqrt(17)], ids=repr
)
def test_a_parameter_outside_the_domain(bad):
    for f in (*OF_PARAMETER.values(), OF_SCALAR["de_boor"], OF_SCALAR["insert"]):
        rejects(lambda f=f: f(bad), "parameter t is", "it must lie in the domain [0", "4")
    for f in OF_PARAMETER.values():
        rejects(lambda f=f: f([0, bad]), "parameter t is")
        rejects(lambda f=f: f(np.r_[np.ones(5000), float(bad) * (1 + 1e-15)]), "parameter t is")


def test_the_domain_of_unclamped_knots_is_inside_them():
    knots = uniform(5, 2)
    assert evaluate(range(5), knots, [2, 5]).tolist() == [F(1, 2), F(7, 2)]
    for t in (F(3, 2), F(11, 2), 1.5, 5.5):
        rejects(lambda t=t: evaluate(range(5), knots, t), "the domain [2", "5")
        rejects(lambda t=t: insert(range(5), knots, t), "the domain [2", "5")
        rejects(lambda t=t: span(knots, 2, t), "the domain [2", "5")
    # the basis is given between all the knots, where its sum may be less than 1
    assert basis(knots, 2, [0, 1, F(3, 2), 5, 7]).tolist() == [
        [0] * 5,
        [F(1, 2), 0, 0, 0, 0],
        [F(3, 4), F(1, 8), 0, 0, 0],
        [0, 0, 0, F(1, 2), F(1, 2)],
        [0] * 5,
    ]
    for t in (-1, 8, -1e-9, 7.1):
        rejects(lambda t=t: basis(knots, 2, t), "it must lie in the domain [0", "7")


def test_a_symbol_needs_a_span_and_a_span_must_not_be_empty():
    for f in (*OF_PARAMETER.values(), OF_SCALAR["de_boor"], OF_SCALAR["insert"]):
        assert message(lambda f=f: f(x)) == "parameter t is x: a symbol lies in no span of the knots"
    for k, words in ((1, "between 2 and 5"), (6, "between 2 and 5")):
        rejects(lambda k=k: evaluate(POINTS, KNOTS, x, span=k), f"span k is {k}", words)
        rejects(lambda k=k: de_boor(POINTS, KNOTS, x, span=k), f"span k is {k}", words)
        rejects(lambda k=k: blossom(POINTS, KNOTS, k, x, x), f"span k is {k}", words)
    assert message(lambda: basis(KNOTS, 2, x, span=1)) == "span k is 1: it is empty, t_1 and t_2 are both 0"
    assert message(lambda: evaluate([1, 2, 3, 4], [0, 0, 1, 1, 2, 2], x, span=2)) == (
        "span k is 2: it is empty, t_2 and t_3 are both 1"
    )
    rejects(lambda: basis(KNOTS, 2, x, span=8), "between 0 and 7")


def test_blossoms_have_degree_many_arguments():
    for arguments in ((), (1,), (1, 2, 3)):
        assert message(lambda a=arguments: blossom(POINTS, KNOTS, 3, *a)) == (
            f"a blossom of degree 2 has 2 arguments: {len(arguments)} are given"
        )
    rejects(lambda: blossom(POINTS, KNOTS, 3, 1, None), "parameter u_2 is None")
    rejects(lambda: blossom(POINTS, KNOTS, 3, [1, 2]), "parameter u_1", "single number")


def test_a_knot_is_inserted_up_to_degree_plus_1_times():
    for t, times, stands in ((1, 3, 4), (F(1, 2), 4, 4), (0, 1, 4), (4, 1, 4), (2, 10**6, 10**6 + 1)):
        assert message(lambda t=t, k=times: insert(POINTS, KNOTS, t, k)) == (
            f"knot {t} stands {stands} times: at degree 2 it may stand at most 3 times"
        )
    points, knots = insert(POINTS, KNOTS, 1, 2)
    assert knots.tolist().count(1) == 3 and (points[2] == points[3]).all()
    rejects(lambda: insert(POINTS, KNOTS, sympy.sqrt(2)), "knot t_4 is sqrt(2)", "a fraction")


def test_values_that_float64_cannot_hold():
    rejects(lambda: derivative([0.0, 1e300], [0, 0, 1e-300, 1e-300], 0), "too large for float64")
    assert evaluate([0.0, 1e300], [0, 0, 1e-300, 1e-300], 1e-300) == 1e300
    huge = np.array([1.7e308, -1.7e308, 1.7e308, -1.7e308])
    t = np.linspace(0, 1, 3000)
    assert abs(evaluate(huge, clamped(4, 3), t)).max() <= 1.7e308


def test_a_number_that_sympy_cannot_place():
    zero = sympy.sin(1) ** 2 + sympy.cos(1) ** 2 - 1
    for t in (zero, zero + 1, zero + 2):
        for call in (
            lambda t=t: evaluate([0, 1, 2], [0, 0, 1, 2, 2], t),
            lambda t=t: basis([0, 0, 1, 2, 2], 1, [1, t]),
            lambda t=t: insert([0, 1, 2], [0, 0, 1, 2, 2], t),
        ):
            rejects(call, "it cannot be compared with the knots")


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("m", [3, 30000])
def test_arrays_that_need_no_reading_are_searched(bad, m):
    points, knots, t = np.array(POINTS, float), np.array(KNOTS, float), np.full(m, 0.5)
    t[2] = bad
    for call in (partial(evaluate, points, knots, t), partial(derivative, points, knots, t, span=3)):
        assert message(call) == f"parameter t[2] is {float(bad)!r}: a finite real number is needed"
    rejects(lambda: evaluate(points, knots, t[:0]), "empty")
    points[1, 1] = bad
    rejects(lambda: evaluate(points, knots, t[3:] if m > 3 else t[:1]), "control point b_1")
