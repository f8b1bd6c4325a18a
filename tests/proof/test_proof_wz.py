"""Sums of hypergeometric terms with a telescoping certificate: no false one is ever proved."""

from dataclasses import replace

import pytest
from proof_claims import m, some_mutants
from sympy import Eq, Function, Integer, Rational, Sum, Symbol, binomial, factorial, oo

from bezteach.proof import Budget, InvalidStatement, OutOfTime, counterexample, prove, statement
from bezteach.proof.certificate import ByTelescoping, Lemma
from bezteach.proof.equations.absorbing import absorbed
from bezteach.proof.equations.gosper import antidifference
from bezteach.proof.equations.wz import by_wz
from bezteach.proof.errors import ReplayFailed
from bezteach.proof.replaying.replay import check_certificate
from bezteach.proof.terms.terms import Failure
from bezteach.symbolic import B, i, j, k, n, r, t

C = binomial
x = Symbol("x", real=True)

CLAIMS = {
    "squares": (Sum(C(n, k) ** 2, (k, 0, n)), C(2 * n, n), {}),
    "squares from 3": (Sum(C(n, k) ** 2, (k, 0, n)), C(2 * n, n), {n: (3, oo)}),
    "weighted squares": (Sum(k * C(n, k) ** 2, (k, 0, n)), n * C(2 * n - 1, n - 1), {n: (1, oo)}),
    "Vandermonde": (Sum(C(m, k) * C(n, r - k), (k, 0, r)), C(m + n, r), {}),
    "Vandermonde, where it is not 0": (Sum(C(m, k) * C(n, r - k), (k, 0, r)), C(m + n, r), {r: (0, m + n)}),
    "Vandermonde, turned": (Sum(C(n, k) * C(m, k), (k, 0, n)), C(n + m, n), {}),
    "coefficients of a product": (Sum(C(n, i) * C(m, k - i) / C(n + m, k), (i, 0, k)), Integer(1), {k: (0, m + n)}),
    "rows of the elevation": (
        Sum(C(n, i) * C(m, k - i) / C(n + m, k), (k, i, i + m)),
        (n + m + 1) / (n + 1),
        {i: (0, n)},
    ),
    "shifted squares": (Sum(C(n, k) * C(n, k + r), (k, 0, n)), C(2 * n, n + r), {}),
    "central": (Sum(C(2 * k, k) * C(2 * n - 2 * k, n - k), (k, 0, n)), 4**n, {}),
    "hockey stick": (Sum(C(k, m), (k, 0, n)), C(n + 1, m + 1), {}),
    "hockey stick from m": (Sum(C(k, m), (k, m, n)), C(n + 1, m + 1), {n: (m, oo)}),
    "two sticks": (Sum(C(k, m) * C(n - k, r), (k, 0, n)), C(n + 1, m + r + 1), {}),
    "diagonal": (Sum(C(m + k, k), (k, 0, n)), C(m + n + 1, n), {}),
    "alternating": (Sum((-1) ** k * C(n, k) * C(2 * n - k, n), (k, 0, n)), Integer(1), {}),
    "alternating, central": (Sum((-1) ** k * C(n, k) * C(2 * k, k) * 4 ** (n - k), (k, 0, n)), C(2 * n, n), {}),
    "Dixon": (
        Sum((-1) ** k * C(2 * n, k) ** 3, (k, 0, 2 * n)),
        (-1) ** n * factorial(3 * n) / factorial(n) ** 3,
        {},
    ),
}


@pytest.mark.parametrize("name", CLAIMS)
def test_proved_for_every_n_and_replayed(name):
    lhs, rhs, ranges = CLAIMS[name]
    verdict = prove(lhs, rhs, given=ranges, budget=60)  # 1 or 2 s alone; a machine may be busy
    assert (verdict.status, verdict.method) == ("PROVED", "WZ certificate") and "from" in verdict.note
    verdict.replay()


def test_a_literal_certificate():
    """(n+1) C(n+1,k)^2 - 2 (2n+1) C(n,k)^2 is a difference in k of what Wilf and Zeilberger's pair gives, times R."""
    verdict = prove(*CLAIMS["squares"][:2])
    symbol, p, q, telescope, lemmas = verdict.certificate
    assert (symbol, p, (q - 2 * (2 * n + 1)).expand()) == (n, n + 1, 0)
    for degree in range(1, 7):
        for place in range(degree + 1):
            at = {n: degree, Symbol("k", integer=True): place}
            expected = -(Rational(3 * degree + 3 - 2 * place) * C(degree, place - 1) ** 2)
            assert telescope.subs(at) == expected
    assert len(lemmas) == 4


