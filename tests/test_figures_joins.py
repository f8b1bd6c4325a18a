"""Pictures of splines: which pieces move, and where the curvature jumps."""

import re
from fractions import Fraction as F

import numpy as np
import pytest

from bezteach import figures
from bezteach.numeric.joins import catmull_rom, natural

DATA = ((0, 0), (2, 5), (6, 6), (8, -1), (12, 0), (14, 5), (18, 6))
MOVED = figures.reach(DATA, 3, (8, 2))


def thick(axes):
    return [line for line in axes.get_lines() if line.get_linewidth() == 4.5]


def test_four_pieces_of_the_one_sixth_rule_move_and_all_of_the_natural_spline():
    local, other = MOVED.axes
    assert (len(thick(local)), len(thick(other))) == (4, 6)
    ends = [np.column_stack(line.get_data())[[0, -1]].tolist() for line in thick(local)]
    assert ends == [[[2, 5], [6, 6]], [[6, 6], [8, 2]], [[8, 2], [12, 0]], [[12, 0], [14, 5]]]


def test_both_rules_are_drawn_to_one_scale():
    local, other = MOVED.axes
    MOVED.draw_without_rendering()
    assert (local.get_xlim(), local.get_ylim()) == (other.get_xlim(), other.get_ylim())
    assert local.bbox.bounds[1:] == pytest.approx(other.bbox.bounds[1:])
    heights = [axes.title.get_window_extent().y0 for axes in MOVED.axes]
    assert heights[0] == pytest.approx(heights[1])


def test_it_says_how_many_and_whence():
    label = MOVED.get_label()
    assert "from (8, -1) to (8, 2)" in label
    assert "4 move by the one-sixth rule and 6 move by the natural spline" in label


def test_a_point_at_the_end_moves_two_pieces():
    assert len(thick(figures.reach(DATA, 0, (0, 1)).axes[0])) == 2


def test_curvature_jumps_without_c2_and_not_with_it():
    label = figures.curvatures({"one-sixth rule": catmull_rom(DATA), "natural spline": natural(DATA)}).get_label()
    one, other = (float(jump) for jump in re.findall(r"largest jump is ([-+.e0-9]*[0-9])", label))
    assert one > 0.1
    assert other < 1e-12


def test_curvature_is_drawn_piece_after_piece():
    circle_like = [((0, 0), (0, F(1, 2)), (1, 1), (2, 1)), ((2, 1), (3, 1), (4, 1), (5, 1))]
    first, second, _ = figures.curvatures({"two cubics": circle_like}).axes[0].get_lines()
    assert np.allclose(second.get_ydata(), 0)
    assert first.get_xdata()[-1] == second.get_xdata()[0] == 1
    assert (first.get_ydata() <= 0).all() and first.get_ydata()[0] < 0  # it turns right
