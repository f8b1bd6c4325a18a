"""prove: the verdicts that need no method for symbolic n, how they show themselves, and that the budget is kept."""

import re
from fractions import Fraction as F
from time import perf_counter

import pytest
from hypothesis import given as generated
from hypothesis import settings
from proof_trees import TREES, built, by_hand
from sympy import (
    Derivative,
    Eq,
    Ge,
    Gt,
    Integral,
    Interval,
    KroneckerDelta,
    Le,
    Max,
    Mul,
    Rational,
    Sum,
    Symbol,
    binomial,
    expand,
    factorial,
    floor,
    oo,
    sqrt,
)

from bezteach.bench import judge
from bezteach.proof import (
    CHECKED,
    INVALID,
    PROVED,
    REFUTED,
    UNDECIDED,
    Budget,
    OutOfTime,
    Undefined,
    evaluate,
    prove,
    statement,
)
from bezteach.proof.fixed import by_cases
from bezteach.symbolic import B, E, Step, b, i, j, k, n, step, t, u

c = Symbol("c", real=True)
m = Symbol("m", integer=True, nonnegative=True)
SYMMETRY = (B(i, n, t), B(n - i, n, 1 - t))


def cases(lhs, rhs=None, given=None, seconds=60):
    """The verdict of this method alone, the others left out."""
    return by_cases(statement(lhs, rhs, given), Budget(seconds))


def test_finite_ranges_are_proved_by_all_cases():
    proof = cases(*SYMMETRY, {n: (2, 4), i: (0, n)})
    assert (proof.status, proof.method, proof.note) == (
        PROVED,
        "all cases",
        "all 12 cases, as identities of polynomials",
    )
    assert cases(step(t) ** 3 * b[0], Sum(B(i, 3, t) * b[i], (i, 0, 3))).status == PROVED
    assert cases(Sum(B(i, 5, t), (i, 0, 5)), 1).note == "the only case, as identities of polynomials"
    assert cases(binomial(6, 2) - factorial(5) / 8, 0).status == PROVED


def test_a_range_in_a_range():
    claim = (B(i, n, t) * B(j, n, t), B(j, n, t) * B(n - i, n, 1 - t))
    assert cases(*claim, {n: (0, 3), i: (0, n), j: (i, n)}).note.startswith("all 20 cases")


def test_inequalities_of_numbers_are_proved_by_all_cases_and_others_are_not():
    assert cases(Le(binomial(n, k), binomial(8, 4)), given={n: (0, 8), k: (0, n)}).status == PROVED
    assert cases(Ge(B(i, 3, t), 0), given={i: (0, 3), t: Interval(0, 1)}) is None
    assert cases(Ge(B(0, n, t) + B(1, n, t) + n, 1), given={n: (0, 1)}).status == PROVED


def test_a_degree_without_end_is_only_checked_and_says_which():
    proof = cases(*SYMMETRY, {n: (1, oo), i: (0, n)})
    assert (proof.status, proof.method) == (CHECKED, "fixed degrees")
    assert proof.note == "exact for n = 1..8 and every value of the other symbols, and for nothing else"
    assert (
        "n = 0..5, m = 0..5"
        in cases(B(i, m, t) * B(j, n, t), B(j, n, t) * B(m - i, m, 1 - t), {i: (0, m), j: (0, n)}).note
    )
    assert "n = 100..104" in cases(B(0, n, t), B(n, n, 1 - t), {n: (100, oo)}).note


def test_a_degree_with_too_many_values_is_only_checked():
    proof = cases(B(0, n, t), B(n, n, 1 - t), {n: (0, 10**9)})
    assert proof.status == CHECKED and "n = 0..8" in proof.note
    # Where it fails first lies beyond what is looked at, or within, or nowhere.
    wrong = Mul(*[n - value for value in range(40)])
    assert prove(wrong, 0).status == CHECKED
    assert prove(wrong, 0, given={n: (0, 60)}).status == REFUTED
    assert prove(wrong, 0, given={n: (0, 60)}).counterexample.values == {n: 40}
    assert prove(wrong, 0, given={n: (0, 39)}).status == PROVED


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (t / t**2, 1 / t),
        (B(1, 2, t) / (1 - t), 2 * t),
        ((t**2 - 1) / (t - 1), t + 1),
        (B(1, 2, t) * (1 - t) ** -1, 2 * t),
    ],
)
def test_dividing_by_a_polynomial_proves_only_where_it_is_not_0(lhs, rhs):
    """At the zero of the divisor the left has no value, so they are refuted or invalid unless it is excluded."""
    assert cases(lhs, rhs) is None
    assert prove(lhs, rhs).status in (REFUTED, INVALID)
    verdict = prove(lhs, rhs, given={t: Interval.open(2, 3)})
    assert verdict.status == PROVED
    verdict.replay()


