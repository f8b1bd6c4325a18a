"""Explorers: move a control, see picture and exact numbers change; what is shown is a pure function of the state."""

from fractions import Fraction

import ipywidgets as widgets

from .. import numeric
from ..display import number, point
from ..palette import FIRST, QUIET, SECOND
from . import picture
from .panel import Panel

SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
STEPS = 24  # sliders stop at multiples of 1/24, so at halves, thirds, quarters, sixths and eighths
STOPS = [Fraction(k, STEPS) for k in range(STEPS + 1)]


def explore_split(points, t=Fraction(1, 3)):
    """Cut a curve at t: a slider, both halves, and the whole triangle in exact fractions.

    ``points``: exact, shape (n+1, 2); ``t``: a multiple of 1/24 in [0, 1]. The slider is ``.controls["t"]``.
    """
    return explorer({"t": (t, "t, where to cut")}, lambda t: split_view(points, t))


def explore_segment(points, a=Fraction(1, 4), b=Fraction(3, 4), goal=None):
    """Cut the part over [a, b] out of a curve: two sliders, the part, its exact control points; a > b runs backwards.

    ``points``: exact, shape (n+1, 2); ``a`` and ``b``: multiples of 1/24 in [0, 1], the sliders ``.controls["a"]`` and
    ``.controls["b"]``. A ``goal`` (``questions.Goal``) is a task for the part's control points.
    """
    return explorer(
        {"a": (a, "a, where the part begins"), "b": (b, "b, where it ends")},
        lambda a, b: segment_view(points, a, b, goal),
    )


def split_view(points, t):
    """What the explorer of a split shows at t: {"svg", "html", "text"}."""
    levels = numeric.de_casteljau(points, t)
    left, right = numeric.split(points, t)
    text = f"t = {number(t)}: cut at {point(left[-1])}; left {_listed(left)}; right {_listed(right)}"
    layers = [
        picture.polygon(points, QUIET, dash="2 5", names=_names("b", points)),
        *[picture.polygon(level, QUIET, width=1) for level in levels[1:-1]],
        picture.curve(left, FIRST),
        picture.curve(right, SECOND, dash="12 7"),
        picture.polygon(left, FIRST),
        picture.polygon(right, SECOND, marker="s"),
    ]
    html = (
        table("The triangle", _rows_of_triangle(levels))
        + _list("Left half (solid, circles)", left)
        + _list("Right half (dashed, squares)", right)
    )
    return {"svg": picture.picture(points, layers, text), "html": html, "text": text}


def segment_view(points, a, b, goal=None):
    """What the explorer of a part shows for [a, b]: {"svg", "html", "text"}."""
    part = numeric.segment(points, a, b)
    text = f"a = {number(a)}, b = {number(b)}: {_listed(part)}"
    layers = [
        picture.polygon(points, QUIET, dash="2 5", names=_names("b", points)),
        picture.curve(points, QUIET, width=2),
        picture.curve(part, FIRST),
        picture.polygon(part, FIRST),
    ]
    html = _list("Control points of the part", part) + _local_parameters(a, b)
    if goal is not None:
        html += f"<p role='status'><b>{goal.praise if goal.reached(part) else goal.text}</b></p>"
        text += f"; {goal.praise if goal.reached(part) else goal.text}"
    return {"svg": picture.picture(points, layers, text), "html": html, "text": text}


def explorer(settings, view):
    """A panel with a slider for each setting over a view, a function of the settings.

    A setting is {name: (value, label)}, with the slider's stops as a third if they are not the multiples of 1/24.
    """
    controls = {name: _slider(*setting) for name, setting in settings.items()}
    image, readout = widgets.HTML(), widgets.HTML()

    def current():
        return view(**{name: control.value for name, control in controls.items()})

    def redraw(_=None):
        shown = current()
        image.value, readout.value = shown["svg"], f'<div style="padding:0 1em; line-height:1.5">{shown["html"]}</div>'

    for control in controls.values():
        control.observe(redraw, "value")
    redraw()
    below = widgets.HBox([image, readout], layout=widgets.Layout(flex_flow="row wrap"))
    panel = Panel(
        [widgets.HBox(list(controls.values()), layout=widgets.Layout(flex_flow="row wrap")), below],
        text=lambda: current()["text"],
        static=lambda: {"image/svg+xml": current()["svg"]},
    )
    panel.controls = controls
    return panel


def _slider(value, label, stops=STOPS):
    if value not in stops:
        which = f"from 0 to {stops[-1]}" if stops is not STOPS else f"at multiples of 1/{STEPS} from 0 to 1"
        raise ValueError(f"{label.split(',')[0]} = {value}: the slider stops {which}")
    return widgets.SelectionSlider(
        options=[(number(stop), stop) for stop in stops],
        value=stops[stops.index(value)],
        description=label,
        style={"description_width": "initial"},
        layout=widgets.Layout(width="26em"),
    )


def _local_parameters(a, b):
    """The parameter of the second cut in either order, as the two schemes of the deck need it."""
    if not 0 < a < b < 1:
        return ""
    return (
        f"<p>Cut at b first: then at a/b = <b>{number(a / b)}</b> of the piece.<br>"
        f"Cut at a first: then at (b − a)/(1 − a) = <b>{number((b - a) / (1 - a))}</b> of the piece.</p>"
    )


def _rows_of_triangle(levels):
    return [[point(levels[k][row - k]) for k in range(row + 1)] for row in range(len(levels))]


def table(title, rows):
    cells = "".join(f"<tr>{''.join(f'<td style=padding-right:1em>{cell}</td>' for cell in row)}</tr>" for row in rows)
    return f"<b>{title}</b><table>{cells}</table>"


def _list(title, points):
    return f"<b>{title}</b><br>{_listed(points)}<br>"


def _listed(points):
    return ", ".join(map(point, points))


def _names(letter, points):
    return [letter + str(i).translate(SUBSCRIPTS) for i in range(len(points))]
