"""What goes in and what comes out: shapes, kinds of numbers, ownership, and a one-line error for each bad input."""

import re
from decimal import Decimal
from fractions import Fraction as F
from functools import partial
from inspect import ismodule

import numpy as np
import pytest
import sympy

import bezteach.numeric as numeric
from bezteach.numeric import (
    bernstein,
    curvature,
    de_casteljau,
    derivative,
    elevate,
    evaluate,
    evaluate_accurate,
    flatten,
    from_power,
    hodograph,
    sample,
    segment,
    split,
    subdivide,
    to_power,
)

DECK = [[0, 0], [1, 3], [2, 1], [3, 3]]

# Every function of control points, as a function of them alone.
OF_POINTS = {
    "evaluate": lambda p: evaluate(p, F(1, 3)),
    "evaluate_accurate": lambda p: evaluate_accurate(p, F(1, 3)),
    "sample": lambda p: sample(p, 5),
    "de_casteljau": lambda p: de_casteljau(p, F(1, 3)),
    "split": lambda p: split(p, F(1, 3)),
    "segment": lambda p: segment(p, F(1, 3), F(1, 2)),
    "hodograph": hodograph,
    "hodograph 0": lambda p: hodograph(p, 0),
    "hodograph 9": lambda p: hodograph(p, 9),
    "derivative": lambda p: derivative(p, F(1, 3)),
    "curvature": lambda p: curvature(p, F(1, 3)),
    "elevate": elevate,
    "elevate 0": lambda p: elevate(p, 0),
    "to_power": to_power,
    "from_power": from_power,
    "subdivide": lambda p: subdivide(p, 2),
    "subdivide 0": lambda p: subdivide(p, 0),
    "flatten": lambda p: flatten(p, F(1, 10)),
}
# Every function of a parameter, as a function of it alone.
OF_PARAMETER = {
    "bernstein": lambda t: bernstein(3, t),
    "evaluate": lambda t: evaluate(DECK, t),
    "evaluate_accurate": lambda t: evaluate_accurate(DECK, t),
    "derivative": lambda t: derivative(DECK, t),
    "curvature": lambda t: curvature(DECK, t),
}
OF_SCALAR = {
    "de_casteljau": lambda t: de_casteljau(DECK, t),
    "split": lambda t: split(DECK, t),
    "segment a": lambda t: segment(DECK, t, 1),
    "segment b": lambda t: segment(DECK, 0, t),
}
of_points = pytest.mark.parametrize("function", OF_POINTS.values(), ids=OF_POINTS)
of_parameter = pytest.mark.parametrize("function", OF_PARAMETER.values(), ids=OF_PARAMETER)
of_any_parameter = pytest.mark.parametrize(
    "function", [*OF_PARAMETER.values(), *OF_SCALAR.values()], ids=[*OF_PARAMETER, *OF_SCALAR]
)


def parts(result):
    return list(result) if isinstance(result, tuple) else [result]


def leaves(result):
    return [x for part in parts(result) for x in np.asarray(part).ravel().tolist()]


def rejects(call, *words):
    """A ValueError of one line with these words in it, and nothing else."""
    with pytest.raises(ValueError) as caught:
        call()
    message = str(caught.value)
    assert type(caught.value) is ValueError and "\n" not in message and len(message) < 200
    for word in words:
        assert word in message, message


def test_what_is_exported():
    assert sorted(numeric.__all__) == numeric.__all__
    offered = [getattr(numeric, name) for name in numeric.__all__]
    assert all(one.__doc__ and (callable(one) or ismodule(one)) for one in offered)


# Shapes

CURVE, LINE = np.array(DECK), np.array([0, 3, 1, 3])
BATCH = np.stack([CURVE, CURVE[::-1], CURVE + 1, 2 * CURVE, CURVE - 3])