def test_the_steps_name_certificate_telescoping_ends_and_first_case():
    steps = prove(*CLAIMS["squares"][:2]).steps
    assert isinstance(steps[0].left, Function("G")) and "certificate" in steps[0].reason
    assert "telescopes" in steps[1].reason and "from 0 to n - 1" in steps[1].reason
    assert "ends" in steps[2].reason and steps[3].reason == "the side without the sum"
    assert steps[4].reason == "both sides for n = 0" and steps[4].expression.rhs == 1
    assert "by induction: n + 1 is never 0" in steps[5].reason
    assert steps[5].expression == Eq(*CLAIMS["squares"][:2], evaluate=False)


@pytest.mark.parametrize(
    ("lhs", "rhs", "ranges"),
    [
        (Sum(C(n, k) ** 2, (k, 0, n)), C(2 * n, n) + 1, {}),
        (Sum(C(n, k) ** 2, (k, 1, n)), C(2 * n, n), {}),
        (Sum(C(n, k) ** 2, (k, 0, n - 1)), C(2 * n, n), {n: (1, oo)}),
        (Sum(C(n, k) ** 2, (k, 0, n)), 2 * C(2 * n, n), {}),
        (Sum(C(n, k) ** 3, (k, 0, n)), C(2 * n, n), {}),
        (Sum(C(m, k) * C(n, r - k), (k, 0, r)), C(m + n, r + 1), {}),
        (Sum(C(m, k) * C(n, r - k), (k, 1, r)), C(m + n, r), {}),
        (Sum(C(m, k) * C(n, r - k), (k, 0, r - 1)), C(m + n, r), {r: (1, oo)}),
        (Sum(C(n, i) * C(m, k - i) / C(n + m, k), (i, 0, k)), 1, {}),  # undefined for k > m + n
        (Sum(C(n, i) * C(m, k - i) / C(n + m, k), (i, 1, k)), 1, {k: (0, m + n)}),
        (Sum(C(k, m), (k, 0, n)), C(n + 1, m), {}),
        (Sum((-1) ** k * C(2 * n, k) ** 3, (k, 0, 2 * n)), factorial(3 * n) / factorial(n) ** 3, {}),
        # True from some n on, or for all n but one: the first case, and a p that is 0, must not be passed over.
        (Sum(C(n, k) ** 2, (k, 0, n)) * n, n * C(2 * n, n) + 1, {}),
        (Sum(C(n, k) ** 2, (k, 0, n)) * (n - 3), (n - 3) * C(2 * n, n) + factorial(n) / (n + 1), {}),
        (Sum(C(n, k) ** 2, (k, 0, n - 4)), C(2 * n, n), {}),
    ],
)
def test_false_twins_are_refuted_never_proved(lhs, rhs, ranges):
    found = statement(lhs, rhs, ranges)
    assert by_wz(found, Budget(20)) is None
    search = counterexample(found, Budget(5))
    assert search.counterexample is not None or search.undefined is not None


@pytest.mark.parametrize("name", CLAIMS)
def test_no_false_mutant_is_proved(name):
    """What the prover proves of the mutants is judged by the exact evaluator, which knows nothing of the prover.

    Every sixth mutant is tried.
    """
    lhs, rhs, ranges = CLAIMS[name]
    tried = 0
    for left, right in some_mutants(lhs, rhs, name, 6):
        occurring = left.free_symbols | right.free_symbols
        try:
            found = statement(left, right, {s: e for s, e in ranges.items() if s in occurring})
            tried += 1
            proof = by_wz(found, Budget(3))
        except (InvalidStatement, OutOfTime):
            continue
        if proof is not None:
            judged = counterexample(found, Budget(1))
            assert judged.counterexample is None and judged.undefined is None, found
    assert tried >= 1


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (Sum(B(i, n, t), (i, 0, n)), 1),
        (Sum(C(n, k), (k, 0, n)) * Sum(C(n, k), (k, 0, n)), 4**n),
        (Sum(C(n, k) * C(n, j), (k, 0, n), (j, 0, n)), 4**n),
        (Sum(k**2, (k, 0, n)), n * (n + 1) * (2 * n + 1) / 6),
        (Sum(C(n, k) ** 2 * x**k, (k, 0, n)), (1 + x) ** n),
        (Sum(C(n, k) ** 2, (k, 0, n)) - C(2 * n, n), t - t),
        (C(n, i), C(n, n - i)),
    ],
)
def test_what_is_of_another_kind_is_left_to_others(lhs, rhs):
    try:
        found = by_wz(statement(lhs, rhs), Budget(5))
    except InvalidStatement:
        return
    assert found is None or prove(lhs, rhs).status == "PROVED"


