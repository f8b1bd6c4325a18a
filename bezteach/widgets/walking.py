"""A derivation line by line, at the pace of the class: one more line with each press of a button."""

from html import escape

import ipywidgets as widgets

from .panel import Panel


def walk(derivation):
    """Show the lines of a derivation (``symbolic.Derivation``) one after another, each with its reason.

    ``.next``, ``.back`` and ``.all`` are the buttons. A stored notebook and a printout show every line.
    """
    shown = [1]
    lines = widgets.HTMLMath(layout=widgets.Layout(min_height=f"{2.9 * len(derivation)}em", overflow="auto"))
    buttons = [widgets.Button(description=word) for word in ("Next line", "Back", "All lines")]

    def go(count):
        shown[0] = min(max(count, 1), len(derivation))
        lines.value = "".join(map(_line, derivation[: shown[0]]))
        forward, back, everything = buttons
        forward.disabled = everything.disabled = shown[0] == len(derivation)
        back.disabled = shown[0] == 1

    for button, count in zip(
        buttons, (lambda: shown[0] + 1, lambda: shown[0] - 1, lambda: len(derivation)), strict=True
    ):
        button.on_click(lambda _, count=count: go(count()))
    go(1)
    panel = Panel(
        [widgets.HBox(buttons), lines],
        text=lambda: repr(derivation),
        static=lambda: {"text/latex": derivation._repr_latex_()},
    )
    panel.next, panel.back, panel.all, panel.lines = *buttons, lines
    return panel


def _line(step):
    formula = escape(f"$\\displaystyle {step.latex()}$")
    return (
        f"<div style='margin:0.7em 0; font-size:115%'>{formula}"
        f"<span style='margin-left:1.5em; font-size:80%; opacity:0.8'>{escape(step.reason)}</span></div>"
    )
