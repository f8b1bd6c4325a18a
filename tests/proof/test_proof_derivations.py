"""check_derivation: the proofs that the sources print, what is said of a slip in them, and of what is no derivation."""

from dataclasses import replace
from fractions import Fraction as F
from time import perf_counter

import pytest
from proof_claims import mutants
from sympy import (
    Add,
    Derivative,
    Float,
    Integer,
    Integral,
    Interval,
    KroneckerDelta,
    Matrix,
    Mul,
    Pow,
    Rational,
    Sum,
    Symbol,
    binomial,
    factorial,
    floor,
    oo,
)

from bezteach.proof import ARGUED, CHECKED, INVALID, PROVED, REFUTED, UNDECIDED, chains, counterexample, statement
from bezteach.proof.derivations import Judgement, check_derivation
from bezteach.proof.errors import ReplayFailed
from bezteach.proof.exact.refuter import Counterexample
from bezteach.proof.verdict import Proof
from bezteach.symbolic import B, E, b, i, j, k, n, r, step, t, u

FROM_ONE = {n: (1, oo)}
INNER = {n: (1, oo), i: (1, n - 1)}
x, y = Symbol("x", real=True), Symbol("y", real=True)
g = step(t)
whole = u + t - t * u

# Deck, 1.2, property 6; the fourth line as printed.
RECURSION = [
    B(i, n, u),
    binomial(n, i) * u**i * (1 - u) ** (n - i),
    (binomial(n - 1, i) + binomial(n - 1, i - 1)) * u**i * (1 - u) ** (n - i),
    binomial(n - 1, i) * u**i * (1 - u) ** (n - i) + binomial(n - 1, i - 1) * u ** (i - 1) * (1 - u) ** (n - i + 1),
    (1 - u) * B(i, n - 1, u) + u * B(i - 1, n - 1, u),
]
RECURSION_CORRECTED = [
    *RECURSION[:3],
    (1 - u) * binomial(n - 1, i) * u**i * (1 - u) ** (n - i - 1)
    + u * binomial(n - 1, i - 1) * u ** (i - 1) * (1 - u) ** (n - i),
    RECURSION[4],
]

# Deck, 1.2, property 4.
DERIVATIVE = [
    Derivative(B(i, n, t), t),
    binomial(n, i) * i * t ** (i - 1) * (1 - t) ** (n - i) - binomial(n, i) * (n - i) * t**i * (1 - t) ** (n - i - 1),
    n * binomial(n - 1, i - 1) * t ** (i - 1) * (1 - t) ** (n - i)
    - n * binomial(n - 1, i) * t**i * (1 - t) ** (n - i - 1),
    n * (B(i - 1, n - 1, t) - B(i, n - 1, t)),
]

# Deck, 2.2.
HODOGRAPH = [
    Derivative(Sum(b[j] * B(j, n, t), (j, 0, n)), t),
    n * Sum((B(j - 1, n - 1, t) - B(j, n - 1, t)) * b[j], (j, 0, n)),
    n * Sum(B(j - 1, n - 1, t) * b[j], (j, 1, n)) - n * Sum(B(j, n - 1, t) * b[j], (j, 0, n - 1)),
    n * Sum(B(j, n - 1, t) * b[j + 1], (j, 0, n - 1)) - n * Sum(B(j, n - 1, t) * b[j], (j, 0, n - 1)),
    n * Sum((b[j + 1] - b[j]) * B(j, n - 1, t), (j, 0, n - 1)),
]
OPERATOR_DERIVATIVE = [
    Derivative(g**n * b[0], t),
    n * g ** (n - 1) * (E * b[0] - b[0]),
    n * g ** (n - 1) * (b[1] - b[0]),
    n * g ** (n - 1) * (E - 1) * b[0],
]
SECOND_DERIVATIVE = [
    Derivative(g**n * b[0], (t, 2)),
    n * (n - 1) * g ** (n - 2) * (E - 1) ** 2 * b[0],
    factorial(n) / factorial(n - 2) * Sum((b[j + 2] - 2 * b[j + 1] + b[j]) * B(j, n - 2, t), (j, 0, n - 2)),
]

