"""A question on the screen: choose or type an answer, press Check, read what is said to it."""

from difflib import get_close_matches
from html import escape

import ipywidgets as widgets

from ..questions import QUESTIONS, Choice, judge
from .panel import Panel

_WIDE = widgets.Layout(width="auto", max_width="46em")


def ask(name):
    """The question of this name (``questions.QUESTIONS``) as a panel; ``.answer`` and ``.check`` are its controls.

    ``ValueError`` names the nearest questions when there is none.
    """
    if name not in QUESTIONS:
        near = ", ".join(get_close_matches(name, QUESTIONS)) or ", ".join(QUESTIONS)
        raise ValueError(f"there is no question {name!r}; there is {near}")
    question = QUESTIONS[name]
    answer = _control(question)
    check, said = widgets.Button(description="Check"), widgets.HTML()

    def show(_=None):
        right, feedback = judge(question, answer.value)
        sign = {True: "✓", False: "✗", None: "…"}[right]
        said.value = f"<span role='status'><b>{sign}</b> {escape(feedback)}</span>"

    check.on_click(show)
    if not isinstance(question, Choice):
        answer.observe(show, "value")
    panel = Panel(
        [widgets.HTML(f"<b>{escape(question.text)}</b>"), answer, widgets.HBox([check, said])],
        text=lambda: question.text,
        static=lambda: {"text/html": _printed(question)},
    )
    panel.answer, panel.check, panel.said = answer, check, said
    return panel


def _control(question):
    if isinstance(question, Choice):
        return widgets.RadioButtons(options=list(question.options), value=None, layout=_WIDE)
    return widgets.Text(placeholder=f"like {question.example}", continuous_update=False, layout=_WIDE)


def _printed(question):
    lines = [f"<p><b>{escape(question.text)}</b></p>"]
    if isinstance(question, Choice):
        lines += ["<ul>", *[f"<li>{escape(option)}</li>" for option in question.options], "</ul>"]
    return "".join(lines)
