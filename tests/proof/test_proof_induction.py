"""Induction on the limit of a partial sum; bounds of linear forms."""

import pytest
from sympy import Rational, Sum, oo

from bezteach.proof import Budget, counterexample, prove, statement
from bezteach.proof.equations.induction import by_induction
from bezteach.proof.terms.linear import least
from bezteach.symbolic import i, j, k, n, t


@pytest.mark.parametrize(
    ("lhs", "rhs", "ranges"),
    [
        (Sum(k, (k, 0, n)), n * (n + 1) / 2, {}),
        (Sum(k**2, (k, 1, n)), n * (n + 1) * (2 * n + 1) / 6, {n: (1, oo)}),
        ((1 - t) * Sum(t**k, (k, 0, n)), 1 - t ** (n + 1), {}),
        (Sum(2**k, (k, i, n)), 2 ** (n + 1) - 2**i, {i: (0, n)}),
    ],
)
def test_partial_sums(lhs, rhs, ranges):
    proof = by_induction(statement(lhs, rhs, ranges), Budget(10))
    assert (proof.status, proof.method) == ("PROVED", "induction") and "from" in proof.note
    assert prove(lhs, rhs, given=ranges).status == "PROVED"


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (Sum(k, (k, 0, n)), n * (n - 1) / 2),
        (Sum(k, (k, 1, n)) + 1, n * (n + 1) / 2),
        (Sum(k, (k, 0, n)), n * (n + 1) / 2 + Rational(1, 10**9)),
        ((1 - t) * Sum(t**k, (k, 0, n)), 1 - t**n),
        (Sum(k * n, (k, 0, n)), n * (n + 1) / 2),
    ],
)
def test_false_ones_are_refuted_never_proved(lhs, rhs):
    claim = statement(lhs, rhs)
    assert by_induction(claim, Budget(10)) is None
    assert counterexample(claim, Budget(5)).counterexample is not None


@pytest.mark.parametrize(
    ("form", "conditions", "bound"),
    [
        (n, [n], 0),
        (n - i, [i, n - i], 0),
        (n - i - j, [i, j, n - i], -oo),
        (2 * n - i, [i, n - i], 0),
        (i, [2 * i - 1], 1),
        (n, [], -oo),
        (n * i, [n, i], -oo),
        (i - 5, [i - 7, 3 - i], oo),
        (n - 1, [n - i, i - 2], 1),
    ],
)
def test_least_value_of_a_linear_form(form, conditions, bound):
    assert least(form, conditions) == bound