# Deck, 2.1 and 2.3.
INTERMEDIATE = [
    g**k * b[j],
    Sum(binomial(k, i) * (1 - t) ** (k - i) * t**i * E**i * b[j], (i, 0, k)),
    Sum(B(i, k, t) * b[i + j], (i, 0, k)),
]
LEFT_HALF = [
    Sum(Sum(B(i, j, t) * b[i], (i, 0, j)) * B(j, n, u), (j, 0, n)),
    Sum(B(j, n, u) * g**j * b[0], (j, 0, n)),
    Sum(binomial(n, j) * (1 - u) ** (n - j) * (u * (1 - t) + u * t * E) ** j * b[0], (j, 0, n)),
    ((1 - u) + u * (1 - t) + u * t * E) ** n * b[0],
    ((1 - t * u) + t * u * E) ** n * b[0],
    Sum(B(i, n, t * u) * b[i], (i, 0, n)),
]
RIGHT_HALF = [
    Sum(Sum(B(i, n - j, t) * b[i + j], (i, 0, n - j)) * B(j, n, u), (j, 0, n)),
    Sum(B(j, n, u) * g ** (n - j) * b[j], (j, 0, n)),
    Sum(binomial(n, j) * (1 - u) ** (n - j) * u**j * g ** (n - j) * E**j * b[0], (j, 0, n)),
    ((1 - whole) + whole * E) ** n * b[0],
    Sum(B(i, n, 1 - (1 - t) * (1 - u)) * b[i], (i, 0, n)),
]
UNITY = [
    Integer(1),
    (u + (1 - u)) ** n,
    Sum(binomial(n, i) * u**i * (1 - u) ** (n - i), (i, 0, n)),
    Sum(B(i, n, u), (i, 0, n)),
]

PRINTED = {
    "partition of unity": (UNITY, {}),
    "recursion, corrected": (RECURSION_CORRECTED, INNER),
    "derivative": (DERIVATIVE, INNER),
    "hodograph": (HODOGRAPH, FROM_ONE),
    "derivative of the operator form": (OPERATOR_DERIVATIVE, FROM_ONE),
    "second derivative": (SECOND_DERIVATIVE, {n: (2, oo)}),
    "intermediate points": (INTERMEDIATE, {}),
    "split, left half": (LEFT_HALF, {}),
    "split, right half": (RIGHT_HALF, {}),
}


def judged(lines, given=None, budget=20.0):
    """The judgement, its ranges restricted to the symbols that occur."""
    occurring = set().union(*(line.free_symbols for line in lines)) if given else ()
    return check_derivation(lines, given={s: r for s, r in (given or {}).items() if s in occurring}, budget=budget)


def remarks(judgement):
    return [line.remark for line in judgement.lines]


def replaced(lines, number, line):
    return [*lines[: number - 1], line, *lines[number:]]


@pytest.mark.parametrize("name", PRINTED)
def test_a_printed_proof_is_proved(name):
    lines, given = PRINTED[name]
    found = judged(lines, given)
    assert found.status == PROVED and found.last_equals_first and found.first_wrong is None
    assert set(remarks(found)[1:]) <= {"follows", "no progress"} and remarks(found)[0] == "start"
    assert all(line.step.status == line.whole.status == PROVED for line in found.lines[1:])


def test_the_printed_proof_of_the_recursion_has_a_wrong_line_and_ends_well():
    found = check_derivation(RECURSION, given=INNER)
    assert remarks(found) == ["start", "follows", "follows", "wrong", "right again"]
    assert found.first_wrong == 4
    assert found.counterexample.values == {n: 2, i: 1, u: F(1, 3)}
    assert (found.counterexample.lhs, found.counterexample.rhs) == (F(4, 9), F(2, 3))
    assert found.status == REFUTED and found.last_equals_first and found.ends.status == PROVED
    assert found.lines[4].step.status == REFUTED and found.lines[4].whole.status == PROVED


def test_where_a_line_has_no_value_it_is_wrong():
    """At i = 0 and u = 0 the fourth line divides by 0, and the first does not."""
    found = check_derivation(RECURSION, given={n: (1, oo), i: (0, n)})
    assert found.first_wrong == 4 and found.counterexample.values == {n: 1, i: 0, u: 0}
    assert "undefined (division by 0) on the right" in repr(found)


