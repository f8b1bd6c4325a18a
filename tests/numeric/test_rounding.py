"""Measured rounding errors are what exact fractions say, and counts what the loops do."""

from fractions import Fraction as F

import pytest

import bezteach as bz
from bezteach.numeric import rounding

WAYS = {"Bernstein sum": rounding.bernstein_sum, "de Casteljau": rounding.casteljau}


@pytest.mark.parametrize("way", WAYS.values(), ids=WAYS)
@pytest.mark.parametrize("n", [0, 1, 2, 3, 7])
@pytest.mark.parametrize("t", [0, F(1, 3), 1, F(-5, 2), 4])
def test_each_way_gives_the_value_in_exact_numbers(way, n, t):
    for polygon in rounding.POLYGONS.values():
        heights = polygon(n)
        value = bz.evaluate(heights, t)
        assert way(heights, t) == value == rounding.horner(list(bz.to_power(heights)), t)


def test_casteljau_is_the_numeric_mirror_s_in_doubles():
    for t in rounding.INSIDE:
        heights = [float(height) for height in rounding.POLYGONS["uneven"](12)]
        assert rounding.casteljau(heights, t) == bz.de_casteljau(heights, t)[-1][0]


@pytest.mark.parametrize("n", [1, 2, 3, 10, 50])
def test_multiplications_by_formula(n):
    assert list(rounding.multiplications(n).values()) == [n, 5 * n + 1, n * (n + 1)]


def test_worst_is_0_for_a_way_without_error_and_known_for_a_wrong_one():
    assert rounding.worst(lambda heights, t: [0] * len(t), [0, 1], parameters=(0.0, 1.0)) == (1, 1)
    assert rounding.worst(rounding.casteljau, [1, 2, 3], "line", (0.0, 0.5, 1.0)) == (0, 0, 0)

    def late(heights, t):
        return rounding.casteljau(heights, t) + 0.25

    assert rounding.worst(late, [4], "line", (0.0, 0.5, 1.0)) == (1 / 16,)


def test_only_the_power_basis_fails_inside_and_only_outside_the_others():
    inside = {name: sizes[-1] for name, sizes in rounding.measured([50], "uneven").items()}
    assert inside.pop("power basis, Horner") > 1000 and max(inside.values()) < 1e-14
    assert rounding.measured([50], "line")["power basis, Horner"][0] < rounding.UNIT
    outside = {name: sizes[-1] for name, sizes in rounding.measured([50], "line", rounding.OUTSIDE).items()}
    assert "Woźny and Chudy" not in outside
    assert outside.pop("power basis, Horner") < 1e-15 and min(outside.values()) > 1000


@pytest.mark.parametrize(("value", "text"), [(1, "10^0"), (0.5, "10^0"), (1e-16, "10^-16"), (1.1, "10^1"), (0, "0")])
def test_power_of_ten_rounds_up(value, text):
    assert rounding.power_of_ten(value) == text
