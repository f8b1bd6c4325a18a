"""Grading reads answers from the syntax tree, runs nothing, and leaves no notebook of a class without its line."""

import csv
import json
from fractions import Fraction as F

import pytest

from bezteach import cli
from bezteach.grading import graded
from bezteach.homework.sets import SETS
from bezteach.homework.submission import NotRead, submission

ALL = [f"08-splitting/{short}" for short in SETS["08-splitting"].questions]
LOCAL, POINT = "08-splitting/local", "08-splitting/point"


def notebook(*cells, **more):
    made = [{"cell_type": "code", "source": cell, "metadata": {}, "outputs": []} for cell in cells]
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": made} | more).encode()


def answer_of(text):
    return submission(notebook(f"check('{LOCAL}', {text})")).answers[LOCAL]


def grades(tmp_path, content):
    path = tmp_path / "one.ipynb"
    path.write_bytes(content)
    return graded(path)


# ---- What is read


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1/3", F(1, 3)),
        ("-(2 + 1/2) * 3", F(-15, 2)),
        ("Fraction(2, 6)", F(1, 3)),
        ("F(1) / 3", F(1, 3)),
        ("0.5", 0.5),
        ("'1/3'", "1/3"),
        ("[(0, 1/3), [1, +2]]", [(0, F(1, 3)), [1, 2]]),
        ("...", ...),
        ("None", None),
        ("(False, 'n = 1')", (False, "n = 1")),
        ("\n    1 /\n    3  # a remark\n", F(1, 3)),
    ],
)
def test_answers_that_are_written_out(text, value):
    found = answer_of(text)
    assert found == value and type(found) is type(value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("x", '"x" cannot be read without running it'),
        ("f(1)", "cannot be read without running it"),
        ("2**3", "cannot be read without running it"),
        ("[t for t in (1, 2)]", "cannot be read without running it"),
        ("(lambda: 1)()", "cannot be read without running it"),
        ("b'1'", "cannot be read without running it"),
        ("f'{1}'", "cannot be read without running it"),
        ("{1: 2}", "cannot be read without running it"),
        ("__import__('os').system('true')", "cannot be read without running it"),
        ("'a' * 10", "is no number"),
        ("True + 1", "is no number"),
        ("1/0", "a division by zero"),
        ("Fraction(1, 0)", "a division by zero"),
        ("Fraction('1/3')", "is no number"),
        ("Fraction(0.5)", "one or two whole numbers"),
        ("10**50", "cannot be read without running it"),
        ("1" + "0" * 40, "more than 40 digits"),
        ("9999999999999999999999 * 9999999999999999999999", "more than 40 digits"),
        ("-" * 5000 + "1", ""),
        ("+".join(["1"] * 20000), ""),
        ("1, 2", "the id and one answer"),
    ],
)
def test_answers_that_are_not(text, said):
    try:
        found = answer_of(text)
    except NotRead as problem:  # of the whole notebook: such a cell is no Python
        assert not said, problem
    else:
        assert isinstance(found, NotRead) and said in str(found)


def test_only_calls_that_stand_alone_count():
    cells = [
        f"from bezteach.homework import *\nstart('Ada')\ncheck('{LOCAL}', 1/3)",
        "def f():\n    check('08-splitting/point', 1)",
        "%matplotlib inline\n!ls\nx = check('08-splitting/left', 1)",
        "homework.check(id='08-splitting/right', answer=...)",
        "this is no Python",
    ]
    assert submission(notebook(*cells)) == ("Ada", {LOCAL: F(1, 3), "08-splitting/right": ...})


def test_two_answers_to_one_question_are_none():
    found = submission(notebook(f"check('{LOCAL}', 1/3)", f"check('{LOCAL}', 1/4)"))
    assert "answered twice" in str(found.answers[LOCAL])


def test_two_names_are_none():
    with pytest.raises(NotRead, match="different names"):
        submission(notebook("start('Ada')\nstart('Bob')"))


# ---- What is said


def test_a_notebook_gets_a_line_for_each_question_of_its_set(tmp_path):
    found = grades(tmp_path, notebook(f"start()\ncheck('{LOCAL}', 1/3)\ncheck('{POINT}', (2, 2))\ncheck('08-x/y', 1)"))
    assert [one.question for one in found] == [*ALL, "08-x/y"]
    by = {one.question: one for one in found}
    assert (by[LOCAL].status, by[LOCAL].note) == ("CORRECT", "Right.")
    assert by[POINT].status == "WRONG" and "t and 1 - t" in by[POINT].note
    assert by["08-splitting/left"][3:] == ("UNATTEMPTED", "its check is not in the notebook")
    assert by["08-x/y"][3:] == ("INVALID", "there is no such question")


