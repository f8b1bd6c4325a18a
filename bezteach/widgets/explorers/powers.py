"""One polynomial in two bases: drag its Bernstein coefficients, and they pull the graph; drag those of the powers."""

import ipywidgets as widgets

from ... import numeric
from ...display import image, number
from ..board import Board, svg
from ..board.blocks import Block
from ..board.marks import STYLES, Mark
from ..panel import Panel
from .quartic import AXIS


def explore_powers(heights=(0, 1, 0, 1)):
    """Two boards side by side, for the graph of one polynomial on [0, 1].

    On the left its Bernstein coefficients, given as ``heights``, stand over 0, 1/n, ..., 1 and can be dragged; on the
    right the coefficients of 1, t, ..., t^n. What moves on one moves on the other: ``.board`` and ``.powers``. A view
    grows with its points, and is the first one again when they are back at the start.
    """
    board = Board(
        graph(heights),
        **KEPT,
        view=_view(heights),
        marks=lambda state: [AXIS],
        blocks=lambda state: [_coefficients("of B₀, B₁, ...", state.points)],
    )
    powers = Board(
        power_points(board.points),
        **KEPT | {"show": ()},
        view=_view(heights, [y for _, y in power_points(board.points)]),
        letter="a",
        blocks=lambda state: [_coefficients("of 1, t, t², ...", state.points)],
        marks=lambda state: [AXIS, Mark("curve", board.points, STYLES["curve"]), *_stems(state.points)],
    )

    def follow(change):
        if power_points(board.points) != powers.points:
            powers.points = power_points(board.points)

    def lead(change):
        if bernstein_points(powers.points) != board.points:
            board.points = bernstein_points(powers.points)
        powers.refresh()

    first = [(some, some.points, some.view) for some in (board, powers)]

    def fit(change):
        for some, points, view in first:
            some.view = view if some.points == points else _grown(some)

    board.observe(follow, "state")
    powers.observe(lead, "state")
    for some in (board, powers):
        some.observe(fit, "state")
    titled = [
        widgets.VBox([widgets.HTML(f"<b>{title}</b>"), some], layout=widgets.Layout(flex="1 1 24em", min_width="0"))
        for title, some in (("Bernstein coefficients", board), ("Power coefficients", powers))
    ]
    panel = Panel(
        [widgets.HBox(titled, layout=widgets.Layout(flex_flow="row wrap"))],
        text=lambda: f"{board.text}; {powers.text}",
        static=lambda: {"text/html": image(board.svg, board.text) + image(powers.svg, powers.text)},
    )
    panel.board, panel.powers = board, powers
    return panel


KEPT = {"show": ("polygon", "curve"), "offer": ("polygon", "curve"), "grid": "1/4", "vertical": True}


def graph(heights):
    """Control points of the graph of a polynomial with these Bernstein coefficients."""
    places = numeric.from_power([0, 1, *[0] * (len(heights) - 2)])
    return tuple(zip(places, heights, strict=True))


def power_points(points):
    """The coefficients of the powers, standing over the same places."""
    return graph(numeric.to_power([y for _, y in points]))


def bernstein_points(points):
    """The Bernstein coefficients for coefficients of the powers."""
    return graph(numeric.from_power([y for _, y in points]))


def _coefficients(name, points):
    return Block(f"Coefficients {name}", (tuple(number(y) for _, y in points),))


def _stems(points):
    return [Mark("line", ((x, 0), (x, y)), STYLES["box"]) for x, y in points]


def _view(*heights):
    x0, y0, x1, y1 = svg.room([(0, -1), (1, 1), *((0, y) for some in heights for y in some)])
    return (-0.1, y0, 1.1, y1)


def _grown(board):
    """The view of a board, with room for points that left it."""
    low, high = board.view[1], board.view[3]
    if all(low <= y <= high for _, y in board.points):
        return board.view
    return list(_view([low, high, *(y for _, y in board.points)]))
