"""What explorers with controls of their own share: sliders with exact stops beside a picture or a board."""

from fractions import Fraction

import ipywidgets as widgets

from ...display import image, number
from ..panel import Panel

STEPS = 24  # sliders stop at multiples of 1/24, so at halves, thirds, quarters, sixths and eighths
STOPS = tuple(Fraction(k, STEPS) for k in range(STEPS + 1))


def slider(value, label, stops=STOPS):
    """A slider that stops at exact numbers; ``ValueError`` names a start that is none of them."""
    if value not in stops:
        raise ValueError(f"{label.split(',')[0]} = {value}: the slider stops at {_listed(stops)}")
    return widgets.SelectionSlider(
        options=[(number(stop), stop) for stop in stops],
        value=stops[stops.index(value)],
        description=label,
        style={"description_width": "initial"},
        layout=widgets.Layout(width="26em"),
    )


def _listed(stops):
    first, second, last = stops[0], stops[1], stops[-1]
    return f"{number(first)}, {number(second)}, ..., {number(last)}"


def explorer(controls, view):
    """A panel with controls over a picture and words: ``view(**values)`` gives {"svg", "html", "text"}.

    ``controls`` maps the names of the values to widgets; they are ``.controls`` of the panel.
    """
    drawing, readout = widgets.HTML(), widgets.HTML()

    def current():
        return view(**{name: control.value for name, control in controls.items()})

    def redraw(_=None):
        shown = current()
        drawing.value = shown["svg"]
        readout.value = f'<div style="padding:0 1em; line-height:1.5">{shown["html"]}</div>'

    for control in controls.values():
        control.observe(redraw, "value")
    redraw()
    panel = Panel(
        [row(controls), widgets.HBox([drawing, readout], layout=widgets.Layout(flex_flow="row wrap"))],
        text=lambda: current()["text"],
        static=lambda: {"text/html": image(current()["svg"], current()["text"])},
    )
    panel.controls = controls
    return panel


def row(controls):
    """Controls beside each other, on several lines where there is no room."""
    return widgets.HBox(list(controls.values()), layout=widgets.Layout(flex_flow="row wrap"))


def beside(board, controls):
    """A panel with controls over a board; its words and picture are the board's."""
    panel = Panel(
        [row(controls), board],
        text=lambda: board.text,
        static=lambda: {"text/html": image(board.svg, board.text)},
    )
    panel.board, panel.controls = board, controls
    return panel
