"""What a student types is read as mathematics, and what cannot be read is refused in words, at its place."""

import ast
import pickle
from pathlib import Path

import pytest
from parsing_texts import READ, REFUSED
from sympy import Expr

from bezteach import parsing, symbolic
from bezteach.parsing import InvalidAnswer, parse, parse_given
from bezteach.parsing.calls import RULES
from bezteach.parsing.names import ADVICE, COMMAND_ADVICE, COMMANDS, FUNCTIONS, LETTERS
from bezteach.symbolic import E, b, n, t


@pytest.mark.parametrize("text", READ)
def test_what_is_typed_is_read(text):
    result, expected = parse(text), READ[text]
    assert result == expected
    if not isinstance(expected, tuple):
        assert type(result) is type(expected)


@pytest.mark.parametrize("typed", READ)
def test_what_is_read_can_be_written_and_read_again(typed):
    for found in parse(typed) if isinstance(READ[typed], tuple) else (parse(typed),):
        if isinstance(found, Expr):
            again = parse(symbolic.text(found))
            assert again == found or symbolic.text(again) == symbolic.text(found)  # terms that stay, in another order


@pytest.mark.parametrize("letter", LETTERS)
def test_every_letter_is_the_course_letter(letter):
    assert parse(letter) is LETTERS[letter]


def test_letters_carry_the_assumptions_of_the_course():
    whole = {letter for letter in LETTERS if LETTERS[letter].is_integer}
    assert whole == set("ijklmnpqr")
    assert all(LETTERS[letter].is_nonnegative for letter in whole)
    assert {letter for letter in LETTERS if LETTERS[letter].is_real and letter not in whole} == set("achstuvwxyz")
    assert (parse("n"), parse("t"), parse("b[0]"), parse("E")) == (n, t, b[0], E)


@pytest.mark.parametrize(("text", "position", "fragment"), REFUSED, ids=[f"{row[0][:20]!a}" for row in REFUSED])
def test_what_cannot_be_read_is_refused_in_words_at_its_place(text, position, fragment):
    with pytest.raises(InvalidAnswer) as caught:
        parse(text)
    message = str(caught.value)
    assert (caught.value.position, fragment in message) == (position, True), message
    assert message.startswith(f"character {position}: ")
    assert message.isprintable() and len(message) < 200


def test_the_corpus_is_large():
    assert len(REFUSED) > 120
    assert len({row[0] for row in REFUSED}) == len(REFUSED)


class Text(str):
    """A text with methods of its own, which must not be asked."""

    def __len__(self):
        raise SystemExit

    __iter__ = __str__ = __repr__ = __len__


LOOP = []
LOOP.append(LOOP)


THINGS = [None, 3, 0.5, True, b"t", t, ["t"], ("t",), LOOP, object(), Text("t"), str, {}]


@pytest.mark.parametrize("thing", THINGS, ids=range(len(THINGS)))
@pytest.mark.parametrize("read", [parse, parse_given])
def test_only_a_text_is_read(read, thing):
    with pytest.raises(InvalidAnswer, match="a formula is a text in quotes") as caught:
        read(thing)
    assert caught.value.position is None


def test_an_error_survives_the_way_between_processes():
    error = pickle.loads(pickle.dumps(InvalidAnswer("a bracket is missing", 3)))
    assert (type(error), str(error), error.position) == (InvalidAnswer, "character 3: a bracket is missing", 3)
    assert isinstance(error, ValueError)


@pytest.mark.parametrize("word", ADVICE)
def test_every_word_with_advice_gets_it(word):
    with pytest.raises(InvalidAnswer) as caught:
        parse(f"1 + {word}")
    assert (caught.value.position, ADVICE[word] in str(caught.value)) == (5, True)


@pytest.mark.parametrize("command", COMMAND_ADVICE)
def test_every_command_with_advice_gets_it(command):
    assert command not in COMMANDS
    with pytest.raises(InvalidAnswer) as caught:
        parse(f"1 + \\{command}")
    assert (caught.value.position, COMMAND_ADVICE[command] in str(caught.value)) == (5, True)


@pytest.mark.parametrize("rule", RULES.values(), ids=list(RULES))
def test_what_an_error_says_to_write_can_be_read(rule):
    for usage in rule.usage.split(" or "):
        parse(usage)
    assert {*FUNCTIONS.values()} == {*RULES}


FORBIDDEN = {"eval", "exec", "compile", "sympify", "parse_expr", "symbols", "getattr", "__import__", "S", "var"}
MODULES = sorted(Path(parsing.__file__).parent.glob("*.py"))


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.name)
def test_nothing_in_the_parser_evaluates_a_text(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    names |= {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    names |= {alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert not names & FORBIDDEN
    if path.name != "names.py":
        # letters and points are made from the lists in names.py, and nowhere else
        calls = {
            node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        }
        assert not calls & {"Symbol", "IndexedBase", "Function", "Dummy", "Wild"}