@pytest.mark.parametrize(
    ("name", "number", "line", "values"),
    [
        # a sign
        ("derivative", 3, DERIVATIVE[2] + 2 * n * binomial(n - 1, i) * t**i * (1 - t) ** (n - i - 1), [2, 1, F(1, 2)]),
        ("hodograph", 5, n * Sum((b[j + 1] + b[j]) * B(j, n - 1, t), (j, 0, n - 1)), [1, F(1, 2)]),
        # an index
        ("derivative", 4, n * (B(i - 1, n - 1, t) - B(i - 1, n, t)), [2, 1, F(1, 2)]),
        (
            "hodograph",
            4,
            n * Sum(B(j, n - 1, t) * b[j + 2], (j, 0, n - 1)) - n * Sum(B(j, n - 1, t) * b[j], (j, 0, n - 1)),
            [1, F(1, 2)],
        ),
        (
            "split, right half",
            3,
            Sum(binomial(n, j) * (1 - u) ** (n - j) * u**j * g ** (n - j) * b[n - j], (j, 0, n)),
            [1, F(1, 2), F(1, 2)],
        ),
        # an exponent
        ("recursion, corrected", 2, binomial(n, i) * u**i * (1 - u) ** n, [2, 1, F(1, 2)]),
        ("split, left half", 4, LEFT_HALF[3].subs(n, n + 1), [0, F(1, 2), F(1, 2)]),
        # the bound of a sum, and a factor
        ("intermediate points", 3, Sum(B(i, k, t) * b[i + j], (i, 1, k)), [0, 0, F(1, 2)]),
        ("derivative of the operator form", 2, OPERATOR_DERIVATIVE[1] / n, [2, F(1, 2)]),
    ],
)
def test_a_slip_is_named_with_the_smallest_counterexample(name, number, line, values):
    lines, given = PRINTED[name]
    found = judged(replaced(lines, number, line), given)
    assert found.status == REFUTED and found.first_wrong == number
    assert list(found.counterexample.values.values()) == values
    following = "right again" if number < len(lines) else None
    assert remarks(found)[number:] == ([following] + ["follows"] * (len(lines) - number - 1) if following else [])
    assert found.last_equals_first == (number < len(lines))


@pytest.mark.parametrize("name", ["derivative", "recursion, corrected", "hodograph", "intermediate points"])
def test_no_slip_goes_unnoticed(name):
    """Every edit of a line that the exact evaluator finds false is the first wrong line, and none is PROVED."""
    lines, given = PRINTED[name]
    tried = 0
    for number in range(2, len(lines)):
        for mutant in list(mutants(lines[number - 1]))[::6]:
            wanted = {s: r for s, r in given.items() if s in mutant.free_symbols}
            truth = counterexample(statement(lines[0], mutant, wanted))
            found = judged(replaced(lines, number, mutant), given, budget=6)
            tried += 1
            if truth.counterexample is None and truth.undefined is None:
                assert found.first_wrong is None and found.status != REFUTED
            else:
                assert found.status == REFUTED and found.first_wrong == number
                assert found.last_equals_first and found.lines[number].remark in ("right again", "wrong")
    assert tried > 4


def test_a_line_after_a_wrong_line_is_still_wrong_while_it_follows():
    lines = [(1 + t) ** 2, 1 + t**2, (1 + t) ** 2 - 2 * t, 1 + 2 * t + t**2, (t + 1) ** 2]
    found = check_derivation(lines)
    assert remarks(found) == ["start", "wrong", "still wrong", "right again", "follows"]
    assert found.first_wrong == 2 and found.counterexample.values == {t: F(1, 2)}
    assert found.lines[2].step.status == PROVED and found.lines[2].whole.status == REFUTED
    assert found.lines[2].counterexample == (({t: F(1, 2)}, F(9, 4), F(5, 4)))
    assert found.last_equals_first


