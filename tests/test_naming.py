"""Names stand off the polygon: on the outer side of a corner, across a straight line."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bezteach.naming import outward

PLACE = st.tuples(st.integers(-9, 9), st.integers(-9, 9))


@pytest.mark.parametrize(
    ("points", "middle"),
    [
        ([(0, 0), (1, 1), (2, 0)], (0, 1)),  # a peak
        ([(0, 0), (4, 4), (5, 3)], (0, 1)),  # lengths do not count
        ([(0, 0), (1, 0), (4, 0)], (0, 1)),  # straight on: above
        ([(4, 0), (1, 0), (0, 0)], (0, 1)),
        ([(0, 0), (0, 1), (0, 4)], (1, 0)),  # upright: to the right
        ([(0, 4), (0, 1), (0, 0)], (1, 0)),
        ([(0, 0), (2, 0), (1, 0)], (1, 0)),  # it turns back
        ([(1, 1), (1, 1), (1, 1)], (0, 1)),  # nowhere to stand off
        ([(0, 0), (0, 0), (1, 0)], (-1, 0)),  # one neighbour is here too
    ],
)
def test_the_name_of_the_middle_point(points, middle):
    assert np.allclose(outward(points)[1], middle)


def test_a_point_alone_has_its_name_above():
    assert outward([(3, 4)]).tolist() == [[0, 1]]


@given(st.lists(PLACE, min_size=2, max_size=6))
def test_names_stand_off_by_one_and_away_from_every_neighbour(points):
    ways = outward(points)
    assert np.allclose(np.hypot(*ways.T), 1)
    for i, way in enumerate(ways):
        near = [np.subtract(points[j], points[i]) for j in (i - 1, i + 1) if 0 <= j < len(points)]
        units = [vector / np.hypot(*vector) for vector in near if vector.any()]
        assert sum(way @ unit for unit in units) <= 1e-9
