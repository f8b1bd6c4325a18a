"""Blank homework, for the book or for a student, and the key to it."""

import ast
import json
from contextlib import redirect_stdout
from io import StringIO

import pytest

from bezteach import cli
from bezteach.grading import graded
from bezteach.homework.notebook import notebook
from bezteach.homework.sets import QUESTIONS, SETS, data_of
from bezteach.setup.workspace import lessons_source

LESSONS = lessons_source()


def told(text):
    """What the code cells of a notebook print, or give at their end, cell by cell."""
    names, printed = {}, []
    for cell in json.loads(text)["cells"]:
        if cell["cell_type"] == "code":
            *lines, last = ast.parse(cell["source"]).body
            with redirect_stdout(StringIO()) as out:
                exec(compile(ast.Module(lines, []), "cell", "exec"), names)
                result = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
            printed.append(out.getvalue().strip() + ("" if result is None else str(result)))
    return printed


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("student", [None, "Ada"])
def test_a_blank_notebook_runs_clean(name, student):
    first, *rest, last = told(notebook(name, student))
    assert last == "0"
    assert first == ("The book's numbers." if student is None else "The numbers of ada.")
    questions = SETS[name].questions.values()
    boards = [words for words in rest if "To paste: check(" in words]
    assert rest.count("… UNATTEMPTED: Not answered yet.") == len(questions)
    assert len(boards) == sum(question.position is not None for question in questions)
    asked = [words for words in rest if words not in boards and "UNATTEMPTED" not in words]
    assert asked == [question.text(data_of(name, student and "ada")) for question in questions]


@pytest.mark.parametrize("name", SETS)
def test_the_stored_notebook_is_the_blank_one(name):
    """If not: remove lessons/homework, and then bezteach homework lessons/homework and python -m bezteach.lessons."""
    stored = json.loads((LESSONS / "homework" / f"{name}.ipynb").read_text(encoding="utf-8"))["cells"]
    blank = json.loads(notebook(name))["cells"]
    assert [(one["cell_type"], "".join(one["source"]), one["metadata"]) for one in stored] == [
        (one["cell_type"], one["source"], one["metadata"]) for one in blank
    ]


def test_there_is_a_set_for_each_lesson():
    assert sorted(SETS) == sorted(path.stem for path in LESSONS.glob("[01][0-9]-*.ipynb") if path.stem != "00-start")
    assert sorted(SETS) == sorted(path.stem for path in (LESSONS / "homework").iterdir() if path.suffix == ".ipynb")


def test_a_notebook_is_one_of_format_4_5():
    import nbformat

    for name in SETS:
        nbformat.validate(nbformat.reads(notebook(name, 'O"Hara \\'), as_version=4))


def test_the_command_writes_all_sets_and_overwrites_none(tmp_path, capsys):
    folder = tmp_path / "new" / "homework"
    assert cli.main(["homework", str(folder), "--name", "Ada"]) == 0
    assert sorted(path.stem for path in folder.iterdir()) == sorted(SETS)
    found = graded(folder / "08-splitting.ipynb")
    assert {(one.student, one.status) for one in found} == {("ada", "UNATTEMPTED")}
    assert cli.main(["homework", str(folder)]) == 1
    assert "is there already: choose another folder" in capsys.readouterr().err


def test_the_key_has_every_question_with_the_student_s_numbers(capsys):
    assert cli.main(["homework", "--key", "08-splitting"]) == 0
    book = capsys.readouterr().out
    assert all(id in book for id, (name, _) in QUESTIONS.items() if name == "08-splitting")
    assert "[(0, 0), (Fraction(1, 3), 1), (Fraction(2, 3), Fraction(13, 9)), (1, Fraction(5, 3))]" in book
    assert cli.main(["homework", "--key", "08-splitting", "--name", "Ada"]) == 0
    assert capsys.readouterr().out != book


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "name a folder for the notebooks, or a set with --key"),
        (["--key", "8"], "there is no set '8': take one of "),
        (["x", "--key", "08-splitting"], "it goes without a folder"),
        (["x", "--name", " "], "a name is a text of 1 to 60 letters"),
    ],
)
def test_what_cannot_be_done_is_a_problem(arguments, said, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["homework", *arguments]) == 1
    assert said in capsys.readouterr().err and not list(tmp_path.iterdir())
