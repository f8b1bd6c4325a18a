"""Questions, derivations and the bench as widgets: what they show follows what the reader does."""

from html import escape

import pytest

from bezteach import questions, symbolic, widgets
from bezteach.symbolic import j, n, t


def test_the_bench_proves_what_is_typed():
    bench = widgets.bench("sum(B(i,n,t), i, 0, n) = 1")
    assert bench.said.value == ""
    bench.judge.click()
    assert "PROVED" in bench.said.value and "the difference of both sides" in bench.said.value
    bench.statement.value = "sum(B(i,n,t), i, 1, n) = 1"
    bench.judge.click()
    assert "REFUTED" in bench.said.value and "n = 0" in bench.said.value


def test_the_bench_judges_a_derivation_line_by_line():
    bench = widgets.bench("u B(i,n,u)\n= (i+1)/n * B(i+1,n+1,u)", "n >= 1, 0 <= i <= n")
    bench.judge.click()
    assert "line 2 is the first wrong one" in bench.said.value


@pytest.mark.parametrize(
    ("typed", "said"), [("t(", "character"), ("<b>t</b>", "&lt;"), ("", "nothing is written"), ("t", "no statement")]
)
def test_the_bench_says_what_it_cannot_read(typed, said):
    bench = widgets.bench(typed)
    bench.judge.click()
    assert "cannot be read" in bench.said.value and said in bench.said.value and "<b>t" not in bench.said.value
    assert not bench.judge.disabled


def test_a_choice_is_judged_when_check_is_pressed():
    panel = widgets.ask("splitting/local-parameter")
    assert panel.answer.value is None and panel.said.value == ""
    panel.check.click()
    assert "Not answered yet" in panel.said.value
    panel.answer.value = "1/4"
    panel.check.click()
    assert "✗" in panel.said.value and "1/3" not in panel.said.value
    panel.answer.value = "1/3"
    panel.check.click()
    assert "✓" in panel.said.value


def test_an_entry_is_judged_and_never_executed_or_shown_unescaped():
    panel = widgets.ask("splitting/exercise-cut-point")
    panel.answer.value = "(3/2, 15/8)"
    assert "✓" in panel.said.value
    panel.answer.value = "<script>alert(1)</script>"
    assert "…" in panel.said.value and "<script" not in panel.said.value


@pytest.mark.parametrize("name", questions.QUESTIONS)
def test_a_printout_shows_every_question_without_its_answer(name):
    question = questions.QUESTIONS[name]
    bundle = widgets.ask(name)._repr_mimebundle_()
    assert bundle["text/plain"] == question.text
    assert escape(question.text.split(":")[0]) in bundle["text/html"]
    if isinstance(question, questions.Entry):
        assert "<li>" not in bundle["text/html"]
    else:
        assert bundle["text/html"].count("<li>") == len(question.options)
        assert question.options[question.right] not in bundle["text/html"]


def test_an_unknown_question_names_the_nearest():
    with pytest.raises(ValueError, match="there is no question 'splitting/rates'; there is splitting/rate"):
        widgets.ask("splitting/rates")


def test_a_derivation_is_walked_line_by_line():
    steps = symbolic.segment.steps(n, j, 0, t)
    panel = widgets.walk(steps)

    def lines():
        return panel.lines.value.count("<div")

    assert lines() == 1 and panel.back.disabled
    panel.next.click()
    assert lines() == 2 and not panel.back.disabled
    assert "a step is linear in its parameter" in panel.lines.value
    panel.back.click()
    assert lines() == 1
    panel.all.click()
    assert lines() == len(steps) and panel.next.disabled
    panel.next.click()
    assert lines() == len(steps)


def test_a_printout_shows_the_whole_derivation():
    steps = symbolic.segment.steps(n, j, 0, t)
    bundle = widgets.walk(steps)._repr_mimebundle_()
    assert bundle["text/latex"] == steps._repr_latex_()
    assert bundle["text/plain"] == repr(steps)
