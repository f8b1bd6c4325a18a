"""The picture of a curve in space: the curve, its polygon, and the shadows of both."""

import numpy as np

from bezteach import figures

POINTS = ((0, 0, 0), (4, 0, 3), (4, 4, 0), (0, 4, 3))


def test_curve_and_polygon_stand_above_their_shadows():
    (axes,) = figures.space(POINTS).axes
    lines = [np.array(line.get_data_3d()) for line in axes.get_lines()]
    shadow, flat, curve, polygon = lines[:4]
    assert np.allclose(polygon.T, POINTS) and np.allclose(flat[:2], polygon[:2])
    assert np.allclose(curve[:, 32], (3, 2, 3 / 2))  # (b_0 + 3 b_1 + 3 b_2 + b_3) / 8
    assert np.allclose(shadow[:2], curve[:2]) and not shadow[2].any() and not flat[2].any()


def test_it_says_where_the_points_are():
    assert "(4, 0, 3), (4, 4, 0)" in figures.space(POINTS).get_label()
