"""For a teacher who uses nbgrader: its own commands hand our homework out, and grade a good and a bad answer to it."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from bezteach.homework.notebook import notebook
from bezteach.homework.sets import SETS, data_of

NAME = "08-splitting"
STEPS = """
import json, sys
from nbgrader.api import Gradebook
from nbgrader.apps.api import NbGraderAPI
from traitlets.config import Config

config = Config()
config.CourseDirectory.root = sys.argv[1]
api = NbGraderAPI(config=config)
for step in json.loads(sys.argv[2]):
    done = api.generate_assignment("week") if step == "generate" else api.autograde("week", step)
    assert done["success"], done["log"]
with Gradebook(f"sqlite:///{sys.argv[1]}/gradebook.db") as book:
    print(json.dumps({one.student.id: [one.score, one.max_score] for one in book.assignment_submissions("week")}))
"""


def nbgrader(course, *steps):
    """The scores, {student: [score, most]}, after nbgrader has made these steps."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])  # it calls alembic by name
    run = [sys.executable, "-c", STEPS, str(course), json.dumps(steps)]
    done = subprocess.run(run, cwd=course, env={**os.environ, "PATH": path}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    course = tmp_path_factory.mktemp("course")
    source = course / "source" / "week" / f"{NAME}.ipynb"
    source.parent.mkdir(parents=True)
    source.write_text(notebook(NAME), encoding="utf-8")
    nbgrader(course, "generate")
    return course


def submit(course, student, answers):
    """What a student hands in: the released notebook with {short name: source of an answer} written into it."""
    text = (course / "release" / "week" / f"{NAME}.ipynb").read_text(encoding="utf-8")
    book = json.loads(text)
    for cell in book["cells"]:
        for short, answer in answers.items():
            if "".join(cell["source"]) == f'check("{NAME}/{short}", ...)':
                cell["source"] = f'check("{NAME}/{short}", {answer})'
    place = course / "submitted" / student / "week" / f"{NAME}.ipynb"
    place.parent.mkdir(parents=True)
    place.write_text(json.dumps(book), encoding="utf-8")


def test_what_is_released_is_the_blank_notebook(course):
    released = json.loads((course / "release" / "week" / f"{NAME}.ipynb").read_text(encoding="utf-8"))
    blank = json.loads(notebook(NAME))
    assert ["".join(cell["source"]) for cell in released["cells"]] == [cell["source"] for cell in blank["cells"]]


def test_right_answers_have_all_points_and_bad_ones_those_they_earn(course):
    data = data_of(NAME)
    answers = {short: question.solution(data) for short, question in SETS[NAME].questions.items()}
    words = ("formula", "unity")
    submit(course, "good", {short: repr(one) if short in words else one for short, one in answers.items()})
    in_part = '"(0, 0), (1/3, 1), (2/3, 1), (1, 5/3)"'
    submit(course, "bad", {"local": "1/3", "left": in_part, "point": "no Python(", "last-weight": "1/0"})
    most = len(SETS[NAME].questions)
    assert nbgrader(course, "good", "bad") == {"good": [most, most], "bad": [1.5, most]}
