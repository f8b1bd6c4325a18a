"""Whatever is given for an answer, it is read or refused in one line, and nothing of it is ever run."""

import pytest
from hostile_answers import OBJECTS, TEXTS

from bezteach.homework import InvalidAnswer
from bezteach.homework.derivations import lines_of
from bezteach.homework.formulas import formula_of
from bezteach.homework.reading import is_blank
from bezteach.homework.truth import truth_of
from bezteach.homework.values import SHAPES, value_of
from bezteach.symbolic import E, b, i, n, t

LETTERS = {i, n, t, b, E}
READERS = {kind: lambda answer, kind=kind: value_of(kind, answer) for kind in SHAPES} | {
    "formula": lambda answer: formula_of(answer, LETTERS),
    "truth": truth_of,
    "derivation": lambda answer: lines_of(answer, LETTERS),
}


def refused(read, answer):
    """What is said against an answer, or None if it can be read; anything else that happens is a failure."""
    try:
        read(answer)
    except InvalidAnswer as problem:
        said = str(problem)
        assert said.isprintable() and 5 < len(said) < 250, said
        return said
    return None


@pytest.mark.parametrize("name", OBJECTS)
def test_an_object_is_no_answer_of_any_kind(name):
    answer = OBJECTS[name]
    is_blank(answer)
    said = {kind: refused(read, answer) for kind, read in READERS.items()}
    taken = {kind for kind, words in said.items() if words is None}
    assert taken <= {"truth"} and (not taken or answer is True)


@pytest.mark.parametrize("answer", TEXTS, ids=range(len(TEXTS)))
def test_a_text_is_read_or_refused(answer):
    is_blank(answer)
    for text in (answer, [answer, answer], f"t\n{answer}"):
        for read in READERS.values():
            refused(read, text)


def test_there_are_enough_of_them():
    assert len(OBJECTS) + len(TEXTS) >= 150
