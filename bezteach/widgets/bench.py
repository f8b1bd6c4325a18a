"""The proof bench: type a statement or a derivation, press Judge, read the verdict with its proof or counterexample."""

from html import escape

import ipywidgets as widgets

from ..bench import judge
from ..parsing import InvalidAnswer
from ..proof import Verdict
from ..symbolic import Derivation
from .panel import Panel

_WIDE = widgets.Layout(width="auto", max_width="60em")


def bench(text="", given=""):
    """A place to state an identity, or a derivation line by line, and to have it judged for every n.

    ``.statement`` and ``.given`` take the text, ``.judge`` is the button, ``.said`` shows the verdict.
    """
    rows = max(text.count("\n") + 1, 3)
    statement = widgets.Textarea(value=text, rows=rows, layout=_WIDE, placeholder="sum(B(i,n,t), i, 0, n) = 1")
    ranges = widgets.Text(value=given, layout=_WIDE, placeholder="n >= 1, 0 <= i <= n, 0 <= t <= 1")
    button, said = widgets.Button(description="Judge", button_style="primary"), widgets.HTMLMath()

    def show(_=None):
        button.disabled, said.value = True, "<i>judging …</i>"
        try:
            said.value = _written(judge(statement.value, ranges.value))
        except InvalidAnswer as error:
            said.value = f"<span role='status'><b>cannot be read:</b> {escape(str(error))}</span>"
        finally:
            button.disabled = False

    button.on_click(show)
    panel = Panel(
        [
            _labelled("A statement in one line, or a derivation, one line below the other", statement),
            _labelled("Where the letters range (what is left out: whole numbers from 0, all real numbers)", ranges),
            button,
            said,
        ],
        text=lambda: f"Judge: {statement.value or '(nothing yet)'}" + f"   given {ranges.value}" * bool(ranges.value),
        static=lambda: {},
    )
    panel.statement, panel.given, panel.judge, panel.said = statement, ranges, button, said
    return panel


def _labelled(words, control):
    return widgets.VBox([widgets.HTML(f"<label>{escape(words)}</label>"), control])


def _written(verdict):
    """A verdict as HTML with formulas: what was understood, the status, and the proof or the counterexample."""
    parts = [_formula(verdict._repr_latex_())]
    if isinstance(verdict, Verdict) and verdict.steps:
        parts.append(_formula(Derivation(verdict.steps)._repr_latex_()))
    return "".join(parts)


def _formula(latex):
    return f"<div role='status' style='margin:0.7em 0; overflow-x:auto'>{escape(latex)}</div>"
