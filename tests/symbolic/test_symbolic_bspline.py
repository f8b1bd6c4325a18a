"""Pieces, derivatives and blossoms against SymPy's own B-splines, the numeric mirror and differentiation."""

import pytest
from sympy import QQ, Add, Rational, Symbol, bspline_basis, expand, field, oo, symbols
from sympy.abc import t

from bezteach.numeric import bspline as arrays
from bezteach.symbolic import b, bspline

a, c, d, e, f, g = symbols("a c d e f g", real=True)
VALUES = dict(zip((a, c, d, e, f, g), (-1, 0, Rational(1, 2), 2, 3, Rational(7, 2)), strict=True))
KNOTS = {
    "uniform": range(9),
    "any": [-3, -2, Rational(-1, 2), 0, Rational(1, 3), 2, 3, 7, 8],
    "double": [0, 1, 1, 2, 3, 3, 5, 6, 8],
    "triple and clamped": [0, 0, 0, 1, 1, 1, 2, 4, 4],
}
SYMBOLIC = {"simple": (a, c, d, e, f, g), "double": (a, a, c, d, d, e), "triple": (a, c, c, c, e, f)}


def spans(knots):
    return [k for k in range(len(knots) - 1) if knots[k] != knots[k + 1]]


def indices(knots, p):
    return range(len(knots) - p - 1)


def inside(knots, k, p):
    """p + 1 parameters strictly within a span: as many as determine its polynomial."""
    return [knots[k] + (knots[k + 1] - knots[k]) * Rational(j, p + 2) for j in range(1, p + 2)]


@pytest.mark.parametrize("name", KNOTS)
@pytest.mark.parametrize("p", range(5))
def test_pieces_are_those_of_sympys_own_b_splines(name, p):
    knots = list(KNOTS[name])[: p + 3]
    for i in indices(knots, p):
        if knots[i] == knots[i + p + 1]:
            assert bspline.N(i, p, knots, t).subs(t, knots[i]) == 0
            continue
        own, theirs = bspline.N(i, p, knots, t), bspline_basis(p, tuple(knots), i, t)
        for k in spans(knots):
            piece = bspline.piece(i, p, knots, t, k)
            for at in inside(knots, k, p):
                assert piece.subs(t, at) == theirs.subs(t, at)
            assert own.subs(t, at) == piece.subs(t, at)
        for at in (knots[0] - 1, knots[-1] + 1):
            assert own.subs(t, at) == 0


@pytest.mark.parametrize("p", range(1, 5))
def test_at_a_knot_a_function_is_its_limit_from_the_right(p):
    knots = KNOTS["double"]
    for at in sorted(set(knots[p : -p - 1])):
        expected = arrays.basis(knots, p, at)
        assert [bspline.N(i, p, knots, t).subs(t, at) for i in indices(knots, p)] == list(expected)


@pytest.mark.parametrize("name", SYMBOLIC)
@pytest.mark.parametrize("p", range(5))
def test_symbolic_knots_give_the_numeric_ones(name, p):
    knots = SYMBOLIC[name]
    numbers = [VALUES[knot] for knot in knots]
    for i in indices(knots, p):
        for k in spans(knots):
            found = bspline.piece(i, p, knots, t, k).subs(VALUES)
            assert expand(found - bspline.piece(i, p, numbers, t, k)) == 0
            assert found.subs(t, sum(inside(numbers, k, 0))) >= 0


def put_in(line, knots, p, k):
    """A line with the pieces for the names of the lower functions."""
    names = {Symbol(f"N_{{{i},{p}}}"): Add(*bspline.terms(i, p, knots, t, k)) for i in indices(knots, p)}
    return line.subs(names).doit()


@pytest.mark.parametrize("name", SYMBOLIC)
@pytest.mark.parametrize("p", range(1, 5))
def test_every_line_equals_the_first(name, p):
    knots = SYMBOLIC[name]
    lines = [
        (derivation, k)
        for k in spans(knots)
        for i in indices(knots, p)
        for derivation in (bspline.piece.steps(i, p, knots, t, k), bspline.derivative_piece.steps(i, p, knots, t, k))
    ]
    for derivation, k in lines:
        first, *others = (put_in(step.expression, knots, p - 1, k).subs(VALUES) for step in derivation)
        assert [expand(line - first) for line in others] == [0, 0]


@pytest.mark.parametrize("p", range(1, 4))
def test_the_derivative_formula_is_the_derivative(p):
    """As rational functions of the knots and t, on every span; the test above has degree 4 with numbers."""
    knots, functions = SYMBOLIC["simple"], QQ.frac_field(*SYMBOLIC["simple"], t)
    for k in spans(knots):
        for i in indices(knots, p):
            piece = functions.from_sympy(bspline.piece(i, p, knots, t, k))
            formula = functions.from_sympy(bspline.derivative_piece(i, p, knots, t, k))
            assert piece.diff(functions.gens[-1]) - formula == 0