@pytest.mark.parametrize("kind", [float, int])
@pytest.mark.parametrize("shape", [(), (1,), (6,), (2, 3), (1, 2, 2)])
def test_shapes_of_functions_of_t(kind, shape):
    t = np.linspace(0, 1, int(np.prod(shape))).reshape(shape) if kind is float else np.ones(shape, int)
    for f in (evaluate, evaluate_accurate, derivative):
        assert np.shape(f(LINE.astype(kind), t)) == shape
        assert f(CURVE.astype(kind), t).shape == (*shape, 2)
        assert f(BATCH.astype(kind), t).shape == (5, *shape, 2)
    assert np.shape(curvature(CURVE.astype(kind), t)) == shape
    assert curvature(BATCH.astype(kind), t).shape == (5, *shape)
    assert bernstein(3, t).shape == (*shape, 4) and bernstein(0, t).shape == (*shape, 1)


@pytest.mark.parametrize("kind", [float, int])
@pytest.mark.parametrize("points, lead, last", [(LINE, (), ()), (CURVE, (), (2,)), (BATCH, (5,), (2,))])
def test_shapes_of_functions_of_points(kind, points, lead, last):
    points = points.astype(kind)
    assert [level.shape for level in de_casteljau(points, 1)] == [(*lead, k, *last) for k in (4, 3, 2, 1)]
    assert [half.shape for half in split(points, 1)] == [(*lead, 4, *last)] * 2
    assert segment(points, 0, 1).shape == to_power(points).shape == from_power(points).shape == (*lead, 4, *last)
    assert [hodograph(points, r).shape for r in (0, 1, 3, 4, 9)] == [(*lead, k, *last) for k in (4, 3, 1, 1, 1)]
    assert [elevate(points, r).shape for r in (0, 1, 3)] == [(*lead, k, *last) for k in (4, 5, 7)]
    assert [subdivide(points, k).shape for k in (0, 1, 3)] == [(*lead, k, 4, *last) for k in (1, 2, 8)]
    assert sample(points, 7).shape == (*lead, 7, *last)
    assert flatten(points, 10**6).shape == (*lead, 2, *last)
    assert sample(points[..., :1, :] if last else points[:1], 2).shape == (*lead, 2, *last)


def test_a_batch_is_its_curves_one_by_one():
    for name, f in OF_POINTS.items():
        if name != "flatten":
            for kind in (float, object):
                batch = parts(f(BATCH.astype(kind)))
                single = [parts(f(curve)) for curve in BATCH.astype(kind)]
                for k, part in enumerate(batch):
                    for one, many in zip(single, part, strict=True):
                        if kind is object:
                            assert np.array_equal(one[k], many)
                        else:
                            np.testing.assert_allclose(many, one[k], rtol=1e-14, atol=1e-14)
    lines = flatten(BATCH, F(1, 50))
    assert len(lines[0]) == max(len(flatten(curve, F(1, 50))) for curve in BATCH)


# Kinds of numbers


@of_points
@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int64, np.uint64, object])
def test_integers_stay_exact_and_become_python_numbers(function, dtype):
    for x in leaves(function(np.array(DECK, dtype))):
        assert type(x) in (int, F) or function is OF_POINTS["curvature"]


@of_points
@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64, np.longdouble, ">f8"])
def test_a_float_array_gives_float64(function, dtype):
    assert {part.dtype for part in parts(function(np.array(DECK, dtype)))} == {np.dtype(float)}


@of_points
@pytest.mark.parametrize("x", [0.5, np.float32(0.5), np.longdouble(0.5), sympy.Float(0.5), np.array(0.5)])
def test_one_float_makes_everything_float64(function, x):
    points = [[0, 0], (np.int8(1), F(3)), [sympy.Integer(2), x], np.array([3, 3])]
    assert {part.dtype for part in parts(function(points))} == {np.dtype(float)}


@of_any_parameter
@pytest.mark.parametrize("x", [0.5, np.float16(0.5), np.longdouble(0.5), sympy.Float(0.5), np.array(0.5)])
def test_a_float_parameter_makes_everything_float64(function, x):
    assert {np.asarray(part).dtype for part in parts(function(x))} == {np.dtype(float)}


@of_any_parameter
@pytest.mark.parametrize("x", [1, np.int8(1), F(1, 2), F(np.int64(1), np.int64(2)), np.array(1)])
def test_exact_parameters_give_exact_results(function, x):
    for value in leaves(function(x)):
        assert type(value) in (int, F) or function is OF_PARAMETER["curvature"]
        if type(value) is F:
            assert type(value.numerator) is type(value.denominator) is int


