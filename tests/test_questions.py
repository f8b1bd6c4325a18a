"""What a student answers is read exactly and judged fairly; feedback names the mistake without telling the answer."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bezteach.display import point
from bezteach.questions import GOALS, QUESTIONS, Choice, Entry, judge, read
from bezteach.questions.splitting import ARCH
from bezteach.widgets.board.state import state_of

CHOICES = {name: question for name, question in QUESTIONS.items() if isinstance(question, Choice)}
ENTRIES = {name: question for name, question in QUESTIONS.items() if isinstance(question, Entry)}


def typed(answer):
    """An answer as a student would type it."""
    answer = np.asarray(answer, dtype=object)
    return " ".join(map(point, answer)) if answer.ndim == 2 else point(answer) if answer.ndim else str(answer)


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("3", 3),
        (" -1/3 ", F(-1, 3)),
        ("0.25", F(1, 4)),
        ("1, 5/3", (1, F(5, 3))),
        ("(1, 5/3)", (1, F(5, 3))),
        ("(0,0) (1/3, 1)", ((0, 0), (F(1, 3), 1))),
        ("[(0, 0), (1/3, 1)]", ((0, 0), (F(1, 3), 1))),
        ("[[0,0],[1/3,1]]", ((0, 0), (F(1, 3), 1))),
        ("(0; 0), （1 / 3，1）", ((0, 0), (F(1, 3), 1))),
        ("−1", -1),
    ],
)
def test_read(text, answer):
    assert read(text) == answer


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("x", "Character 1, 'x'"),
        ("(0, 0) (1, t)", "Character 12, 't'"),
        ("1e999", "Character 2, 'e'"),
        ("__import__('os')", "Character 1, '_'"),
        ("(0, 0", "not closed"),
        ("0, 0)", "Nothing to close at character 5"),
        ("(0, 0) 1", "outside the parentheses"),
        ("(0, 0) (1)", "different numbers of coordinates"),
        ("1/0", "division by zero"),
        ("()", "no number"),
        ("9" * 501, "longer than 500"),
        ("9" * 41 + "!", "Character 42"),
    ],
)
def test_what_cannot_be_read_is_named(text, problem):
    with pytest.raises(ValueError, match="(?s).*") as caught:
        read(text)
    assert problem in str(caught.value)


@given(st.text(max_size=60))
def test_nothing_typed_ever_raises_anything_else(text):
    right, feedback = judge(ENTRIES["splitting/exercise-left-half"], text)
    assert right in (None, False) and feedback


@given(st.text(alphabet="0123456789/()[],;.- ", max_size=40))
def test_nothing_number_like_ever_raises_anything_else(text):
    judge(ENTRIES["splitting/exercise-cut-point"], text)


@pytest.mark.parametrize("name", ENTRIES)
def test_the_right_answer_is_right_and_each_mistake_gets_its_own_words(name):
    question = ENTRIES[name]
    assert judge(question, typed(question.right())) == (True, "Right.")
    said = [judge(question, typed(mistake)) for mistake, _ in question.mistakes()]
    assert said == [(False, feedback) for _, feedback in question.mistakes()]
    assert len({typed(mistake) for mistake, _ in question.mistakes()}) == len(said) >= 2


@pytest.mark.parametrize("name", ENTRIES)
def test_feedback_on_mistakes_does_not_tell_the_answer(name):
    question = ENTRIES[name]
    telling = np.ravel(np.asarray(question.right(), dtype=object))
    for _, feedback in question.mistakes():
        assert typed(question.right()) not in feedback.split()
        assert not any(f" {value} " in feedback for value in telling if F(value).denominator > 3)


@pytest.mark.parametrize("name", ENTRIES)
def test_the_example_of_how_to_write_is_a_wrong_answer_of_the_right_shape(name):
    question = ENTRIES[name]
    assert judge(question, question.example)[0] is False
    assert np.shape(np.array(read(question.example), dtype=object)) == np.shape(question.right())


@pytest.mark.parametrize("name", CHOICES)
def test_choices_have_one_right_answer_and_words_for_each(name):
    question = CHOICES[name]
    verdicts = {option: judge(question, option) for option in question.options}
    assert [option for option, (right, _) in verdicts.items() if right] == [question.right]
    assert len({feedback for _, feedback in verdicts.values()}) == len(question.options) >= 2


@pytest.mark.parametrize("name", QUESTIONS)
@pytest.mark.parametrize("blank", [None, "", "  "])
def test_no_answer_is_not_a_wrong_one(name, blank):
    assert judge(QUESTIONS[name], blank) == (None, "Not answered yet.")


def test_an_answer_partly_right_is_told_where_to_look():
    question = ENTRIES["splitting/exercise-left-half"]
    assert judge(question, "(0,0) (1/4,3/4) (1/2, 1) (3/4, 93/64)") == (
        False,
        "3 of 4 points are right; look at point number 3 again.",
    )
    assert judge(question, "(0, 0)")[1] == (
        "The answer is 4 points with 2 coordinates; yours is one point with 2 coordinates."
    )


@pytest.mark.parametrize(
    ("name", "answer", "said"),
    [
        ("basis/exercise-values", "1/2, 1/2, 0", "The answer is 4 numbers; yours is 3 numbers."),
        ("why/exercise-fit", "1", "The answer is 2 numbers; yours is a number."),
        (
            "elevation/exercise-nearest",
            "(1, 2) (3, 4)",
            "The answer is 3 numbers; yours is 2 points with 2 coordinates.",
        ),
        (
            "splitting/exercise-cut-point",
            "1, 2, 3",
            "The answer is one point with 2 coordinates; yours is one point with 3 coordinates.",
        ),
    ],
)
def test_an_answer_of_another_shape_is_told_what_is_asked_for(name, answer, said):
    assert judge(ENTRIES[name], answer) == (False, said)


NUMBERS = {  # whose answers are several numbers and no point
    "why/smooth",
    "why/exercise-fit",
    "definitions/exercise-to-powers",
    "definitions/exercise-from-powers",
    "basis/exercise-values",
    "basis/exercise-coefficients",
    "basis/exercise-part",
    "curve/exercise-range",
    "splitting/exercise-left-heights",
    "elevation/exercise-nearest",
    "bsplines/exercise-support",
}


def test_points_alone_are_written_in_parentheses():
    rows = {name for name, question in ENTRIES.items() if np.ndim(question.right()) == 1}
    assert {name for name in rows if not ENTRIES[name].example.startswith("(")} == NUMBERS


@pytest.mark.parametrize("count", range(2, 7))
@pytest.mark.parametrize("name", GOALS)
def test_a_goal_has_an_answer_for_any_number_of_points(name, count):
    for points in ([(0, 0)] * count, [(k, k * k) for k in range(count)], [(k, 0) for k in range(count)]):
        for t in (F(0), F(1, 2), F(1)):
            assert GOALS[name].reached(state_of(points, t=t)) in (True, False)


def test_right_answers_by_hand():
    """Worked on paper: the left half at 1/4, the right half at 1/3, the part [1/3, 2/3], and so on."""
    right = {name: typed(question.right()) for name, question in ENTRIES.items()}
    assert right == {
        "basis/exercise-values": "(8/27, 4/9, 2/9, 1/27)",
        "basis/exercise-peak": "27/64",
        "basis/exercise-recursion": "405/1024",
        "basis/exercise-integral": "1/8",
        "basis/exercise-coefficients": "(0, 0, 1/3, 1)",
        "basis/exercise-part": "(0, 0, 1/4)",
        "casteljau/exercise-count": "126",
        "casteljau/exercise-level": "(1/2, 19/16) (3/2, 9/4)",
        "casteljau/exercise-path": "(1, 4) (2, 0) (3, 4)",
        "casteljau/exercise-point": "(3/8, 17/16)",
        "casteljau/exercise-tangent": "(33/8, 21/8)",
        "casteljau/missing-level": "(4/3, 16/9) (7/3, 19/9)",
        "curve/exercise-backwards": "(-3, -6)",
        "curve/exercise-end": "(8, -12)",
        "curve/exercise-mapped": "(1/3, 14/3)",
        "curve/exercise-passages": "3",
        "curve/exercise-pull": "(64, 0)",
        "curve/exercise-range": "(0, 2)",
        "curve/exercise-second": "(0, -12)",
        "definitions/exercise-from-powers": "(2, 7/2, 4)",
        "definitions/exercise-points": "(1, 1) (3, 1) (3, 4)",
        "definitions/exercise-to-powers": "(1, 4, -3)",
        "definitions/exercise-value": "8/27",
        "definitions/exercise-vectors": "(1, 2) (2, 1) (1, -3)",
        "derivatives/exercise-curvature": "1/2",
        "derivatives/exercise-end": "(-2, 2)",
        "derivatives/exercise-from-triangle": "(3, 2)",
        "derivatives/exercise-from-velocity": "(3, 0)",
        "derivatives/exercise-hodograph": "(3, 9) (3, -6) (3, 6)",
        "derivatives/exercise-second-end": "(0, -36)",
        "derivatives/exercise-second-from-triangle": "(0, -12)",
        "start/second-difference": "2",
        "start/exercise-middle": "(2, 2)",
        "start/exercise-difference": "4",
        "why/end": "(0, 1)",
        "why/smooth": "(0, 0, 1, 1)",
        "why/exercise-circle": "(4/5, 3/5)",
        "why/exercise-from-power": "(1, 2) (3, 1) (2, 1)",
        "why/exercise-to-power": "(2, 0) (-2, 6) (4, -4)",
        "why/exercise-fit": "(1/2, 7/2)",
        "why/exercise-move": "(0, 3)",
        "why/exercise-pull": "(2, 6)",
        "why/exercise-way": "1/3",
        "elevation/exercise-elevate": "(0, 0) (2, 2) (4, 2) (6, 0)",
        "elevation/exercise-edge": "(6, 2)",
        "elevation/exercise-distance": "1/9",
        "elevation/exercise-degree": "2",
        "elevation/exercise-lower": "(0, 0) (3, 6) (9, 3)",
        "elevation/exercise-missing": "6",
        "elevation/exercise-nearest": "(1/20, -1/4, 19/20)",
        "joining/before-velocity": "(6, 0)",
        "joining/where": "(6, 4)",
        "joining/second-place": "(8, 2)",  # tip (4, 6), then (6, 4), then as far again
        "joining/beside": "(3, 6)",  # the chord is (6, 6)
        "joining/exercise-interval": "2",
        "joining/exercise-next": "(8, 4)",
        "joining/exercise-second": "(12, -4)",  # tip (6, 8), then (8, 4), then twice as far
        "joining/exercise-piece": "(6, 6) (7, 5) (7, 0) (8, -1)",
        "bsplines/before-between": "(3, 1)",
        "bsplines/hat": "1/2",
        "bsplines/quadratic-value": "3/4",
        "bsplines/how-many-knots": "11",
        "bsplines/sum-outside": "7/8",
        "bsplines/step": "(3, 11/2)",
        "bsplines/value-at-a-knot": "(2, 5)",
        "bsplines/second-piece": "(2, 5) (4, 6) (6, 4)",
        "bsplines/exercise-count": "7",
        "bsplines/exercise-support": "(2, 5)",
        "bsplines/exercise-value": "2/3",
        "bsplines/exercise-point": "(8, 11/4)",
        "bsplines/exercise-insert": "(7, 3) (9, 5/2)",
        "bsplines/exercise-piece": "(10, 3) (12, 4) (12, 0)",
        "operator/difference": "-4",
        "operator/exercise-first": "-7",
        "operator/exercise-path": "(1, 3) (2, 1) (3, 3)",
        "operator/exercise-step": "7/2",
        "operator/exercise-two-parameters": "10/3",
        "rational/half": "(3/5, 4/5)",
        "rational/heavy": "(2, 3)",  # (4, 6) over 2
        "rational/how-many-knots": "12",
        "rational/exercise-point": "(5/13, 12/13)",
        "rational/exercise-lift": "(0, 0, 1) (6, 12, 3) (4, 0, 1)",
        "rational/exercise-weight": "7",
        "rational/exercise-half": "(1/3, 1)",  # (1/2, 3/2, 3/2) is seen there
        "rational/exercise-gap": "1/8",
        "splitting/exercise-cut-point": "(3/2, 15/8)",
        "splitting/exercise-left-half": "(0, 0) (1/4, 3/4) (1/2, 19/16) (3/4, 93/64)",
        "splitting/exercise-right-half": "(4/9, 10/9) (2/3, 4/3) (0, 2)",
        "splitting/exercise-local-parameter": "1/2",
        "splitting/exercise-part": "(-3, 4) (-1, 14/3) (1, 14/3) (3, 4)",
        "splitting/exercise-box": "2",
        "splitting/exercise-left-heights": "(2, -1/2, -3/4)",
        "splitting/exercise-apart": "3",
    }


@pytest.mark.parametrize(("a", "b", "reached"), [(F(1, 3), F(2, 3), True), (F(2, 3), F(1, 3), False), (0, 1, False)])
def test_the_goal_is_reached_by_what_it_asks_for_alone(a, b, reached):
    goal = GOALS["splitting/middle-edge"]
    assert goal.reached(SimpleNamespace(points=ARCH, a=a, b=b)) == reached
    assert not goal.reached(SimpleNamespace(points=tuple((x, x + y) for x, y in ARCH), a=a, b=b))