def test_a_false_identity_that_holds_at_every_usual_value_is_refuted_as_polynomials():
    usual = [F(1, 2), F(1, 3), F(2), F(0), F(1), F(-1), F(3, 4), F(3), F(-5, 2)]
    vanishing = Mul(*[t - Rational(value.numerator, value.denominator) for value in usual])
    verdict = prove(vanishing, 0)
    assert verdict.status == REFUTED and verdict.counterexample.values == {t: F(1, 7)}
    assert prove(n * vanishing, 0).counterexample.values == {n: 1, t: F(1, 7)}


def test_a_false_statement_about_points_is_refuted_only_by_the_letters():
    """Numbers in the place of the points could agree by chance: b_0 b_1 = b_1 b_0, but b_0 is not b_1."""
    assert prove(b[0] * b[1] - b[1] * b[0], 0).status == PROVED
    assert prove(b[0], b[1]).status == REFUTED
    assert prove(E**2 - 1, (E - 1) * (E + 1)).status == PROVED
    assert prove(E, 1).status == REFUTED


def test_empty_ranges_are_invalid_where_it_shows():
    assert prove(B(i, n, t), 7, given={n: (0, 3), i: (n + 1, n)}).note == "the ranges of the integers allow no value"
    assert prove(t, t, given={t: Interval.open(1, 1)}).status == INVALID
    assert prove(b[i] + b[n], 0, given={i: (n - 1, 0)}).note.startswith("at n = 0 the range of i goes beyond")


def test_a_range_that_has_no_end_only_far_away_is_invalid():
    """The refuter does not go as far as n = 20."""
    assert prove(t + i, i + t, given={i: (0, 1 / (n - 20))}).note.startswith("the range of i may have no end: n - 20")
    assert prove(t + i, i + t, given={n: (21, oo), i: (0, n / (n - 20))}).status == PROVED
    for end in (floor(1 / (n - 20)), binomial(20 - n, 2), Max(n, 1 / (n - 20))):
        assert prove(t + i, i + t, given={i: (0, end)}).note.startswith("the range of i may have no end")
    for end in (floor(n / 2), n**2, 2**n, binomial(n, 2), Max(n, 3)):
        assert prove(t + i, i + t, given={i: (0, end), t: Interval(0, end)}).status == PROVED
    assert prove(t, t, given={n: (0, oo), t: Interval(0, sqrt(n))}).status == INVALID  # a root is not looked into


def test_a_range_of_a_real_letter_may_end_at_a_root():
    for values in (Interval(sqrt(2), oo), Interval(0, (1 + sqrt(5)) / 2)):
        assert prove(t * (t + 1), t * t + t, given={t: values}).status == PROVED
        assert (
            prove(Ge(t, Rational(1, 3)), given={t: values}).status == UNDECIDED
        )  # the refuter has no irrational numbers
    assert prove(t + i, i + t, given={i: (0, sqrt(2))}).status == INVALID


def test_a_range_that_goes_beyond_what_is_assumed_only_far_away_is_invalid():
    """At m = 21 the range of n, which is no negative number, begins at -1; SymPy makes 0 of delta(n, -1) at once."""
    m = Symbol("m", integer=True)
    sides = Sum(KroneckerDelta(n, k), (k, -1, -1)) + m, m
    assert prove(*sides, given={n: (20 - m, oo)}).note == "the range of n may go beyond what is assumed of it"
    assert prove(*sides, given={m: (0, 20), n: (20 - m, oo)}).status == PROVED
    assert prove(t + m, m + t, given={m: (0, 20), t: Interval(m / 2 - 10, 20 - m)}).status == PROVED
    for start in (400 - m**2, 20 - floor(m / 2), 20 - Max(m, 3)):
        assert prove(*sides, given={n: (start, oo)}).note == "the range of n may go beyond what is assumed of it"
    assert prove(*sides, given={n: (m**2, oo)}).status == PROVED


def test_what_is_too_large_to_be_multiplied_out_is_undecided_at_once():
    """It is true, but of some 80,000 terms."""
    large = 2**n * (n + t + u + 1) ** 300
    verdict = prove(Ge(large + 1, large - t), given={t: Interval(0, 1), u: Interval(0, 1)}, budget=1)
    assert verdict.status == UNDECIDED and verdict.note.endswith("and too large to be multiplied out")


