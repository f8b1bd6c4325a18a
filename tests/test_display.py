"""Exact numbers, points and triangles as text and as LaTeX."""

from fractions import Fraction as F

import pytest
from sympy import symbols

from bezteach import de_casteljau, display
from bezteach.symbolic import b, n, step, t


@pytest.mark.parametrize(
    ("value", "text", "latex"),
    [(3, "3", "3"), (F(-4, 2), "-2", "-2"), (F(13, 9), "13/9", r"\tfrac{13}{9}"), (F(-1, 3), "-1/3", r"-\tfrac{1}{3}")],
)
def test_numbers(value, text, latex):
    assert (display.number(value), display.number_latex(value)) == (text, latex)


def test_points_of_the_slide_s_left_half():
    shown = display.points([(0, 0), (F(1, 3), 1)], "c")
    assert repr(shown) == "c_0 = (0, 0)   c_1 = (1/3, 1)"
    assert r"c_{1} = \left(\tfrac{1}{3},\,1\right)" in shown._repr_latex_()


def test_triangle_is_laid_out_as_the_deck_prints_it():
    levels = de_casteljau([(0, 0), (1, 3), (2, 1), (3, 3)], F(1, 3))
    assert repr(display.triangle(levels)).splitlines() == [
        "(0, 0)",
        "(1, 3)  (1/3, 1)",
        "(2, 1)  (4/3, 7/3)  (2/3, 13/9)",
        "(3, 3)  (7/3, 5/3)  (5/3, 19/9)  (1, 5/3)",
    ]


def test_triangle_boxes_the_left_half_and_underlines_the_right_one():
    latex = display.triangle(de_casteljau([0, 3, 1], F(1, 3)))._repr_latex_()
    rows = latex.split(r"\\[1ex]")
    assert [row.count(r"\boxed") for row in rows] == [1, 1, 1]
    assert [row.count(r"\underline") for row in rows] == [0, 0, 3]
    assert r"\boxed{\underline{\tfrac{13}{9}}}" in rows[2]


def test_triangle_hides_what_comes_after_a_level():
    levels = de_casteljau([0, 3, 1], F(1, 3))
    assert repr(display.triangle(levels, upto=1)) == "0\n3  1\n1  7/3"
    assert repr(display.triangle(levels, upto=0)) == "0\n3\n1"


def test_formula_names_what_it_shows():
    assert display.formula(step(t) * b[0])._repr_latex_() == (
        r"$\displaystyle \left[\left(1 - t\right) + t E\right] {b}_{0}$"
    )
    assert repr(display.formula(n + 1, symbols("m"))) == "m = n + 1"


def test_lines_are_numbered_and_equal_from_the_second_on():
    assert display.lines([t * (1 - t), t - t**2])._repr_latex_() == (
        r"$\displaystyle \begin{aligned} 1. & \quad   t \left(1 - t\right) "
        r"\\[1ex] 2. & \quad = t - t^{2} \end{aligned}$"
    )
