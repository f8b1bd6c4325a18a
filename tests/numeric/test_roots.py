"""Roots by signs and halving: known roots, SymPy's Sturm sequences, and what cannot be known yet."""

from fractions import Fraction as F
from itertools import pairwise
from math import comb

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import few_fractions
from sympy import Poly, Rational, Symbol, sqrt, symbols

from bezteach.numeric import roots, sign_changes
from bezteach.numeric.dyadic import halves
from bezteach.numeric.roots import Root

law = settings(deadline=None, max_examples=60, database=None)
FINE = F(1, 2**12)


def heights_of(powers):
    """Bernstein coefficients from ascending powers: t^k is the sum of the C(i,k)/C(n,k) B_{i,n}."""
    n = len(powers) - 1
    return [sum(F(comb(i, k), comb(n, k)) * c for k, c in enumerate(powers)) for i in range(n + 1)]


def multiplied(factors):
    """Ascending powers of a product."""
    product = [F(1)]
    for factor in factors:
        longer = [F(0)] * (len(product) + len(factor) - 1)
        for i, x in enumerate(product):
            for k, y in enumerate(factor):
                longer[i + k] += x * y
        product = longer
    return product


def holds(root, t):
    return root.start == t == root.end or root.start < t < root.end


# By hand


def test_the_cubic_with_the_roots_a_fifth_a_half_and_four_fifths():
    """(5t - 1)(2t - 1)(5t - 4); halved, its left part has the heights -4, 3/2, 3/4, 0."""
    assert heights_of(multiplied([[-1, 5], [-1, 2], [-4, 5]])) == [-4, 7, -7, 4]
    left, right = halves(np.array([-32, 56, -56, 32], object))
    assert (left.tolist(), right.tolist()) == ([-32, 12, 6, 0], [0, -6, -12, 32])
    assert roots([-4, 7, -7, 4], F(1, 16)) == [
        (F(3, 16), F(1, 4), True),
        (F(1, 2), F(1, 2), True),
        (F(3, 4), F(13, 16), True),
    ]


def test_two_changes_of_sign_and_a_root_twice_or_none():
    """(1 - 3t)^2 touches the axis; 1 - 4t + 5t^2 does not, which one halving shows: 1, 0, 1/4 and 1/4, 1/2, 2."""
    assert sign_changes([1, -2, 4]) == sign_changes([1, -1, 2]) == 2
    assert roots([1, -2, 4], F(1, 16)) == [(F(5, 16), F(3, 8), False)]
    assert roots([1, -1, 2], F(1, 2)) == [] and roots([1, -1, 2], 1) == [(0, 1, False)]


@pytest.mark.parametrize(
    ("heights", "found"),
    [
        ([5], []),
        ([0, 1], [0]),
        ([0.0, -1.0], [0]),
        ([1, 0], [1]),
        ([-1, 1], [F(1, 2)]),
        ([1, -1, 1], [F(1, 2)]),  # a double root
        ([-1, 1, -1, 1], [F(1, 2)]),  # a triple one
        ([0, 0, 1, 0], [0, 1]),
        ([0, 3, -1, 0], [0, F(3, 4), 1]),
        ([0, 0, 0, 0, 1], [0]),
        ([Rational(-1, 2), Rational(1, 2)], [F(1, 2)]),
    ],
)
def test_roots_at_the_ends_and_at_joints_are_met_exactly(heights, found):
    assert roots(heights) == [(t, t, True) for t in found]
    assert all(type(end) is F for root in roots(heights) for end in root[:2])


@pytest.mark.parametrize(
    ("heights", "count"), [([1], 0), ([0, 0], 0), ([1, 0, -1], 1), ([-1, 0, -1], 0), ([1, -1] * 4, 7)]
)
def test_sign_changes(heights, count):
    assert sign_changes(heights) == count == sign_changes(np.array(heights)) == sign_changes(heights[::-1])


def test_floats_count_as_the_fractions_that_they_are():
    assert roots([-0.1, 0.2, 0.3]) == roots([F(-0.1), F(0.2), F(0.3)])
    assert roots([-(10.0**-300), 10.0**300])[0].certain