def test_a_false_beginning_with_correct_algebra_behind_it():
    """t B_{i,n} is not (i+1)/(n+1) B_{i,n+1}; what follows is right algebra, and the end is false."""
    lines = [
        t * B(i, n, t),
        (i + 1) / (n + 1) * B(i, n + 1, t),
        (i + 1) / (n + 1) * B(n + 1 - i, n + 1, 1 - t),
        (i + 1) / (n + 1) * binomial(n + 1, i) * t**i * (1 - t) ** (n + 1 - i),
    ]
    found = check_derivation(lines, given={i: (0, n)})
    assert remarks(found) == ["start", "wrong", "still wrong", "still wrong"]
    assert found.status == REFUTED and found.first_wrong == 2 and not found.last_equals_first
    assert found.counterexample.values == {n: 0, i: 0, t: F(1, 3)}
    assert all(line.step.status == PROVED for line in found.lines[2:])


def test_two_slips_are_two_wrong_lines_and_the_first_is_named():
    found = check_derivation([t, t + 1, t + 2, t + 2 - 1 + t * 0, t])
    assert remarks(found) == ["start", "wrong", "wrong", "wrong", "right again"]
    assert found.first_wrong == 2


def test_a_line_repeated_makes_no_progress():
    found = check_derivation([*UNITY[:3], UNITY[2], UNITY[3]])
    assert remarks(found)[3:] == ["no progress", "follows"] and found.status == PROVED
    assert found.lines[3].note == "the same as line 3" and found.lines[3].mark == "✓"
    found = check_derivation([t, t + 1, 1 + t])
    assert remarks(found) == ["start", "wrong", "no progress"] and found.lines[2].mark == "✗"
    assert "differs from line 1" in found.lines[2].note


def test_the_order_of_terms_and_factors_is_no_progress_and_anything_more_is():
    one, other = Add(t, u, Mul(2, u, t, evaluate=False), evaluate=False), Add(Mul(t, 2, u, evaluate=False), u, t)
    assert remarks(check_derivation([one, other])) == ["start", "no progress"]
    nested = Add(t, Add(u, x, evaluate=False), evaluate=False)
    assert remarks(check_derivation([nested, x + t + u])) == ["start", "no progress"]
    for line in (Add(t, t, u, x, evaluate=False) - t, Pow(t + u + x, 2, evaluate=False) / (t + u + x)):
        assert remarks(check_derivation([line, x + t + u])) == ["start", "no progress"]
    gathered = Add(t, t, evaluate=False)
    assert remarks(check_derivation([gathered, 2 * t])) == ["start", "follows"]
    assert remarks(check_derivation([Sum(b[i], (i, 0, n)), Sum(b[j], (j, 0, n))])) == ["start", "follows"]
    assert remarks(check_derivation([t * (u + 1), t * u + t])) == ["start", "follows"]


def test_what_is_checked_for_some_degrees_is_never_more_than_checked():
    """Beyond degree 40 the second line is false."""
    late = Mul(*[n - value for value in range(40)])
    found = check_derivation([t, t + late, t])
    assert remarks(found) == ["start", "checked only", "checked only"] and found.status == CHECKED
    assert found.lines[1].note.startswith(
        "exact for n = 0..8 and every value of the other symbols, and for nothing else"
    )
    assert found.lines[1].mark == "?" and found.first_wrong is None
    assert found.ends.status == PROVED and found.last_equals_first
    found = check_derivation([t, t + 1, t + late])
    assert remarks(found) == ["start", "wrong", "checked only"]
    assert found.lines[2].note.startswith("differs from line 2; against line 1: exact for n = 0..8")
    assert found.status == REFUTED and not found.last_equals_first


def stub(monkeypatch, decide):
    """Let the engine say what ``decide`` says of two lines, which are the numbers of places."""
    monkeypatch.setattr(chains, "decided", lambda claim, clock: decide(claim))


def decided(table):
    def decide(claim):
        status = table.get((str(claim.lhs), str(claim.rhs)), UNDECIDED)
        found = Counterexample({}, f"{claim.lhs}'", f"{claim.rhs}'") if status == REFUTED else None
        return Proof(status, "stub", counterexample=found)

    return decide


LETTERS = [Symbol(name, real=True) for name in "acdf"]


