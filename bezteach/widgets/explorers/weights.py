"""A rational curve whose one weight is a slider: the point at t is pulled, and at one weight a circle comes out."""

from fractions import Fraction
from typing import NamedTuple

import numpy as np

from ...display import number, point
from ...numeric import evaluate, rational
from ..board import Board, svg
from ..board.blocks import Block, cells, exact_array, name_of
from ..board.marks import STYLES, Mark, Style, rows
from ..board.state import exact
from .presets import TARGET
from .sliders import beside, slider

STOPS = (*(Fraction(k, 4) for k in range(9)), Fraction(5, 2), *map(Fraction, (3, 4, 6, 8, 16)))
SEEN = np.linspace(0, 1, 97)
PLAIN, ROUND = Style("quiet", 3, dash="9 6"), Style("second", 1.6, dash="2 6")
RAY = Style("ink", 1)


class Weighted(NamedTuple):
    """What a goal judges: control points, their weights, and the parameter."""

    points: tuple
    weights: tuple
    t: Fraction


def explore_weights(points, weights, of, t=Fraction(1, 2), circle=False, target=None, goal=None, **settings):
    """The curve of points with weights, with sliders for the weight of b_of and for t; the polynomial one is dashed.

    ``points``: exact, shape (n+1, 2); ``weights``: exact, those of the ends positive and none negative; ``of`` counts
    from 0, and its weight is a stop of the slider ``.controls["w"]``; ``.controls["t"]`` has the parameter. With
    ``circle`` the unit circle is drawn and x² + y² is said; a ``target`` is a place marked by a square. A ``goal`` is a
    task for a ``Weighted``. Further settings are those of ``Board``, which is ``.board``; there a new last point has
    the weight 1. ``ValueError`` names what does not fit. Source: transcript, outlook; Farin, Curves and Surfaces for
    CAGD.
    """
    given = weights_of(weights, len(points))
    if of not in range(len(points)):
        raise ValueError(f"there is no control point b_{of}: there are b_0 to b_{len(points) - 1}")
    inner = 0 < of < len(points) - 1
    controls = {
        "w": slider(given[of], f"w, the weight of {name_of(of)}", STOPS if inner else STOPS[1:]),
        "t": slider(exact(t, "t"), "t"),
    }

    def current(state):
        now = carried((*given[:of], controls["w"].value, *given[of + 1 :]), len(state.points))
        return Weighted(state.points, now, controls["t"].value)

    task = goal and goal._replace(reached=lambda state: goal.reached(current(state)))
    layers = ("polygon",)
    aims = [] if target is None else place_marks(target)
    board = Board(
        points,
        goal=task,
        blocks=lambda state: weight_blocks(current(state), circle),
        marks=lambda state: [*weight_marks(current(state), of, circle), *aims],
        **{"show": layers, "offer": layers, "view": svg.room([*points, (0, 0)] if circle else points)} | settings,
    )
    for control in controls.values():
        control.observe(lambda _: board.refresh(), "value")
    return beside(board, controls)


def weights_of(given, count):
    """Exact weights for so many points; ``ValueError`` names a wrong number of them, a sign that is not allowed."""
    weights = tuple(exact(w, f"weight w_{i}") for i, w in enumerate(given))
    if len(weights) != count:
        raise ValueError(f"{count} control points and {len(weights)} weights: each point needs one weight")
    for i, w in enumerate(weights):
        if w < 0 or (w == 0 and i in (0, count - 1)):
            raise ValueError(f"weight w_{i} is {w}: the ends need positive weights, and none may be negative")
    return weights


def carried(weights, count):
    """The weights for so many points: those at the same places, and 1 for points beyond."""
    return (*weights[:count], *[Fraction(1)] * (count - len(weights)))


def place_marks(place):
    """A square with its name at a place that the curve is to pass."""
    return [Mark("squares", rows([place]), TARGET), Mark("names", rows([place]), TARGET, (point(place),))]


def weight_blocks(state, circle):
    """What is said: the weights, the lifted point and the point at t, and where the polynomial curve is."""
    t, points = state.t, exact_array(state.points)
    said = [
        Block("Weights", cells(list(map(number, state.weights)))),
        Block(f"At t = {number(t)}", tuple(point_said(points, state, circle))),
        Block("Dashed: all weights equal", ((f"at t = {number(t)}", point(evaluate(points, t))),)),
    ]
    if circle:
        whole = rational.on_unit_circle(points, state.weights)
        verdict = "x² + y² = 1 for every t" if whole else "x² + y² is not 1 for every t"
        said.append(Block("On the unit circle (dotted)", ((verdict,),)))
    return said


def point_said(points, state, circle):
    """The rows on the point at t."""
    above = evaluate(rational.lift(points, state.weights), state.t)
    yield "one dimension up", point(above)
    if not above[-1]:
        yield "no point", "the weight of this end is 0"
        return
    place = rational.project(above)
    yield "divided", point(place)
    if circle:
        yield "x² + y²", number(place @ place)


def weight_marks(state, of, circle):
    """What is painted under the polygon: the circle, both curves, the point at t and the line that it is pulled on."""
    points, weights = np.array(state.points, dtype=float), np.array(state.weights, dtype=float)
    seen = SEEN if weights[-1] else SEEN[:-1]  # no weight is negative: only an end may have no point
    marks = [Mark("circle", ((0, 0), (1, 0)), ROUND)] if circle else []
    marks += [
        Mark("curve", rows(points), PLAIN),
        Mark("line", rows(rational.evaluate(points, weights, seen)), STYLES["curve"]),
    ]
    if weights[-1] or state.t < 1:
        place = rational.evaluate(points, weights, float(state.t))
        marks.append(Mark("dots", rows([place]), STYLES["point"]))
        marks += [Mark("line", rows([place, points[of]]), RAY)] if of < len(points) else []
    return marks