def test_nothing_overflows():
    big = np.array([2**62, -(2**62), 2**62], np.int64)
    assert hodograph(big).tolist() == [-(2**64), 2**64]
    assert to_power(big).tolist() == [2**62, -(2**64), 2**64]
    assert evaluate(big, np.int8(100)) == 2**62 * (99**2 + 2 * 99 * 100 + 100**2)
    assert curvature([[0, 0], [10**400, 0], [10**400, 10**400]], 0) == 0.0
    assert curvature([[0, 0], [F(1, 10**200), 0], [F(1, 10**200), F(1, 10**200)]], 0) == 5e199


def test_sympy_numbers_stay_exact_and_meet_floats_as_floats():
    root = sympy.sqrt(2)
    assert evaluate([0, root, 2], sympy.Rational(1, 2)) == root / 2 + sympy.Rational(1, 2)
    assert evaluate([0, root, 2], 0.5) == pytest.approx(2**0.5 / 2 + 0.5, rel=1e-15)
    assert evaluate(sympy.Matrix(DECK), F(1, 3)).tolist() == [1, F(5, 3)]
    assert evaluate([sympy.Matrix([[0, 0]])[:], (1, 2)], 1).tolist() == [1, 2]
    assert flatten([0, root, 0], F(1, 8)).tolist()[0] == 0


def test_lists_tuples_ranges_and_arrays_are_the_same_points():
    for points in (tuple(map(tuple, DECK)), [np.array(b) for b in DECK], np.array(DECK)):
        assert hodograph(points).tolist() == hodograph(DECK).tolist()
    assert hodograph(range(4)).tolist() == [3, 3, 3]
    assert evaluate([[1, 2]] * 3, 7).tolist() == [1, 2]  # the same list three times is three points


# Ownership


@of_points
@pytest.mark.parametrize("kind", [float, object])
@pytest.mark.parametrize("order", ["C", "F"])
def test_results_are_the_callers_own(function, kind, order):
    points = np.array(DECK, kind, order=order)
    first = parts(function(points))
    copies = [part.copy() for part in first]
    for part in first:
        assert not np.shares_memory(part, points)
        if part.ndim:
            part[...] = 77
    assert points.tolist() == DECK
    for again, before in zip(parts(function(points)), copies, strict=True):
        assert np.array_equal(again, before)
    if len(first) == 2:
        assert not np.shares_memory(*first)


def test_the_basis_is_the_callers_own():
    for t in ([0.5, 0.25], [F(1, 2)]):
        before = bernstein(3, t).tolist()
        bernstein(3, t)[...] = 7
        assert bernstein(3, t).tolist() == before


# Errors

x = sympy.Symbol("x")
looped, nested, deep = [1, 2], [[0, 0], [1, 1]], 0
looped.append(looped)
nested[1] = nested
for _ in range(60):
    deep = [deep]


class Odd:
    def __repr__(self):
        raise RuntimeError


NOT_NUMBERS = {
    "nan": float("nan"),
    "infinity": -np.inf,
    "float32 nan": np.float32("nan"),
    "complex": 1j,
    "complex zero": np.complex64(0),
    "text": "1",
    "bytes": b"1",
    "none": None,
    "true": True,
    "numpy false": np.False_,
    "decimal": Decimal(1),
    "date": np.datetime64("2020-01-01"),
    "object": Odd(),
    "function": len,
    "sympy oo": sympy.oo,
    "sympy zoo": sympy.zoo,
    "sympy nan": sympy.nan,
    "sympy I": sympy.I,
    "x + I": x + sympy.I,
    "sympy true": sympy.true,
    "relation": x < 1,
    "imaginary symbol": sympy.Symbol("y", imaginary=True),
    "sympy set": sympy.Interval(0, 1),
}
not_numbers = pytest.mark.parametrize("bad", NOT_NUMBERS.values(), ids=NOT_NUMBERS)