def test_two_equalities_settle_the_third(monkeypatch):
    stub(monkeypatch, decided({("a", "c"): PROVED, ("c", "d"): ARGUED, ("d", "f"): PROVED}))
    found = check_derivation(LETTERS)
    assert found.status == ARGUED and found.ends.status == ARGUED and found.last_equals_first
    assert found.lines[3].whole.method == "through line 3"
    stub(monkeypatch, decided({("a", "c"): PROVED, ("a", "d"): PROVED, ("a", "f"): PROVED}))
    found = check_derivation(LETTERS)
    assert found.status == PROVED and remarks(found)[1:] == ["follows"] * 3
    assert found.lines[2].note.startswith("through line 1")


@pytest.mark.parametrize(
    ("table", "expected", "sides"),
    [
        ({("a", "c"): REFUTED, ("c", "d"): PROVED}, ["wrong", "still wrong"], ("a'", "c'")),
        ({("a", "c"): PROVED, ("c", "d"): REFUTED}, ["follows", "wrong"], ("c'", "d'")),
        ({("a", "c"): PROVED, ("a", "d"): REFUTED}, ["follows", "wrong"], ("a'", "d'")),
        ({("a", "c"): REFUTED, ("a", "d"): PROVED}, ["wrong", "right again"], ("a'", "c'")),
        ({("c", "d"): REFUTED, ("a", "d"): PROVED}, ["wrong", "right again"], ("d'", "c'")),
        ({("c", "d"): PROVED, ("a", "d"): REFUTED}, ["wrong", "still wrong"], ("a'", "d'")),
        ({("c", "d"): CHECKED, ("a", "d"): REFUTED}, ["undecided", "checked only"], None),
        ({("c", "d"): REFUTED, ("a", "c"): CHECKED}, ["checked only", "wrong"], ("c'", "d'")),
        ({("a", "c"): REFUTED, ("c", "d"): REFUTED}, ["wrong", "undecided"], ("a'", "c'")),
        ({("a", "c"): REFUTED, ("c", "d"): UNDECIDED}, ["wrong", "undecided"], ("a'", "c'")),
        ({("a", "c"): INVALID, ("c", "d"): PROVED}, ["invalid", "follows"], None),
        ({("a", "c"): REFUTED, ("c", "d"): INVALID, ("a", "d"): REFUTED}, ["wrong", "still wrong"], ("a'", "c'")),
        ({}, ["undecided", "undecided"], None),
    ],
)
def test_a_remark_for_every_pair_of_verdicts(monkeypatch, table, expected, sides):
    stub(monkeypatch, decided(table))
    found = check_derivation(LETTERS[:3])
    assert remarks(found)[1:] == expected
    where = found.counterexample
    assert (where and where[1:]) == sides
    statuses = {verdict.status for line in found.lines[1:] for verdict in (line.step, line.whole)}
    assert found.status == (INVALID if "invalid" in expected else REFUTED if REFUTED in statuses else UNDECIDED)


def test_a_line_that_returns_to_the_first_is_right_again_even_where_nothing_is_proved(monkeypatch):
    stub(monkeypatch, decided({("a", "c"): REFUTED, ("c", "a"): REFUTED}))
    found = check_derivation([LETTERS[0], LETTERS[1], LETTERS[0]])
    assert remarks(found) == ["start", "wrong", "right again"] and found.lines[2].note.startswith("the same as line 1")


def test_a_symbol_of_one_line_only_must_cancel():
    found = check_derivation([t, t + (x + 1) ** 2 - x**2 - 2 * x - 1])
    assert found.status == PROVED and found.lines[1].note.endswith("x is in no other line, and cancels")
    found = check_derivation([t, t + x * (x - 1)], given={x: Interval(0, 1)})
    assert found.first_wrong == 2 and "x is in no other line" in found.lines[1].note
    assert check_derivation([t + x - y, t]).lines[1].remark == "wrong"


def test_ranges_given_for_symbols_of_some_lines_only():
    lines = [Sum(B(j, n, t), (j, 0, n)), B(i, n, t) + 1 - B(n - i, n, 1 - t), Integer(1)]
    found = check_derivation(lines, given={n: (2, oo), i: (0, n), t: Interval(0, 1)})
    assert found.status == PROVED
    assert set(found.lines[1].step.statement.ranges) == {n, i, t}
    assert set(found.ends.statement.ranges) == {n, t}


