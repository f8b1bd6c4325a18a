"""The board beside a question for control points: what is found by dragging is pasted as an answer."""

from math import lcm

from bezteach.widgets.board import Board
from bezteach.widgets.board.blocks import Block
from bezteach.widgets.board.svg import room
from bezteach.widgets.board.words import blocks

from .kinds import written

UP = 2  # how high the polygon to begin with goes up and down


def board_for(id, position):
    """A board with as many points as a right position (pairs of Fractions), on whose grid and in whose view it is.

    >>> board_for("03-basis-properties/dip", ((0, 1), (1, -1), (2, 1))).points
    ((Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 1), Fraction(2, 1)), (Fraction(2, 1), Fraction(0, 1)))
    """
    start = [(place, UP * (place % 2)) for place in range(len(position))]
    grid = lcm(*(coordinate.denominator for point in position for coordinate in point))

    def said(state):
        return [*blocks(state), Block("To paste", ((f'check("{id}", {written(state.points)})',),))]

    return Board(start, show=("polygon", "curve"), grid=f"1/{grid}", view=room([*start, *position]), blocks=said)
