"""What a student calls: start, ask, check, hint, solution, points."""

import pytest

from bezteach import homework

LOCAL = "08-splitting/local"


@pytest.fixture(autouse=True)
def fresh(capsys):
    homework.start()
    capsys.readouterr()


def printed(capsys):
    return capsys.readouterr().out.strip()


def test_a_name_has_numbers_of_its_own(capsys):
    assert str(homework.ask(LOCAL)).startswith("The part over [1/4, 3/4] of a curve")
    texts = set()
    for name in ("Ada", "Bob", "Chen", "Dora", "Emil"):
        homework.start(name)
        texts.add(str(homework.ask(LOCAL)))
    assert len(texts) > 1
    printed(capsys)
    homework.start(" ada ")
    assert printed(capsys) == "The numbers of ada."


@pytest.mark.parametrize("name", ["", "  ", 5, "x" * 61, ["Ada"]])
def test_what_is_no_name(name):
    with pytest.raises(ValueError, match="a name is a text of 1 to 60 letters"):
        homework.start(name)


def test_a_check_says_one_line_and_returns_nothing(capsys):
    assert homework.check(LOCAL) is None
    assert printed(capsys) == "… UNATTEMPTED: Not answered yet."
    homework.check(LOCAL, "1/3")
    assert printed(capsys) == "✓ CORRECT: Right."
    homework.check(LOCAL, lambda: 1)
    assert printed(capsys).startswith("? INVALID: this is a function")


def test_hints_come_one_after_the_other(capsys):
    homework.hint(LOCAL)
    first = printed(capsys)
    homework.hint(LOCAL)
    assert printed(capsys) not in ("", first)
    homework.hint(LOCAL)
    assert printed(capsys) == "There are no more hints."


def test_the_solution_comes_after_an_attempt(capsys):
    homework.solution(LOCAL)
    homework.check(LOCAL, ...)
    homework.solution(LOCAL)
    assert printed(capsys).count("Try an answer first") == 2
    homework.check(LOCAL, "1/2")
    homework.solution(LOCAL)
    assert printed(capsys).endswith("Fraction(1, 3)")


def test_what_is_asked_is_prose_in_which_nothing_is_markup():
    asked = homework.ask("08-splitting/point")
    assert "b_0 = (0, 0)" in str(asked) and "b\\_0 = (0, 0)" in asked._repr_markdown_()


def test_points_are_one_for_a_right_answer_and_a_half_for_a_part():
    assert homework.points("08-splitting") == 0
    homework.check(LOCAL, "1/3")
    homework.check("08-splitting/left", "(0, 0), (1/3, 1), (2/3, 1), (1, 5/3)")
    homework.check("02-definitions/walk", 7)
    assert (homework.points("08-splitting"), homework.points("02-definitions")) == (1.5, 0)
    homework.check(LOCAL, "1/2")
    homework.check(LOCAL)
    assert homework.points("08-splitting") == 0.5
    homework.start()
    assert homework.points("08-splitting") == 0
    with pytest.raises(ValueError, match="there is no set '13'"):
        homework.points("13")


@pytest.mark.parametrize(("id", "near"), [("08-spliting/local", "08-splitting/local"), (7, "08-splitting/point")])
def test_a_question_that_is_not_there_is_named_with_its_neighbours(id, near):
    with pytest.raises(ValueError, match=near):
        homework.check(id, 1)