@settings(max_examples=120, deadline=None, derandomize=True)
@generated(TREES, TREES)
def test_what_is_refuted_differs_and_what_is_proved_agrees_when_it_is_written_out(left, right):
    verdict = prove(built(left), built(right), given={n: (0, 2), i: (0, 2)} | {t: Interval(0, 1)}, budget=5)
    if verdict.status == INVALID:
        assert "does not occur" in verdict.note or "neither side" in verdict.note
        verdict = prove(built(left) + n + i + t, built(right) + n + i + t, given={n: (0, 2), i: (0, 2), t: (0, 1)})
    found = verdict.counterexample
    if found and not any(isinstance(side, Undefined) for side in found[1:]):
        places = {name: Rational(value.numerator, value.denominator) for name, value in found.values.items()}
        assert expand(by_hand(left, places) - by_hand(right, places)) != 0
    if verdict.status == PROVED:
        for degree in range(3):
            places = {n: Rational(degree), i: Rational(2 - degree), t: Rational(2, 5), u: Rational(-7, 3)}
            assert expand(by_hand(left, places) - by_hand(right, places)) == 0


def test_it_is_undecided_when_nothing_applies():
    """True, but the bounds of the two functions are not independent of one another."""
    claim = Le(B(0, n, t) * B(1, n, t), Rational(1, 4), evaluate=False)
    verdict = prove(claim, given={n: (1, oo), t: Interval(0, 1)}, budget=3)
    assert (verdict.status, verdict.method, verdict.steps) == (UNDECIDED, "", ())
    assert re.fullmatch(r"no counterexample: \d+ points checked", verdict.note)


@pytest.mark.parametrize(
    "claim",
    [
        (Sum(Sum(Sum(B(i, 300, t), (i, 0, 300)), (j, 0, 300)), (k, 0, 300)), 301**2),
        (Sum(step(t) ** n * step(u) ** n, (k, 0, 4000)), 4001 * step(u) ** n * step(t) ** n),
        (
            Integral(Derivative((t + u + c) ** n, (t, 2)), (t, 0, 1)),
            Integral(Derivative((t + u + c) ** n, (t, 2)), (t, 0, u)),
        ),
        (
            Sum(b[i] * b[j] * b[k], (i, 0, n), (j, 0, n), (k, 0, 99 * n)),
            Sum(b[i], (i, 0, n)) ** 2 * Sum(b[k], (k, 0, 99 * n)),
        ),
    ],
)
def test_the_budget_is_kept(claim):
    begin = perf_counter()
    verdict = prove(*claim, budget=0.3)
    assert perf_counter() - begin < 4
    assert verdict.status in (UNDECIDED, CHECKED, PROVED, REFUTED)
    if verdict.status == PROVED:  # true, and with a proof that needs no more time to check
        verdict.replay()


UNIT = ", ".join(f"0 <= {letter} <= 1" for letter in "stuvwxyz")


@pytest.mark.parametrize(
    ("text", "given", "statuses"),
    [
        # SymPy multiplied all denominators, those that divide one another too.
        ("sum(1/(n+k)^5,k,1,11) = sum((n^2+2*n*k+k^2)/(n+k)^7,k,1,11)", "", (PROVED,)),
        ("sum(C(n,k)*(k+300)!/k!,k,0,n) = sum(C(n,n-k)*(k+300)!/k!,k,0,n)", "", (PROVED, CHECKED)),
        # Each symbol that is eliminated from these may square the number of inequalities.
        (
            "i+j+k+l+m+n+p+q = q+p+n+m+l+k+j+i",
            "i<=20, j<=20-i, k<=i-j+5, l<=j-i+k+5, m<=i-j-k+l+9, n<=j+k-i-l+m+9, p<=i+k-j-l+m-n+9, q<=j+l-i-k+n-m+p+9",
            (PROVED,),
        ),
        # Multiplied out these have 1771 and 92378 terms.
        ("sum((k+i+j)^20 C(n,k),k,0,n) = sum((n-k+i+j)^20 C(n,n-k),k,0,n)", "", (PROVED, CHECKED, UNDECIDED)),
        ("(i+j+k+l+m+n+p+q+r+10)! >= (i+j+k+l+m+n+p+q+r)! (i+j+k+l+m+n+p+q)", "", (PROVED, UNDECIDED)),
        ("diff(t^200 (1-t)^200, t, 200) = diff((1-t)^200 t^200, t, 200)", "", (PROVED, CHECKED, UNDECIDED)),
        ("i*j+k*l+m*n+p*q+r^2 >= 0", ", ".join(f"{letter}<=20" for letter in "ijklmnpqr"), (PROVED, UNDECIDED)),
        # Each real symbol multiplies the number of the coefficients that are looked at.
        ("(s+t+u+v+w+x+y+z)^2 + 1 > s+t+u+v+w+x+y+z", UNIT, (PROVED, UNDECIDED)),
        ("s+t+u+v+w+x+y+z+1 > (s+t+u+v+w+x+y+z)/9 - s*t", UNIT, (PROVED, UNDECIDED)),
        ("1/((s+t+u+v+w+x+y+z)^2+1) = (s+1)/(s+1)/((s+t+u+v+w+x+y+z)^2+1)", UNIT, (PROVED, CHECKED, UNDECIDED)),
    ],
)
def test_no_step_takes_longer_than_the_budget(text, given, statuses):
    """Each of these once took a minute or more in one step, which nothing can interrupt."""
    begin = perf_counter()
    assert judge(text, given).status in statuses
    assert perf_counter() - begin < 30