def test_a_range_that_may_be_empty_counts_in_lines_without_its_symbol():
    """Where i goes from 1 to n - 1, nothing is said of n = 0 and n = 1."""
    lines = [n * (n - 1), factorial(n) / factorial(n - 2), n * (n - 1) + B(i, n, t) - B(n - i, n, 1 - t)]
    assert check_derivation(lines, given={i: (1, n - 1)}).status == PROVED
    assert check_derivation(lines, given={i: (0, n)}).counterexample.values == {n: 0}
    assert check_derivation([n, n + 1, lines[2] - n * (n - 2) + 1], given={i: (1, n - 1)}).counterexample.values == {
        n: 2,
        i: 1,
    }


def test_between_two_ends_that_are_no_whole_numbers_there_need_be_none():
    """No z is there for q = 0, so that nothing is said of it: neither of n, m, s = 30, 0, 0, where the ends differ."""
    m, q, s, z = (Symbol(name, integer=True) for name in "mqsz")
    given = {n: (0, oo), m: (n - 30, oo), q: (m, oo), s: (30 - n, q), z: (0, q - Rational(1, 2))}
    found = check_derivation([s, s + binomial(z, q), s + KroneckerDelta(q, 0)], given=given)
    assert found.ends.status == PROVED
    assert z in found.ends.statement.ranges
    without = {symbol: values for symbol, values in found.ends.statement.ranges.items() if symbol != z}
    with pytest.raises(ReplayFailed, match="for some values z, which is in a part of the proof only, has none"):
        replace(found.ends, statement=found.ends.statement._replace(ranges=without)).replay()


def test_what_a_symbol_is_all_lines_say_together():
    """In the third line m is the end of a sum, so it is an integer in the first two, and the floor of m is m."""
    m = Symbol("m")
    lines = [m + 0, floor(m), Sum(1, (k, 1, m))]
    assert check_derivation(lines, given={m: (0, 5)}).status == PROVED
    assert check_derivation(lines[:2], given={m: (0, 5)}).status == REFUTED
    assert check_derivation(lines, given={m: (3, 3)}).status == PROVED


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("t", "'t' is not an expression"),
        (None, "None is not an expression"),
        (True, "True is not an expression"),
        (0.5, "0.5 is not an expression"),
        (Matrix([1]), "is not an expression"),
        (Float("0.5") * t, "is a float"),
        (Integral(t, t), "has no limits"),
        (Symbol("t") + 1, "two different symbols are called t"),
        (E - 1, "an operator on one side and points on the other"),
        (Derivative(n * t, n), "which is an integer"),
        (Symbol("f", commutative=False), "noncommutative"),
    ],
)
def test_an_invalid_line_is_named_and_the_others_are_judged(line, why):
    lines = [b[0] * t * n, n * b[0] * t + b[0] - b[0], line, n * b[0] * (t + 1), n * t * b[0]]
    found = check_derivation(lines)
    assert found.status == INVALID and found.note == "line 3 is invalid"
    assert remarks(found) == ["start", "no progress", "invalid", "wrong", "right again"]
    assert why in found.lines[2].note and found.lines[2].step is None
    assert found.first_wrong == 4 and found.last_equals_first


def test_an_invalid_first_or_last_line_leaves_the_whole_unjudged():
    found = check_derivation(["t", t, t + 0 * u, (t + 1) - 1])
    assert found.status == INVALID and found.ends is None and not found.last_equals_first
    assert remarks(found) == ["invalid", "start", "no progress", "no progress"]
    assert check_derivation([t, t, None]).ends is None
    assert remarks(check_derivation(["a", "c"])) == ["invalid", "invalid"]


def test_lines_that_have_no_value_at_a_point_are_invalid():
    found = check_derivation([1 / t, 2 / t - 1 / t, (1 + t) / t - 1])
    assert found.status == INVALID and set(remarks(found)[1:]) == {"invalid"}
    assert "neither side has a value at t = 0" in found.lines[1].note


