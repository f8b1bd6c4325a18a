"""The ranges of letters, written as inequalities: read, or refused in words, at their place."""

import pytest
from sympy import (
    Interval,
    Rational,
    oo,
)

from bezteach.parsing import InvalidAnswer, parse_given
from bezteach.symbolic import i, j, k, n, t, u

F = Rational


GIVEN = {
    "n>=1": {n: (1, oo)},
    "n > 1": {n: (2, oo)},
    "1 <= n": {n: (1, oo)},
    "0<=i<=n": {i: (0, n)},
    "n >= i >= 0": {i: (0, n)},
    "i < n": {i: (0, n - 1)},
    "0 < i < n": {i: (1, n - 1)},
    "i < n/2": {i: (0, (n - 1) / 2)},
    "n > i/2": {n: ((i + 1) / 2, oo)},
    "i < n/2 + k/3 + 1": {i: (0, n / 2 + k / 3 + F(5, 6))},
    "i <= n-1": {i: (0, n - 1)},
    "n >= i": {n: (i, oo)},
    "n>=1, 0<=t<=1": {n: (1, oo), t: Interval(0, 1)},
    "n>=1 and 0<=t<=1": {n: (1, oo), t: Interval(0, 1)},
    "n >= 1, 0 <= i <= n": {n: (1, oo), i: (0, n)},
    "n>=1, n>=2, n<=9, n<=7": {n: (2, 7)},
    "n = 3": {n: (3, 3)},
    "t > 0": {t: Interval.open(0, oo)},
    "t <= 1/2": {t: Interval(-oo, F(1, 2))},
    "0 < t < 1": {t: Interval.open(0, 1)},
    "0<=t<=1, t<1": {t: Interval.Ropen(0, 1)},
    "-1 ≤ u ≤ 0.5": {u: Interval(-1, F(1, 2))},
    r"0 \le t \le 1": {t: Interval(0, 1)},
    "n>=1,": {n: (1, oo)},
    "0<=i<=j, 0<=j<=n": {i: (0, j), j: (0, n)},
}


@pytest.mark.parametrize("text", GIVEN)
def test_ranges_are_read(text):
    result = parse_given(text)
    assert result == GIVEN[text]
    assert list(result) == list(GIVEN[text])


@pytest.mark.parametrize(
    ("text", "position", "fragment"),
    [
        ("", 1, "nothing is written"),
        ("n", 1, "a range has a sign"),
        ("1 <= 2", 1, "one letter"),
        ("2n >= 1", 1, "one letter"),
        ("0 <= 2i <= n", 6, "one letter"),
        ("n >= 1 i >= 2", 6, "a comma between two ranges"),
        ("n >= 1\ni >= 2", 6, "a comma between two ranges"),
        ("E > 1", 1, "one letter"),
        ("b[0] > 1", 1, "one letter"),
        ("0<=t>=1", 5, "different directions"),
        ("0<=t=1", 5, "different directions"),
        ("0<=i<=j<=n", 8, "too many signs"),
        ("n >= -1", 6, "never below 0"),
        ("n >= 1/2", 6, "whole number"),
        ("n >= t", 6, "t is none"),
        ("n <= 401", 6, "up to 400"),
        ("n <= n", 6, "n itself"),
        ("i < 1/(n+1)", 5, "i < a quotient by letters is not read: write <= here"),
        ("n < 0", 5, "no n is in this range"),
        ("n > 5, n <= 3", 13, "no n is in this range"),
        ("0 < t < 0", 9, "no t is in this range"),
        ("1 <= t <= 0", 11, "no t is in this range"),
        ("t = 1/2", 5, "t is only 1/2"),
        ("t <= a", 6, "limits of t are numbers"),
        ("t <= sqrt(2)", 6, "limits of t are numbers"),
        ("t <= (1, 2)", 6, "a number or a short formula"),
        ("n >= m, n >= i", 14, "two limits"),
        ("i <= n, n <= i", 1, "depend on each other"),
        ("i<=j, j<=k, k<=i", 1, "depend on each other"),
        ("n >= 1 or t < 1", 8, "comma"),
        ("t in [0, 1]", 3, "0 <= t <= 1"),
        ("n >= 1)", 7, "not opened"),
        ("n >=", 5, "too early"),
        ("n != 1", 3, "!= is not read"),
        ("n < oo", 5, "not a number"),
        (",".join(["n>=1"] * 65), 321, "64 items"),
    ],
)
def test_ranges_that_are_none_are_refused(text, position, fragment):
    with pytest.raises(InvalidAnswer) as caught:
        parse_given(text)
    assert (caught.value.position, fragment in str(caught.value)) == (position, True), str(caught.value)
