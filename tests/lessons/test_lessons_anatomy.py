"""What every numbered lesson has: a question first, abilities with their exercises, predictions, a task, an end."""

import re

import pytest

from bezteach import questions
from bezteach.lessons import ROOT, parsed

LESSONS = sorted((ROOT / "lessons").glob("[0-9][0-9]-*.ipynb"))
HEADINGS = ("You will be able to", "Before you begin", "When it breaks", "Remember", "Exercises", "Where it comes from")

every_lesson = pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)


def cells(path):
    return [(cell.cell_type, cell.source) for cell in parsed(path.read_text(encoding="utf-8")).cells]


def prose(path):
    return "\n\n".join(source for kind, source in cells(path) if kind == "markdown")


def code(path):
    return "\n".join(source for kind, source in cells(path) if kind == "code")


def section(path, heading):
    """The cells from a heading to the next one, as one text."""
    whole = "\n\n".join(source for _, source in cells(path))
    return re.split(rf"^## +(?:\d+ +)?{heading}.*$", whole, flags=re.M)[1].split("\n## ")[0]


@every_lesson
def test_the_first_screen_asks_and_can_be_moved(path):
    (first, opening), *rest = cells(path)
    shown = [source for kind, source in rest[:4] if kind == "code"]
    assert first == "markdown" and opening.startswith(f"# {path.stem[:2]} ") and "?" in opening
    assert shown[0].startswith(("from ", "import ")) and "widgets." in shown[1]


@every_lesson
def test_nothing_of_the_anatomy_is_missing_and_its_order_holds(path):
    text = prose(path)
    places = [re.search(rf"^## +(?:\d+ +)?{heading}", text, flags=re.M) for heading in HEADINGS]
    assert all(places) and [place.start() for place in places] == sorted(place.start() for place in places)


@every_lesson
def test_three_to_five_abilities_are_tested_by_exercises(path):
    abilities = re.findall(r"^\d\. .*?(?=^\d\. |^$|\Z)", section(path, "You will be able to"), flags=re.M | re.S)
    assert 3 <= len(abilities) <= 5
    assert all("exercise" in ability for ability in abilities)


@every_lesson
def test_questions_come_before_answers(path):
    assert section(path, "Before you begin").count("widgets.ask(") >= 2
    between = code(path)
    asked = re.findall(r'widgets\.ask\("([^"]+)"\)', between)
    assert len([name for name in asked if "/exercise" not in name]) >= 3 + (path.stem != "00-start") * 2
    assert set(asked) <= set(questions.QUESTIONS) and len(asked) == len(set(asked))


@every_lesson
def test_a_task_is_recognised(path):
    assert re.search(r'GOALS\["[^"]+"\]', code(path))


@every_lesson
def test_five_exercises_or_more_and_three_lines_to_remember(path):
    exercises = section(path, "Exercises")
    assert exercises.count("/exercise-") + len(re.findall(r"^\*\*Exercise \d+", exercises, flags=re.M)) >= 5
    assert "(proof)" in exercises and "(open)" in exercises and "<details>" in exercises
    assert len(re.findall(r"^- ", section(path, "Remember"), flags=re.M)) == 3


def test_each_question_and_task_of_a_lesson_is_asked_in_it():
    everything = "\n".join(map(code, LESSONS))
    assert [name for name in questions.QUESTIONS if f'"{name}"' not in everything] == []
    assert [name for name in questions.GOALS if f'"{name}"' not in everything] == []
