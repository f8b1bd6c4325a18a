"""No example, no printed number and no picture of the sources is without its place in the lessons."""

import pytest

from bezteach import coverage
from bezteach.examples import EXAMPLES

SHOWN = coverage.shown()


@pytest.mark.parametrize("one", SHOWN, ids=lambda one: f"{one.source}, {one.place}: {one.about}")
def test_it_is_in_a_lesson(one):
    assert one.cells


@pytest.mark.parametrize("example", EXAMPLES.values(), ids=lambda example: example.id)
def test_every_printed_number_is_named_in_a_lesson_that_uses_the_example(example):
    cells = list(coverage._cells())
    lessons = {lesson for lesson, _, source in cells if f'EXAMPLES["{example.id}"]' in source}
    beside = "\n".join(source for lesson, _, source in cells if lesson in lessons)
    assert [name for name in example.printed if f'"{name}"' not in beside] == []


def test_all_examples_and_all_pictures_are_asked_for():
    assert len(SHOWN) == len(EXAMPLES) + len(coverage.PICTURES)
    assert {one.source for one in SHOWN} == {"deck", "games", "notes", "transcript"}


def test_a_gap_is_seen(monkeypatch):
    missing = coverage.Picture("deck", "9.9", "nothing", "04", "figures.nowhere(")
    monkeypatch.setattr(coverage, "PICTURES", (missing,))
    assert [one.about for one in coverage.shown() if not one.cells] == ["nothing"]


def test_the_table_names_lesson_and_cell():
    page = coverage.table()
    (split,) = [line for line in page.text.splitlines() if "a cubic split at t = 1/3: the whole triangle" in line]
    assert split.startswith("deck, 2.3") and "(02: " in split
    assert page.markdown.count("\n") == len(SHOWN) + 1