def test_a_tolerance_is_kept_to_the_deepest():
    (root,) = roots([-1, 2], F(1, 2**1000))
    assert root.certain and root.end - root.start == F(1, 2**1000) and root.start < F(1, 3) < root.end
    assert roots([-1, 2], 3) == [(0, 1, True)] and roots([-1, 2], 0.3) == [(F(1, 4), F(1, 2), True)]


def test_one_large():
    """Degree 30 with the roots 1/31, ..., 30/31."""
    found = roots(heights_of(multiplied([[-k, 31] for k in range(1, 31)])))
    assert len(found) == 30 and all(map(holds, found, [F(k, 31) for k in range(1, 31)]))
    assert all(root.certain for root in found)


# Laws

places = few_fractions(0, 1, 12)
positive = st.sampled_from([[F(1)], [F(1), F(0), F(1)], [F(1), F(-1), F(1)], [F(2), F(1)], [F(-3)]])


@law
@given(st.lists(places, min_size=1, max_size=6), positive)
def test_every_root_is_in_exactly_one_answer(known, rest):
    found = roots(heights_of(multiplied([[-t, 1] for t in known] + [rest])), FINE)
    assert found == sorted(found) and all(one.end <= two.start for one, two in pairwise(found))
    for t in known:
        assert sum(holds(root, t) for root in found) == 1
    for root in found:
        assert root.end - root.start in (0, FINE)
        inside = [t for t in known if holds(root, t)]
        assert len(inside) == 1 or not root.certain or root.start == root.end and len({*inside}) == 1


@law
@given(st.sets(places, min_size=1, max_size=6), positive)
def test_single_roots_apart_are_all_certain(known, rest):
    found = roots(heights_of(multiplied([[-t, 1] for t in known] + [rest])), FINE)
    assert all(root.certain for root in found) and all(map(holds, found, sorted(known)))
    assert len(found) == len(known)


@law
@given(st.lists(st.integers(-9, 9), min_size=1, max_size=7).filter(any))
def test_sturm_s_sequences_count_the_same(heights):
    """SymPy's count, of different roots, in each interval and in all of [0, 1]."""
    t, n = Symbol("t"), len(heights) - 1
    polynomial = Poly(sum(comb(n, i) * h * t**i * (1 - t) ** (n - i) for i, h in enumerate(heights)), t)
    found = roots(heights, F(1, 2**30))
    for start, end, certain in found:
        start, end = Rational(start), Rational(end)
        ends = 0 if start == end else (polynomial.eval(start) == 0) + (polynomial.eval(end) == 0)
        assert not certain or polynomial.count_roots(start, end) - ends == 1
    different = 0 if polynomial.is_ground else polynomial.count_roots(0, 1)
    assert sum(root.certain for root in found) <= different
    if polynomial.is_ground or polynomial.is_sqf:
        assert [root.certain for root in found] == [True] * different


@law
@given(st.lists(few_fractions(-9, 9, 5), min_size=1, max_size=8).filter(any))
def test_read_backwards_the_roots_are_mirrored(heights):
    mirrored = sorted(Root(1 - root.end, 1 - root.start, root.certain) for root in roots(heights[::-1], F(1, 64)))
    assert roots(heights, F(1, 64)) == mirrored


# Refused


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: roots([0, 0, 0]), "every t is a root"),
        (lambda: roots([[0, 1], [1, 2]]), "2 axes"),
        (lambda: roots(3), "0 axes"),
        (lambda: roots([]), "empty"),
        (lambda: roots([1, float("nan")]), "b_1 has coordinate nan"),
        (lambda: roots([1, symbols("x")]), "height b_1 is x"),
        (lambda: roots([sqrt(2), -1]), "height b_0 is sqrt\\(2\\)"),
        (lambda: sign_changes([1, symbols("x")]), "height b_1 is x"),
        (lambda: roots([1, -1], 0), "tolerance is 0: a positive"),
        (lambda: roots([1, -1], -0.5), "a positive number"),
        (lambda: roots([1, -1], [1, 2]), "a positive number"),
        (lambda: roots([1, -1], symbols("x")), "a positive number"),
        (lambda: roots([1, -1], F(1, 2**1001)), "at least 2\\^-1000"),
    ],
)
def test_what_is_refused_and_the_words(call, words):
    with pytest.raises(ValueError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 200