@pytest.mark.parametrize("lines", [[], [t], ["t"]])
def test_fewer_than_two_lines_are_no_derivation(lines):
    found = check_derivation(lines)
    assert (found.status, found.note) == (INVALID, "a derivation has at least two lines")
    assert found.ends is None and found.first_wrong is None and found.counterexample is None


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ({u: (0, 1)}, "a range is given for u, which does not occur"),
        ({"t": (0, 1)}, "a range is given for 't', which is not a symbol"),
        ({t: (1, 0)}, "range of t"),
        ({t: 3}, "the range of t is 3"),
        ([1], "given is [1], not a dict of ranges"),
        ({n: (0, Symbol("t"))}, "two different symbols are called t"),
    ],
)
def test_a_fault_in_what_is_given_is_no_fault_of_a_line(given, why):
    found = check_derivation([n * t, t * n + 1 - 1], given=given)
    assert found.status == INVALID and why in found.note
    assert (
        remarks(found) == ["undecided", "undecided"] and why in repr(found) and why.split()[0] in found._repr_latex_()
    )


def test_an_expression_nested_too_deeply_is_an_invalid_line():
    deep = t
    for _ in range(400):
        deep = Pow(1 + deep, 2, evaluate=False)
    found = check_derivation([t, deep, t])
    assert remarks(found) == ["start", "invalid", "no progress"]
    assert "nested" in repr(found) and "nested" in found._repr_latex_()


@pytest.mark.parametrize("budget", [0, 0.5, 2])
def test_the_budget_is_kept(budget):
    heavy = Sum(step(t) ** n * step(u) ** n, (k, 0, 4000))
    lines = [heavy, 4001 * step(u) ** n * step(t) ** n + 0 * t, heavy * 1 + t - t, heavy + Sum(r, (r, 0, 0))] * 3
    begin = perf_counter()
    found = check_derivation(lines, budget=budget)
    assert perf_counter() - begin < budget + 4
    assert found.status in (UNDECIDED, CHECKED, PROVED) and len(found.lines) == len(lines)
    assert found.seconds <= perf_counter() - begin


def test_a_heavy_line_leaves_time_for_the_others():
    heavy = Sum(step(t) ** n * step(u) ** n, (k, 0, 4000)) * b[0]
    found = check_derivation([heavy, 4002 * (step(u) * step(t)) ** n * b[0], t * b[0], u * b[0]], budget=2)
    assert found.lines[3].remark in ("wrong", "undecided") and found.lines[3].step.status == REFUTED


def test_numbers_are_lines_too():
    found = check_derivation([Rational(1, 2), F(1, 2), 1, Rational(2, 4)])
    assert remarks(found) == ["start", "no progress", "wrong", "right again"]
    assert found.counterexample.values == {}


def test_a_judgement_in_a_terminal():
    found = check_derivation([t * B(0, 1, t), t * (1 + t), t - t**2, "x"], given={t: Interval(0, 1)})
    assert isinstance(found, Judgement)
    assert repr(found).splitlines() == [
        "  1.   t*B(0, 1, t)",
        "✗ 2. = t*(t + 1)    wrong: t = 1/2: 1/4 on the left, 3/4 on the right",
        "✓ 3. = -t**2 + t    right again: equals line 1, as line 2 does not",
        "✗ 4. = x    invalid: 'x' is not an expression",
        "INVALID: line 4 is invalid; line 2 is the first wrong one",
    ]


def test_a_judgement_in_a_notebook():
    shown = check_derivation(RECURSION, given=INNER)._repr_latex_()
    assert shown.startswith("$$\\begin{aligned}\n& B_{i,n}(u) \\\\[1ex]\n&= ")
    assert shown.endswith("the last line equals the first}\n\\end{aligned}$$")
    assert r"\text{✓ follows: ratio of terms}" in shown and r"\text{✗ wrong}" in shown
    assert r"n = 2,\quad i = 1,\quad u = \frac{1}{3}:\quad \text{left: } \frac{4}{9}" in shown
    assert r"& \textbf{REFUTED} && \text{line 4 is the first wrong one; " in shown
    unknown = check_derivation([t, "x_1"])._repr_latex_()
    assert r"&= \text{x}\_\text{1} && \text{✗ invalid: 'x}\_\text{1' is not an expression}" in unknown