def test_two_pieces_as_they_are_printed():
    """The second is a sum of two ways down; derivations for a lesson have three lines and name what they define."""
    assert bspline.piece(0, 2, (a, c, d, e), t, 0) == (t - a) ** 2 / ((c - a) * (d - a))
    second = (t - a) * (d - t) / ((d - a) * (d - c)) + (e - t) * (t - c) / ((e - c) * (d - c))
    assert bspline.piece(0, 2, (a, c, d, e), t, 1) == second
    steps = bspline.piece.steps(0, 2, (a, c, d, e), t, 1)
    assert steps[0].left == Symbol("N_{0,2}") and [step.left for step in steps[1:]] == [None, None]
    assert steps[0].expression == (t - a) / (d - a) * Symbol("N_{0,1}") + (e - t) / (e - c) * Symbol("N_{1,1}")
    assert len(bspline.N.steps(0, 2, (a, c, d, e), t)) == 4
    assert bspline.piece.steps(0, 0, (a, c), t, 0).result == 1


@pytest.mark.parametrize("p", range(1, 5))
def test_the_affine_steps_are_the_blossom_of_the_polynomial(p):
    """``polar`` makes the blossom from the powers, without any knot."""
    knots, k = [0, 0, 1, 1, 2, 4, 5, 5, 7, 8][4 - p : 6 + p], p
    arguments = symbols(f"u1:{p + 1}")
    found = bspline.blossom(p, knots, k, arguments)
    curve = Add(*[bspline.piece(i, p, knots, t, k) * b[i] for i in range(k - p, k + 1)])
    assert expand(found - bspline.polar(expand(curve), p, t, arguments)) == 0
    assert expand(found.subs(dict.fromkeys(arguments, t)) - curve) == 0
    for other in (arguments[::-1], arguments[1:] + arguments[:1]):
        assert expand(found - bspline.blossom(p, knots, k, other)) == 0
    for i in range(k - p, k + 1):
        assert bspline.blossom(p, knots, k, knots[i + 1 : i + p + 1]) == b[i]


def test_the_blossom_in_symbolic_knots_is_symmetric():
    """Over the field of fractions of the knots: the order of the arguments says nothing."""
    _, *knots, u, v, w, x, y, z, s = field("k0:6,u,v,w,x,y,z,s", QQ)
    levels = [[x, y, z, s]]
    for argument in (u, v, w):
        levels.append(bspline.affine_step(levels[-1], knots, 2, argument))
    turned = [x, y, z, s]
    for argument in (w, u, v):
        turned = bspline.affine_step(turned, knots, 2, argument)
    assert levels[-1] == turned
    assert [len(level) for level in levels] == [4, 3, 2, 1]


def test_polar_form_of_a_power():
    u, v, w = symbols("u v w")
    assert expand(bspline.polar(t**2, 3, t, [u, v, w]) - (u * v + u * w + v * w) / 3) == 0
    assert bspline.polar(t - t, 2, t, [u, v]) == 0 and bspline.polar(7 + 0 * t, 0, t, []) == 7


def test_steps_of_the_blossom_name_each_level():
    steps = bspline.blossom.steps(2, (0, 0, 0, 1, 1, 1), 2, [t, t])
    assert [str(step.left) for step in steps] == ["d_{1}^{1}", "d_{2}^{1}", "f(t, t)"]
    assert expand(steps.result - ((1 - t) ** 2 * b[0] + 2 * t * (1 - t) * b[1] + t**2 * b[2])) == 0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: bspline.N(0, -1, (a, c), t), "degree p is -1: with 2 knots"),
        (lambda: bspline.N(1, 0, (a, c), t), "index i is 1: .* from 0 to 0"),
        (lambda: bspline.N(0, Rational(1), (a, c, d), t), "degree p is 1"),
        (lambda: bspline.piece(0, 0, (a, c), t, 1), "span 1: with 2 knots the spans are 0 to 0"),
        (lambda: bspline.N(0, 1, (0, 2, 1), t), "knots decrease: t_2 = 1 follows t_1 = 2"),
        (lambda: bspline.N(0, 1, (a, c, a), t), "knots decrease: t_2 = a follows t_1 = c"),
        (lambda: bspline.derivative_piece(0, 0, (a, c), t, 0), "the derivative formula is for p >= 1"),
        (lambda: bspline.blossom(1, (a, c, d, e), 0, [t]), "span 0, degree 1, 4 knots"),
        (lambda: bspline.blossom(1, (a, c, d, e), 2, [t]), "span 2, degree 1, 4 knots"),
        (lambda: bspline.blossom(1, (a, c, c, e), 1, [t]), "span 1 is empty: both its ends are c"),
        (lambda: bspline.blossom(1, (a, c, d, e), 1, [t, t]), "degree 1 has 1 arguments: 2 are given"),
        (lambda: bspline.polar(t**3, 2, t, [a, c]), "degree <= 2 and 2 arguments"),
        (lambda: bspline.polar(t, 2, t, [a]), "with 1 arguments"),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_a_function_whose_knots_are_all_one_is_zero():
    assert bspline.N(0, 1, (c, c, c), t).subs({c: 1, t: 1}) == 0
    assert bspline.N(0, 0, (c, c), t).subs({c: 1}).subs(t, oo) == 0