class Turns(Budget):
    """A budget of so many turns of loops, so that a test can stop the engine anywhere."""

    def __init__(self, turns):
        super().__init__(60)
        self.turns = turns

    def spend(self):
        self.turns -= 1
        if self.turns < 0:
            raise OutOfTime


@pytest.mark.parametrize("turns", range(0, 200, 3))
def test_out_of_time_half_way_nothing_is_claimed_that_was_not_done(turns):
    """Both fail at n = i = 6 only; out of time before that, the degree 6 may not be listed."""
    fails = KroneckerDelta(n, 6) * KroneckerDelta(i, 6)
    proof = by_cases(statement(fails, 0, {n: (0, 6), i: (0, n)}), Turns(turns))
    assert proof is None or proof.status == REFUTED
    proof = by_cases(statement(fails, 0, {n: (0, oo), i: (0, n)}), Turns(turns))
    assert proof is None or proof.status == REFUTED or any(f"n = 0..{last} " in proof.note for last in range(6))


def test_out_of_time_half_way_the_degrees_that_were_done_are_listed():
    claim = statement(*SYMMETRY, {i: (0, n)})
    notes = {proof.note for turns in range(400) if (proof := by_cases(claim, Turns(turns)))}
    assert "exact for n = 0..3 and every value of the other symbols, and for nothing else" in notes
    assert len(notes) == 9


def test_no_budget_no_verdict():
    assert prove(*SYMMETRY, given={i: (0, n)}, budget=0).status == UNDECIDED
    assert prove(sum(b[0] * t for _ in range(3)), 3 * t * b[0], budget=0).status == UNDECIDED


def test_prove_takes_two_sides_or_the_relation():
    one, two = prove(*SYMMETRY), prove(Eq(*SYMMETRY, evaluate=False))
    assert (one.status, one.note) == (two.status, two.note)
    assert one.statement == two.statement


def test_the_steps_say_what_both_sides_are():
    verdict = cases(*SYMMETRY, given={n: (1, 1), i: (0, n)})
    assert verdict.steps[0] == Step(1 - t, "both sides, expanded for n = 1, i = 0")
    assert evaluate(verdict.steps[1].expression, {t: F(1, 3)}) == F(1, 3)


def test_a_verdict_in_a_terminal():
    verdict = prove(t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t), given={i: (0, n)})
    assert repr(verdict) == (
        "REFUTED (refuter): t*B(i, n, t) = (i + 1)*B(i, n + 1, t)/(n + 1); "
        "n = 0, i = 0, t = 1/3: 1/3 on the left, 2/3 on the right; 2 points checked"
    )
    assert repr(prove(t, t, given={u: (0, 1)})) == "INVALID: a range is given for u, which does not occur"
    assert "\n" not in repr(prove(*SYMMETRY))
    assert verdict.seconds > 0


def test_a_verdict_in_a_notebook():
    verdict = prove(t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t), given={i: (0, n)})
    shown = verdict._repr_latex_()
    assert r"\textbf{REFUTED}" in shown and r"n = 0,\quad i = 0,\quad t = \frac{1}{3}" in shown
    assert r"\text{left: } \frac{1}{3} \qquad \text{right: } \frac{2}{3}" in shown
    assert verdict.statement.latex() in shown
    missing = prove(B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, t))._repr_latex_()
    assert r"\text{right: } \text{undefined (B of degree -1)}" in missing
    assert (
        r"\text{a range is given for x}\_\text{1, which does not occur}"
        in prove(t, t, given={Symbol("x_1"): (0, 1)})._repr_latex_()
    )


def test_inequalities_of_the_course_are_proved_for_every_n():
    """0 <= B <= 1, and the greatest value at i/n."""
    on_the_curve = {i: (0, n), t: Interval(0, 1)}
    assert prove(Ge(B(i, n, t), 0, evaluate=False), given=on_the_curve).status == PROVED
    assert prove(Le(B(i, n, t), 1, evaluate=False), given=on_the_curve).status == PROVED
    highest = prove(Le(B(i, n, t), B(i, n, i / n), evaluate=False), given=on_the_curve | {n: (1, oo)})
    assert highest.status == PROVED
    assert prove(Gt(B(i, n, t), 0, evaluate=False), given=on_the_curve).status == REFUTED
    assert prove(Le(B(i, n, t), Rational(1, 2), evaluate=False), given=on_the_curve).status == REFUTED