@not_numbers
def test_what_is_no_number_is_named(bad):
    for points in ([[0, 0], [1, 3], [2, bad], [3, 3]], [[0.5, 0], [1, 3], [2, bad], [3, 3]]):
        for f in OF_POINTS.values():
            name = "coefficient c_2" if f is from_power else "control point b_2"
            rejects(partial(f, points), name, "has coordinate", "finite real number")
    for f in OF_PARAMETER.values():
        rejects(partial(f, bad), "parameter t is")
        rejects(partial(f, [0, [bad][0]]), "parameter t[1] is")
    for f in OF_SCALAR.values():
        rejects(partial(f, bad), "parameter ", " is")
    rejects(lambda: flatten(DECK, bad), "tolerance")
    rejects(lambda: evaluate([0, bad], 0), "control point b_1")
    rejects(lambda: evaluate([DECK, [*DECK[:3], [bad, 0]]], 0), "control point b_3 of curve 1")


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("size", [4, 400])
def test_float_arrays_are_searched(bad, size):
    points = np.ones((size, 2))
    points[2, 1] = bad
    for f in OF_POINTS.values():
        rejects(partial(f, points), "_2 has coordinate " + repr(float(bad)))
        rejects(partial(f, points.T[1]), "_2")
    for f in OF_PARAMETER.values():
        rejects(partial(f, points[:, 1] / 2), "parameter t[2] is")


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("n", [0, 1, 2, 3, 4, 40])
@pytest.mark.parametrize("m", [3, 30000])
def test_arrays_that_need_no_reading_are_searched(bad, n, m):
    points, t = np.ones((n + 1, 2)), np.full(m, 0.5)
    points[n, 1], t[2] = bad, bad
    rejects(lambda: evaluate(points, np.full(m, 0.5)), f"control point b_{n} has coordinate {float(bad)!r}")
    rejects(lambda: evaluate(np.ones((n + 1, 2)), t), f"parameter t[2] is {float(bad)!r}")
    rejects(lambda: evaluate(np.ones((n + 1, 2)), t[:0]), "empty")
    rejects(lambda: sample(points, m), f"control point b_{n} has coordinate {float(bad)!r}")


CONTAINERS = {
    "empty": [],
    "empty rows": [[], []],
    "empty array": np.ones((0, 2)),
    "no coordinates": np.ones((3, 0)),
    "ragged": [[0, 0], [1, 3, 5]],
    "ragged depth": [[0, 0], 1],
    "ragged depth first": [0, [1, 1]],
    "set": {1, 2},
    "dict": {0: 1},
    "generator": (i for i in range(3)),
    "iterator": iter([1, 2]),
    "text": "0123",
    "text array": np.array(["0", "1"]),
    "bool array": np.array([True, False]),
    "bool column": [np.array([True, False]), [1, 2]],
    "complex array": np.ones(3, complex),
    "date array": np.array(["2020-01-01", "2021-01-01"], "M8[ns]"),
    "record array": np.zeros(3, "i4,i4"),
    "masked": np.ma.array([[0.0, 0], [1, 1]], mask=[[0, 0], [0, 1]]),
    "itself": looped,
    "itself below": nested,
    "deep": deep,
    "none": None,
    "class": Odd,
    "symbolic matrix": sympy.MatrixSymbol("A", 2, 2),
}


@pytest.mark.parametrize("bad", CONTAINERS.values(), ids=CONTAINERS)
def test_what_is_no_array_of_numbers(bad):
    for f in [*OF_POINTS.values(), *OF_PARAMETER.values(), *OF_SCALAR.values(), lambda t: flatten(DECK, t)]:
        rejects(partial(f, bad))


def test_the_axes_of_points():
    for bad in (3, 0.5, F(1, 2), np.array(1.0), np.ones((1, 1, 2, 2)), [[[[1, 2]]]]):
        for f in OF_POINTS.values():
            rejects(partial(f, bad), "axes")
    for f in OF_SCALAR.values():
        rejects(partial(f, [0.5]), "parameter", "a single number")
    rejects(lambda: flatten(DECK, [0.5]), "tolerance")


@pytest.mark.parametrize("bad", [-1, 1.0, 0.5, True, np.True_, np.array(True), "1", None, F(1), [1], 10**30, 1j])
def test_whole_numbers(bad):
    for call, name in (
        (lambda: bernstein(bad, 0.5), "degree n"),
        (lambda: sample(DECK, bad), "count m"),
        (lambda: sample(np.array(DECK, float), bad), "count m"),
        (lambda: elevate(DECK, bad), "order r"),
        (lambda: subdivide(DECK, bad), "depth"),
    ):
        rejects(call, name)
    if type(bad) is not int or bad < 0:
        rejects(lambda: hodograph(DECK, bad), "order r")
        rejects(lambda: derivative(DECK, 0, bad), "order r")


