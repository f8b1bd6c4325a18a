"""Explorers, questions and derivations as widgets: what they show follows what the reader does."""

import re
from fractions import Fraction as F
from xml.etree import ElementTree

import pytest

from bezteach import questions, symbolic, widgets
from bezteach.examples import EXAMPLES
from bezteach.symbolic import j, n, t
from bezteach.widgets.basis_explorer import basis_view
from bezteach.widgets.explorers import segment_view, split_view

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
SVG = "{http://www.w3.org/2000/svg}"


def test_split_explorer_starts_at_the_slide_s_example():
    explorer = widgets.explore_split(CUBIC)
    assert repr(explorer) == (
        "t = 1/3: cut at (1, 5/3); left (0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3); "
        "right (1, 5/3), (5/3, 19/9), (7/3, 5/3), (3, 3)"
    )


def test_moving_the_slider_changes_picture_readout_and_words():
    explorer = widgets.explore_split(CUBIC)
    image, readout = explorer.children[1].children
    before = image.value
    explorer.controls["t"].value = F(1, 2)
    assert image.value != before
    assert "(3/2, 15/8)" in readout.value and "(1, 5/3)" not in readout.value
    assert explorer.text.startswith("t = 1/2: cut at (3/2, 15/8)")


def test_segment_explorer_shows_both_local_parameters():
    explorer = widgets.explore_segment(ARCH)
    readout = explorer.children[1].children[1].value
    assert "(-9/2, 27/8), (-3/2, 39/8), (3/2, 39/8), (9/2, 27/8)" in readout
    assert re.findall(r"<b>(\d/\d)</b>", readout) == ["1/3", "2/3"]


def test_the_goal_is_recognised_when_it_is_reached():
    goal = questions.GOALS["splitting/middle-edge"]
    explorer = widgets.explore_segment(ARCH, goal=goal)
    assert goal.text in explorer.text
    explorer.controls["a"].value, explorer.controls["b"].value = F(1, 3), F(2, 3)
    assert goal.praise in explorer.text and goal.text not in explorer.text


def test_basis_explorer_shows_exact_values_and_their_sum():
    explorer = widgets.explore_basis()
    assert repr(explorer) == "n = 3, t = 1/3: B₀ = 8/27, B₁ = 4/9, B₂ = 2/9, B₃ = 1/27; sum 1"
    explorer.controls["n"].value, explorer.controls["t"].value = 2, F(1, 2)
    assert repr(explorer) == "n = 2, t = 1/2: B₀ = 1/4, B₁ = 1/2, B₂ = 1/4; sum 1"
    assert "<td style=padding-right:1em>1/2</td>" in explorer.children[1].children[1].value


def test_basis_explorer_marks_the_values_on_the_graphs():
    view = basis_view(2, F(1, 2))
    (x0, y0), (x1, y1), (_, y2) = dots(view["svg"])
    (_, bottom), (_, top) = dots(basis_view(1, F(1))["svg"])
    assert x0 == x1 and y0 == y2
    assert [(bottom - y) / (bottom - top) for y in (y0, y1)] == pytest.approx([1 / 4, 1 / 2], abs=1e-3)
    assert ElementTree.fromstring(view["svg"]).attrib["aria-label"] == view["text"]


@pytest.mark.parametrize("n", range(7))
def test_every_degree_is_drawn_also_at_the_ends(n):
    for where in (F(0), F(1, 3), F(1)):
        view = basis_view(n, where)
        assert len(dots(view["svg"])) == n + 1 and "nan" not in view["svg"] and view["text"].endswith("sum 1")


def test_a_degree_that_the_slider_does_not_have_is_refused():
    with pytest.raises(ValueError, match="n = 7: the slider stops from 0 to 6"):
        widgets.explore_basis(7)


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


@pytest.mark.parametrize("where", [F(0), F(1, 24), F(1)])
def test_every_view_is_drawn_also_at_the_ends_and_for_degenerate_points(where):
    for points in (CUBIC, [(0, 0)], [(1, 1)] * 4, [(0, 0), (1, 0), (2, 0)], [(0, 0), (0, 5)]):
        for view in (
            split_view(points, where),
            segment_view(points, where, F(1, 2)),
            segment_view(points, where, where),
        ):
            tree = ElementTree.fromstring(view["svg"])
            assert tree.attrib["aria-label"] == view["text"]
            assert "nan" not in view["svg"]


def dots(svg):
    """The marked points of a picture in picture coordinates."""
    return [(float(c.attrib["cx"]), float(c.attrib["cy"])) for c in ElementTree.fromstring(svg).iter(f"{SVG}circle")]


def test_the_picture_keeps_ratios_and_puts_up_upwards():
    """The four points of the dotted polygon come first: x and y have one scale, and y grows upwards."""
    (x0, y0), (x1, y1), (_, y2), (x3, _) = dots(split_view(CUBIC, F(1, 3))["svg"])[:4]
    unit = (x3 - x0) / 3
    assert unit > 0
    assert x1 - x0 == pytest.approx(unit, abs=0.2)
    assert y0 - y1 == pytest.approx(3 * unit, abs=0.2)
    assert y0 - y2 == pytest.approx(unit, abs=0.2)


@pytest.mark.parametrize("bad", [F(1, 5), F(-1, 24), 2, F(25, 24)])
def test_a_start_that_the_slider_does_not_have_is_refused(bad):
    with pytest.raises(ValueError, match=r"the slider stops at multiples of 1/24"):
        widgets.explore_split(CUBIC, bad)


def test_a_stored_notebook_shows_the_picture_in_words_and_as_svg():
    explorer = widgets.explore_split(CUBIC)
    bundle = explorer._repr_mimebundle_()
    assert bundle["text/plain"] == explorer.text
    assert bundle["image/svg+xml"].startswith("<svg ")
    assert "application/vnd.jupyter.widget-view+json" in bundle


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
    assert question.text.split(":")[0].replace("'", "&#x27;") in bundle["text/html"]
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
