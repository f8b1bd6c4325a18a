"""The exact tools of the arguments on B-splines, against SymPy, the numeric mirror and wrong versions."""

from fractions import Fraction as F

import pytest
from sympy import bspline_basis_set
from sympy.abc import x

from bezteach.ledger import knots as exact
from bezteach.ledger.claims import bsplines, insertion, shaping, smoothness, splines
from bezteach.numeric import bspline

CLAMPED = [F(knot) for knot in (0, 0, 0, 1, 2, 3, 3, 4, 4, 4)]
POINTS = [(0, 0), (2, 1), (4, 4), (0, 3), (4, -1), (2, 2), (5, 5)]


def test_letters_are_repeated_and_two_of_them_may_be_numbers():
    knots, t = exact.letters(2, 1, 3, zero=0, one=2)
    assert [str(knot) for knot in knots] == ["0", "0", "t1", "1", "1", "1"] and str(t) == "t"
    knots, _ = exact.one_span(2)
    assert len(knots) == len(set(map(str, knots))) == 6 and (knots[2], knots[3]) == (0, 1)
    assert (
        sorted(exact.all_multiplicities(4)) == sorted(set(exact.all_multiplicities(4)))
        and len(exact.all_multiplicities(4)) == 8
    )
    assert all(sum(times) == 4 for times in exact.all_multiplicities(4))


@pytest.mark.parametrize("p", range(5))
def test_pieces_are_those_of_sympy(p):
    """On whole knots, at two points of each span, for the first function."""
    (first, *_) = bspline_basis_set(p, tuple(range(p + 2)), x)
    _, t = exact.letters(1)
    for span in range(p + 1):
        found = exact.piece(0, p, range(p + 2), t, span).as_expr()
        for at in (span + F(1, 3), span + F(3, 5)):
            assert found.subs("t", at) == first.subs(x, at) == exact.as_printed(0, p, list(map(F, range(p + 2))), at)


def test_values_are_those_of_the_mirror():
    for span in exact.spans(CLAMPED):
        for arguments in ([F(1, 3), F(7, 2)], [F(2), F(2)]):
            expected = bspline.blossom(POINTS, CLAMPED, span, *arguments)
            assert list(exact.point(POINTS, CLAMPED, span, arguments)) == list(expected)
    inside = F(5, 2)
    assert [exact.as_printed(i, 2, CLAMPED, inside) for i in range(7)] == list(bspline.basis(CLAMPED, 2, inside))
    assert list(exact.indices(2, CLAMPED)) == list(range(7))


def test_the_power_of_t_in_an_element():
    knots, t = exact.letters(1, 1)
    assert exact.order(t**2 / (knots[0] - knots[1]) + t**5, t) == 2
    assert [exact.order(knots[0] + t, t), exact.order(0 * t, t)] == [0, None]
    with pytest.raises(ValueError, match="is no polynomial in t"):
        exact.order(knots[0] / t, t)


@pytest.mark.parametrize(("p", "m"), [(2, 1), (2, 2), (3, 2), (3, 4)])
def test_jumps_are_those_of_numbers(p, m):
    """The derivatives from both sides at a knot of multiplicity m, by the mirror."""
    knots = (
        [F(-3 * k * k - k, 2) for k in range(p + 1, 0, -1)] + [F(0)] * m + [F(k * k + 1, 3) for k in range(1, p + 2)]
    )
    orders = []
    for i in range(len(knots) - p - 1):
        unit = [int(i == place) for place in range(len(knots) - p - 1)]
        sides = [[bspline.derivative(unit, knots, 0, r, span) for r in range(p + 1)] for span in (p, p + m)]
        different = [r for r in range(p + 1) if sides[0][r] != sides[1][r]]
        orders += different[:1]
    assert orders == exact.jump_orders(p, m)


def test_what_is_computed_can_fail(monkeypatch):
    """A wrong piece, a wrong step or a wrong share is seen by the arguments that compute with it."""

    def but(wrong):
        return lambda *args: wrong(args)

    right, blossom = exact.piece, exact.blossom
    assert bsplines.sums_to_one() and insertion.old_from_new() and smoothness.neighbours_agree()
    monkeypatch.setattr(bsplines, "piece", but(lambda args: right(*args) * (2 if args[0] == 0 else 1)))
    assert not bsplines.sums_to_one()
    monkeypatch.setattr(insertion, "share", but(lambda args: F(1, 2)))
    assert not insertion.old_from_new()
    monkeypatch.setattr(smoothness, "blossom", but(lambda args: 2 * blossom(*args)))
    assert not smoothness.derivatives_are_values()


def test_knots_between_must_be_among_the_arguments():
    """With one of them missing the two blossoms differ."""
    knots, t = exact.letters(*[1] * 8, zero=2)
    sides = [[smoothness.value(2, span, unit, knots, [t, t]) for unit in range(4)] for span in (2, 3)]
    assert sides[0] != sides[1]


def test_what_the_counterexamples_say():
    assert exact.jump_orders(2, 3)[2:4] == [0, 0]
    assert splines.right_end_is_lost() and splines.shifted()
    assert shaping.touches(1) == (1, 2) and shaping.touches(F(3, 2)) == (F(3, 2), 2)
    cubic = bspline.evaluate(insertion.ZIGZAG, insertion.CLAMPED_CUBIC, 1)
    assert list(cubic) == [F(7, 2), F(3, 2)] and insertion.double_knot_of_a_cubic_is_passed_by()