def test_counts_below_two():
    for m in (0, 1):
        rejects(partial(sample, DECK, m), "count m", "2")
        rejects(partial(sample, np.array(DECK, float), m), "count m", "2")
    assert sample(DECK, np.int64(2)).tolist() == [[0, 0], [3, 3]]


@pytest.mark.parametrize("bad", [0, -1, -0.5, 0.0, F(-1, 3), x, 1e-300, F(1, 10**400)])
def test_tolerances(bad):
    rejects(lambda: flatten(DECK, bad), "tolerance")


def test_floats_beside_symbols():
    for call in (
        lambda: evaluate([0, x], 0.5),
        lambda: evaluate([0.5, x], 1),
        lambda: evaluate([0, 1.5], x),
        lambda: evaluate([0, 0.5 * x], 1),
        lambda: split([0, x], 0.5),
        lambda: bernstein(2, [x, 0.5]),
        lambda: curvature([[0, 0], [x, 1]], 0.5),
    ):
        rejects(call, "float", "fraction")
    rejects(lambda: flatten([0, x, 1], 1), "x")


def test_exact_numbers_beyond_float64():
    for call in (
        lambda: evaluate([0, 10**400], 0.5),
        lambda: evaluate([0.5, F(10) ** 400], 0),
        lambda: evaluate([0.5, sympy.exp(10000)], 0),
        lambda: evaluate([0, 1], [0.5, 10**400]),
        lambda: segment([0, 1], 0.5, -(10**5000)),
    ):
        rejects(call, "too large")
    assert evaluate([0, 10**400], F(1, 2)) == 5 * 10**399


@pytest.mark.parametrize("bad", [-1, 2, 1.5, -1e-300, np.nextafter(1, 2), F(4, 3), sympy.sqrt(2), sympy.Integer(-1)])
def test_accurate_values_are_for_the_unit_interval(bad):
    rejects(lambda: evaluate_accurate(DECK, bad), "parameter t is", "[0, 1]")
    rejects(lambda: evaluate_accurate(DECK, [0, bad]), "[0, 1]")
    assert evaluate_accurate([0, 1], sympy.sqrt(2) / 2).equals(sympy.sqrt(2) / 2)


def test_curvature_needs_the_plane_or_space_and_a_tangent():
    for points in ([0, 1, 2], [[0], [1]], [[0, 0, 0, 0], [1, 1, 1, 1]]):
        rejects(partial(curvature, points, 0), "2 or 3")
    for kind in (int, float):
        cusp = np.array([[0, 0], [1, 1], [0, 1], [1, 0]], kind)
        rejects(partial(curvature, cusp, [0, F(1, 2)] if kind is int else 0.5), "p'(t) = 0", "t = ")
        rejects(partial(curvature, np.ones((4, 3), kind), 0), "p'(t) = 0")
        rejects(partial(curvature, np.ones((1, 2), kind), 0), "p'(t) = 0")
        rejects(partial(curvature, np.array([[0, 0], [0, 0], [1, 2]], kind), [1, 0]), "at t = 0")
    rejects(partial(curvature, [[x, 0], [x, 0], [1, x]], 0), "at t = 0")


def test_messages_are_exact():
    def message(call):
        with pytest.raises(ValueError, match=".") as caught:
            call()
        return str(caught.value)

    need = ": a finite real number is needed"
    points = np.array(DECK, float)
    points[2, 0] = np.nan
    assert message(lambda: hodograph(points)) == "control point b_2 has coordinate nan" + need
    assert message(lambda: evaluate(DECK, True)) == "parameter t is True" + need
    assert message(lambda: evaluate(DECK, [0, None])) == "parameter t[1] is None" + need
    assert message(lambda: sample(DECK, 1)) == "count m is 1: it must be between 2 and 100000000"
    assert message(lambda: elevate(DECK, 0.5)) == "order r is 0.5: a whole number is needed"
    assert re.fullmatch(r"tolerance is -1: .*", message(lambda: flatten(DECK, -1)))