VERDICT = prove(*CLAIMS["weighted squares"][:2], given=CLAIMS["weighted squares"][2])


def caught(certificate):
    with pytest.raises(ReplayFailed) as error:
        check_certificate(VERDICT.statement, certificate)
    return str(error.value)


def test_a_certificate_that_is_tampered_with_is_caught():
    found = VERDICT.certificate
    assert isinstance(found, ByTelescoping)
    for changes in (
        {"telescope": -found.telescope},
        {"telescope": found.telescope + Symbol("k", integer=True) / (n + 1)},
        {"telescope": found.telescope / (Symbol("k", integer=True) - 2)},
        {"p": -found.p},
        {"q": found.q + 1},
        {"p": found.p - 5},
        {"p": Integer(0), "q": Integer(0), "telescope": Integer(0)},
        {"symbol": t},
        {"symbol": Symbol("k", integer=True)},
        {"lemmas": found.lemmas[1:]},
        {"lemmas": found.lemmas[::-1]},
        {"lemmas": (*found.lemmas, found.lemmas[0])},
    ):
        caught(found._replace(**changes))


@pytest.mark.parametrize("place", range(4))
def test_a_lemma_that_is_not_the_one_needed_or_whose_proof_fails_is_caught(place):
    found = VERDICT.certificate
    lemma = found.lemmas[place]

    def put(other):
        return found._replace(lemmas=(*found.lemmas[:place], other, *found.lemmas[place + 1 :]))

    easy = statement(t, t)
    assert "it needs" in caught(put(Lemma(lemma.statement._replace(rhs=lemma.statement.rhs + 1), lemma.proof)))
    assert "it needs" in caught(put(Lemma(easy, by_wz(easy, Budget(1)))))
    narrow = lemma.statement._replace(ranges={s: e for s, e in lemma.statement.ranges.items() if s != n} | {n: (9, oo)})
    assert "it needs" in caught(put(Lemma(narrow, lemma.proof)))
    cases = lemma.proof.certificate.cases
    for certificate in (lemma.proof.certificate._replace(cases=cases[1:]), None):
        caught(put(Lemma(lemma.statement, lemma.proof._replace(certificate=certificate))))
    caught(put(Lemma(lemma.statement, lemma.proof._replace(status="CHECKED"))))


def test_other_statements_do_not_replay_with_it():
    for changes in ({"rhs": VERDICT.statement.rhs + 1}, {"lhs": 2 * VERDICT.statement.lhs}, {"relation": "<="}):
        with pytest.raises(ReplayFailed):
            replace(VERDICT, statement=VERDICT.statement._replace(**changes)).replay()


@pytest.mark.parametrize(
    ("amount", "ratio"), [(k, 1), (k**3 - k, 1), (1, 2), (k, k + 1), (1 / (k * (k + 1)), 1), (1 / (k * (k + 2)), 1)]
)
def test_gosper_s_sums(amount, ratio):
    found = antidifference(amount + 0 * k, ratio + 0 * k, k, Budget(5))
    difference = found.subs(k, k + 1) * ratio - found - amount
    assert difference.simplify() == 0


def test_gosper_s_algorithm_finds_nothing_where_there_is_nothing():
    for amount in (1 / k, 1 / k**2, 1 / (k**2 + 1)):
        with pytest.raises(Failure):
            antidifference(amount, Integer(1), k, Budget(5))


def test_a_divisor_is_absorbed_where_it_fits_and_stays_where_not():
    assert absorbed(1 / (k + 1), C(n, k), k) == C(n + 1, k + 1) / (n + 1)
    assert absorbed(1 / (n - k), 1 / C(n, k), k) == 1 / (n * C(n - 1, k))
    assert absorbed(1 / (k + 7), C(n, k), k) == C(n, k) / (k + 7)
