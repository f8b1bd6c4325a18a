"""Any text is read or refused, and what SymPy prints is read again."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from parsing_texts import READ
from sympy import (
    Abs,
    Derivative,
    I,
    Integer,
    Integral,
    Rational,
    Sum,
    binomial,
    factorial,
    nan,
    oo,
    zoo,
)

from bezteach import symbolic
from bezteach.parsing import InvalidAnswer, parse, parse_given
from bezteach.parsing.names import FUNCTIONS, LETTERS
from bezteach.symbolic import B, E, b, i, n, t, u

F = Rational
a = LETTERS["a"]

PIECES = [
    *LETTERS,
    *FUNCTIONS,
    *READ,
    *"bBCgdE+-*/^!()[]{},=<>_.\\ 0123456789",
    "\\frac",
    "\\sum_{i=0}^n",
    "²",
    "₁",
    "dt",
]
TEXTS = st.one_of(
    st.text(max_size=60),
    st.lists(st.sampled_from(PIECES), max_size=25).map("".join),
    st.text(alphabet="tn12+-*/^!()[]{},=<>_ b", max_size=60),
    st.text(alphabet="\\{}_^fracsumintbolBC0123din() ", max_size=60),
)


@given(TEXTS)
def test_any_text_is_read_or_refused(text):
    for read in (parse, parse_given):
        try:
            result = read(text)
        except InvalidAnswer as error:
            assert 1 <= error.position <= len(text) + 1
            assert "\n" not in str(error)
        else:
            assert type(result) is dict if read is parse_given else not _flat_has(result, nan, zoo, oo, I)


def _flat_has(value, *what):
    return any(_flat_has(part, *what) for part in value) if isinstance(value, tuple) else value.has(*what)


PLAIN = [text for text in READ if not set(text) & {"\\", "."}]


@given(st.sampled_from(PLAIN), st.integers(0, 60), st.sampled_from(["\u200b", "т", "$", ";", "\x07"]))
def test_the_place_of_a_bad_character_is_found(text, place, bad):
    with pytest.raises(InvalidAnswer) as caught:
        parse(text[:place] + bad + text[place:])
    assert caught.value.position == min(place, len(text)) + 1


WHOLE = st.sampled_from([i, n, i + 1, n - i, n - 1, Integer(0), Integer(1), Integer(3)])
LEAVES = st.one_of(
    st.sampled_from([t, u, i, n, E, a]),
    st.fractions(max_denominator=9).filter(lambda f: abs(f) < 100).map(lambda f: F(f.numerator, f.denominator)),
    WHOLE.map(lambda index: b[index]),
    st.builds(binomial, st.sampled_from([n, Integer(5)]), WHOLE),
    st.builds(factorial, st.sampled_from([n, n + 1, Integer(4)])),
    st.builds(B, WHOLE, st.sampled_from([n, n + 1, Integer(3)]), st.sampled_from([t, 1 - t, F(1, 3)])),
)


def branches(tree):
    return st.one_of(
        st.builds(lambda x, y: x + y, tree, tree),
        st.builds(lambda x, y: x - y, tree, tree),
        st.builds(lambda x, y: x * y, tree, tree),
        st.builds(lambda x, y: x / y, tree, tree),
        st.builds(lambda x, m: x**m, tree, st.one_of(st.integers(-3, 3), WHOLE)),
        st.builds(lambda x: Sum(x, (i, 0, n)), tree),
        st.builds(lambda x: Integral(x, (t, 0, 1)), tree),
        st.builds(lambda x: Derivative(x, t), tree),
        st.builds(lambda x: abs(x) if x.is_Rational else Abs(x, evaluate=False), tree),
    )


@pytest.mark.parametrize("printed", [str, symbolic.text])
@given(expr=st.recursive(LEAVES, branches, max_leaves=8))
def test_what_is_printed_is_read_again(printed, expr):
    assume(not expr.has(nan, zoo, oo, I))
    text = printed(expr)
    try:
        result = parse(text)
    except InvalidAnswer as error:
        assert any(word in str(error) for word in ("degree", "more than 3 sums", "negative", "short formula", "up to"))
        assume(False)
    # a product that SymPy built from the inside may print as one that it multiplies out when it is built in line
    assert result == expr or printed(result) == text or (result - expr).expand() == 0


@given(st.recursive(LEAVES, branches, max_leaves=8), st.data())
def test_a_cut_text_is_read_or_refused(expr, data):
    text = str(expr)
    start = data.draw(st.integers(0, len(text)))
    piece = text[:start] + text[data.draw(st.integers(start, len(text))) :]
    try:
        parse(piece)
    except InvalidAnswer as error:
        assert 1 <= error.position <= len(piece) + 1