def test_the_name_in_the_notebook_chooses_the_numbers(tmp_path):
    from bezteach.homework.sets import QUESTIONS, data_of

    solution = QUESTIONS[POINT][1].solution(data_of("08-splitting", "ada lovelace"))
    found = grades(tmp_path, notebook("start('Ada  Lovelace')", f"check('{POINT}', {solution})"))
    assert found[0][1:4] == ("ada lovelace", POINT, "CORRECT")
    assert grades(tmp_path, notebook(f"check('{POINT}', {solution})"))[0].status == "WRONG"


def test_nothing_that_a_student_wrote_is_run(tmp_path):
    trap = tmp_path / "trap"
    cells = [
        f"open({str(trap)!r}, 'w')",
        "import bezteach.homework.kinds as k\nk.judged = lambda *a: k.Verdict('CORRECT', '')",
        f"def check(*a): open({str(trap)!r}, 'w')",
        f"check('{LOCAL}', open({str(trap)!r}, 'w'))",
        f"check('{POINT}', 1)",
    ]
    found = {one.question: one for one in grades(tmp_path, notebook(*cells))}
    assert not trap.exists()
    assert found[LOCAL].status == "INVALID" and found[POINT].status == "INVALID"


BROKEN = {
    "empty": (b"", "the file is empty"),
    "blank": (b" \n", "the file is empty"),
    "text": (b"hello", "line 1 is no JSON"),
    "cut off": (notebook("check('x', 1)")[:-20], "is no JSON"),
    "not utf-8": (b'{"cells": "\xff"}', "byte 12 is no UTF-8"),
    "format 3": (notebook(nbformat=3), "no notebook of format 4"),
    "a list": (b"[]", "no notebook of format 4"),
    "no cells": (b'{"nbformat": 4}', "no notebook of format 4"),
    "cells of all kinds": (
        notebook(cells=[1, None, {}, {"cell_type": "code", "source": 5}]),
        "no answer to a question",
    ),
    "deep": (b"[" * 100_000 + b"]" * 100_000, "nested or long beyond measure"),
    "a long number": (b'{"nbformat": ' + b"4" * 10_000 + b"}", "nested or long beyond measure"),
    "no answers": (notebook("1 + 1"), "no answer to a question"),
    "no Python": (notebook("check('x', 1"), "no Python"),
    "huge": (b" " * 64_000_001, "64 MB: clear its outputs"),
}


@pytest.mark.parametrize(("content", "said"), BROKEN.values(), ids=BROKEN)
def test_a_broken_notebook_gets_its_reason(tmp_path, content, said):
    (found,) = grades(tmp_path, content)
    assert found.status == "UNREAD" and said in found.note and "\n" not in found.note


def test_outputs_of_many_megabytes_do_no_harm(tmp_path):
    book = json.loads(notebook(f"check('{LOCAL}', 1/3)"))
    book["cells"][0]["outputs"] = [{"text": "x" * 50_000_000}]
    assert grades(tmp_path, json.dumps(book).encode())[3].status == "CORRECT"


# ---- The command


@pytest.fixture
def classroom(tmp_path):
    for name, answer in (("ada", "1/3"), ("bob", "'=1+1'"), ("chen", "x")):
        (tmp_path / f"{name}.ipynb").write_bytes(notebook(f"check('{LOCAL}', {answer})"))
    (tmp_path / "dora.ipynb").write_bytes(b"")
    (tmp_path / ".ipynb_checkpoints").mkdir()
    (tmp_path / ".ipynb_checkpoints" / "ada.ipynb").write_bytes(b"")
    return tmp_path


def test_a_folder_is_graded_and_a_broken_file_does_not_stop_it(classroom, capsys):
    assert cli.main(["grade", str(classroom), "--jobs", "1"]) == 1  # one could not be read
    out = capsys.readouterr().out
    assert f"ada.ipynb  -  {LOCAL}  CORRECT  Right." in out
    assert "dora.ipynb  -  -  UNREAD  the file is empty" in out
    assert out.strip().endswith("4 notebooks, 3 graded, 1 not read")


def test_the_table_as_csv_has_no_formula_for_a_spreadsheet(classroom, capsys):
    (classroom / "=cmd.ipynb").write_bytes(notebook(f"start('=1')\ncheck('{LOCAL}', 1/3)"))
    table = classroom / "grades.csv"
    assert cli.main(["grade", str(classroom), "--csv", str(table), "--jobs", "2"]) == 1
    with table.open(encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text))
    judged = {row["file"]: row["status"] for row in rows if row["question"] == LOCAL}
    assert [judged[f"{name}.ipynb"] for name in ("ada", "bob", "chen")] == ["CORRECT", "INVALID", "INVALID"]
    assert "'=cmd.ipynb" in judged
    assert not any(cell.startswith(("=", "+", "-", "@")) for row in rows for cell in row.values())


def test_what_is_not_there_is_a_problem(tmp_path, capsys):
    assert cli.main(["grade", str(tmp_path / "none")]) == 1
    assert "there is no " in capsys.readouterr().err
    assert cli.main(["grade", str(tmp_path)]) == 1
    assert "there is no notebook (*.ipynb) in" in capsys.readouterr().err
