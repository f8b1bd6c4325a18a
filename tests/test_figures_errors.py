"""Measured rounding errors are what exact fractions say, counts are what the loops do, and pictures hold both."""

from fractions import Fraction as F

import numpy as np
import pytest

import bezteach as bz
from bezteach import figures
from bezteach.examples import EXAMPLES
from bezteach.figures import errors

CUBIC = EXAMPLES["deck/split"].given["points"]
WAYS = {"Bernstein sum": errors.bernstein_sum, "de Casteljau": errors.casteljau}


@pytest.mark.parametrize("way", WAYS.values(), ids=WAYS)
@pytest.mark.parametrize("n", [0, 1, 2, 3, 7])
@pytest.mark.parametrize("t", [0, F(1, 3), 1, F(-5, 2), 4])
def test_each_way_gives_the_value_in_exact_numbers(way, n, t):
    for polygon in errors.POLYGONS.values():
        heights = polygon(n)
        value = bz.evaluate(heights, t)
        assert way(heights, t) == value == errors.horner(list(bz.to_power(heights)), t)


def test_casteljau_is_the_numeric_mirror_s_in_doubles():
    for t in errors.INSIDE:
        heights = [float(height) for height in errors.POLYGONS["uneven"](12)]
        assert errors.casteljau(heights, t) == bz.de_casteljau(heights, t)[-1][0]


@pytest.mark.parametrize("n", [1, 2, 3, 10, 50])
def test_multiplications_by_formula(n):
    assert list(errors.multiplications(n).values()) == [n, 5 * n + 1, n * (n + 1)]


def test_worst_is_0_for_a_way_without_error_and_known_for_a_wrong_one():
    assert errors.worst(lambda heights, t: [0] * len(t), [0, 1], parameters=(0.0, 1.0)) == (1, 1)
    assert errors.worst(errors.casteljau, [1, 2, 3], "line", (0.0, 0.5, 1.0)) == (0, 0, 0)

    def late(heights, t):
        return errors.casteljau(heights, t) + 0.25

    assert errors.worst(late, [4], "line", (0.0, 0.5, 1.0)) == (1 / 16,)


def test_only_the_power_basis_fails_inside_and_only_outside_the_others():
    inside = {name: sizes[-1] for name, sizes in errors.measured([50], "uneven").items()}
    assert inside.pop("power basis, Horner") > 1000 and max(inside.values()) < 1e-14
    assert errors.measured([50], "line")["power basis, Horner"][0] < errors.UNIT
    outside = {name: sizes[-1] for name, sizes in errors.measured([50], "line", errors.OUTSIDE).items()}
    assert "Woźny and Chudy" not in outside
    assert outside.pop("power basis, Horner") < 1e-15 and min(outside.values()) > 1000


@pytest.mark.parametrize(("value", "text"), [(1, "10^0"), (0.5, "10^0"), (1e-16, "10^-16"), (1.1, "10^1"), (0, "0")])
def test_power_of_ten_rounds_up(value, text):
    assert errors.power_of_ten(value) == text


def test_error_growth_draws_what_was_measured_and_says_the_last():
    found = {"power basis, Horner": (0.0, 1e-9, 2e3), "de Casteljau": (1e-16, 2e-16, 3e-16)}
    figure = figures.error_growth([1, 2, 3], found)
    (axes,) = figure.axes
    horner, casteljau = (line for line in axes.get_lines() if len(line.get_ydata()) == 3)
    assert list(horner.get_ydata())[1:] == [1e-9, 2e3] and horner.get_ydata()[0] > 0
    assert list(casteljau.get_ydata()) == [1e-16, 2e-16, 3e-16]
    assert len({line.get_linestyle() for line in (horner, casteljau)}) == 2
    assert len({line.get_marker() for line in (horner, casteljau)}) == 2
    assert "Horner 10^4" in figure.get_label() and "de Casteljau 10^-15" in figure.get_label()


def test_lower_curves_meet_the_level_before_the_last():
    figure = figures.lower_curves(CUBIC, F(1, 3))
    (axes,) = figure.axes
    *_, before, last = EXAMPLES["deck/split"].answer["triangle"]
    drawn = [np.column_stack(line.get_data()) for line in axes.get_lines()]
    for level in (before, last):
        assert any(line.shape == np.shape(level) and np.allclose(line, np.array(level, dtype=float)) for line in drawn)
    first, second = (line for line in drawn if len(line) > 4 and np.abs(np.diff(line, 3, axis=0)).max() < 1e-12)
    assert np.allclose([first[0], first[-1], second[0], second[-1]], [CUBIC[i] for i in (0, 2, 1, 3)])
    assert "(2/3, 13/9)" in figure.get_label() and "(1, 5/3)" in figure.get_label()
