"""replay: every proof is checked again from its certificate, and none that was tampered with gets through."""

from dataclasses import replace

import pytest
from proof_claims import CLAIMS, given, some_mutants
from sympy import Expr, Ge, Integer, Interval, KroneckerDelta, Le, Lt, Mul, Rational, S, Sum, binomial, oo
from test_proof_signs import CLAIMS as INEQUALITIES
from test_proof_signs import claim, given_ranges

from bezteach.proof import Budget, InvalidStatement, check_derivation, counterexample, prove, statement
from bezteach.proof.certificate import (
    ByBounds,
    ByCases,
    ByGrowth,
    ByInduction,
    ByPartOfSum,
    ByPeak,
    BySigns,
    ByTerms,
    Group,
    Lemma,
    Part,
    TermsCase,
    Through,
)
from bezteach.proof.errors import ReplayFailed
from bezteach.proof.fixed import by_cases
from bezteach.proof.inequalities.signs import by_signs
from bezteach.proof.replaying.alike import alike
from bezteach.proof.replaying.cover import check_covered
from bezteach.proof.replaying.replay import check_certificate, check_values, replay_proof
from bezteach.proof.verdict import Proof, verdict_of
from bezteach.symbolic import B, Step, b, i, j, k, n, r, step, t, u

FROM_ONE = {n: (1, oo)}
WITHIN = {i: (0, n), t: Interval(0, 1)}
PARTIAL_SUMS = [
    (Sum(k, (k, 0, n)), n * (n + 1) / 2, {}),
    (Sum(k**2, (k, 1, n)), n * (n + 1) * (2 * n + 1) / 6, FROM_ONE),
    ((1 - t) * Sum(t**k, (k, 0, n)), 1 - t ** (n + 1), {}),
    (Sum(2**k, (k, i, n)), 2 ** (n + 1) - 2**i, {i: (0, n)}),
]
ALL_CASES = [
    (B(i, n, t), B(n - i, n, 1 - t), {n: (2, 4), i: (0, n)}),
    (step(t) ** 3 * b[0], Sum(B(i, 3, t) * b[i], (i, 0, 3)), {}),
    (Le(binomial(n, k), binomial(8, 4)), None, {n: (0, 8), k: (0, n)}),
]


def bare(found, certificate, of=None):
    """Check a certificate alone: not the steps shown, and not whether the statement holds at a few points."""
    check_certificate(of or found.statement, certificate)


def caught(found, certificate, of=None):
    with pytest.raises(ReplayFailed) as error:
        bare(found, certificate, of)
    return str(error.value)


def test_a_name_that_is_bound_twice_is_told_from_another():
    """The limits of the inner one of two sums over k, and a sum over j around them: j and k are not alike."""
    limits = ((j, 0, 2), (k, 0, 3), (k, 0, n))
    one, other = Sum(k, *limits), Sum(j, *limits)
    assert not alike(one, other) and alike(one, Sum(r, (i, 0, 2), (r, 0, 3), (r, 0, n)))
    far = {n: (6000, oo)}  # where the sums have too many terms to be looked at
    first, second = prove(one, 18 * (n + 1), given=far), prove(18 * (n + 1), 18 * n + 18, given=far)
    false = first.statement._replace(lhs=other, rhs=18 * n + 18)
    assert caught(first, Through((first, second)), of=false)


@pytest.mark.parametrize("name", CLAIMS)
def test_every_equation_replays(name):
    lhs, rhs, ranges = CLAIMS[name]
    prove(lhs, rhs, given=given(ranges)).replay()


@pytest.mark.parametrize("name", INEQUALITIES)
def test_every_inequality_replays(name):
    relation, lhs, rhs, ranges, _ = INEQUALITIES[name]
    verdict = prove(relation(lhs, rhs, evaluate=False), given=given_ranges(ranges))
    verdict.replay()
    assert verdict.certificate is not None


@pytest.mark.parametrize(("lhs", "rhs", "ranges"), PARTIAL_SUMS)
def test_inductions_replay(lhs, rhs, ranges):
    verdict = prove(lhs, rhs, given=ranges)
    assert isinstance(verdict.certificate, ByInduction)
    verdict.replay()


def by_all_cases(lhs, rhs, ranges):
    found = statement(lhs, rhs, ranges)
    return verdict_of(by_cases(found, Budget(20)), found, 0.0)


@pytest.mark.parametrize("claim", ALL_CASES)
def test_all_cases_replay(claim):
    verdict = by_all_cases(*claim)
    assert isinstance(verdict.certificate, ByCases)
    verdict.replay()


def test_what_follows_from_two_lines_replays():
    lines = [B(0, 3, t), (1 - t) ** 3, B(0, 3, t) + t - t]
    judged = check_derivation([*lines[:2], (1 - t) * (1 - t) ** 2, 1 - 3 * t + 3 * t**2 - t**3])
    through = [v for line in judged.lines[1:] for v in (line.step, line.whole) if v.method.startswith("through")]
    assert through
    for verdict in through:
        verdict.replay()
        one, other = verdict.certificate.verdicts
        caught(verdict, verdict.certificate._replace(verdicts=(one, one)))
        false = replace(other, statement=other.statement._replace(rhs=other.statement.rhs + 1))
        caught(verdict, verdict.certificate._replace(verdicts=(one, false)))


def test_a_number_is_not_like_a_product():
    """SymPy's == makes an expression of what it is compared with, and fails where a set of classes is inside."""
    for one, other in ((S.Zero, 2 * (t + u)), (2 * (t + u), S.Zero), (t, t * u), (S.One, Sum(k, (k, 0, n)))):
        assert not alike(one, other)
    assert alike(2 * (t + u), 2 * (u + t)) and alike(S.Zero, S.Zero)


def test_two_lines_that_hold_for_other_values_do_not_meet():
    """A line is 0 for i > 0, and the product for i = 0: that does not make 0 of the product, which is 15! at n = 15."""
    product = Mul(*[n - place for place in range(15)])
    between = KroneckerDelta(i, 0) * product
    one, other = prove(0 * n, between, given={i: (1, oo)}), prove(between, product, given={i: (0, 0)})
    assert one.status == other.status == "PROVED"
    false = statement(0 * n, product)
    with pytest.raises(ReplayFailed, match="i ranges over .* in a part of the proof"):
        replay_proof(false, Proof("PROVED", "through line 2", certificate=Through((one, other))))


def test_a_literal_certificate():
    """t B_{i,n} = (i+1)/(n+1) B_{i+1,n+1}: one case, in which the two rests are 1 and -1 times the same."""
    verdict = prove(t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t), given={i: (0, n)})
    ((part, ((shared, rests),)),) = verdict.certificate.cases
    assert part == Part() and set(shared.factorials) == {n, i, n - i} and len(rests) == 2
    assert (rests[0] + rests[1]).expand().cancel() == 0
    assert verdict.replay() is None


@pytest.mark.parametrize(
    ("lhs", "rhs", "status"), [(B(i, n, t), B(i, n, 1 - t), "REFUTED"), (t, "x", "INVALID"), (b[0], b[1], "REFUTED")]
)
def test_only_a_proof_can_be_replayed(lhs, rhs, status):
    with pytest.raises(ReplayFailed, match=f"only a PROVED verdict can be replayed, and this one is {status}"):
        prove(lhs, rhs).replay()


def test_a_status_alone_is_no_proof():
    refuted = prove(B(i, n, t), B(i, n, 1 - t))
    with pytest.raises(ReplayFailed, match="no certificate"):
        replace(refuted, status="PROVED").replay()


RECURSION = CLAIMS["recursion"]
PROVED = prove(*RECURSION[:2], given=given(RECURSION[2]))


def with_case(place, **changes):
    cases = list(PROVED.certificate.cases)
    cases[place] = cases[place]._replace(**changes)
    return ByTerms(tuple(cases))


@pytest.mark.parametrize("place", range(3))
def test_terms_with_a_sign_turned_or_a_group_or_a_rest_left_out(place):
    case = PROVED.certificate.cases[place]
    for position, (shared, rests) in enumerate(case.groups):
        for edited in (tuple(-x if y == 0 else x for y, x in enumerate(rests)), rests[1:], (*rests, S.One)):
            groups = [*case.groups]
            groups[position] = Group(shared, edited)
            assert "the rest" in caught(PROVED, with_case(place, groups=tuple(groups)))
        assert "no group holds" in caught(PROVED, with_case(place, groups=()))


def test_terms_that_cancel_but_are_not_those_of_the_statement():
    case = PROVED.certificate.cases[-1]
    ((shared, rests),) = case.groups
    stretched = shared._replace(factorials={form + 1: power for form, power in shared.factorials.items()})
    assert "no group holds" in caught(PROVED, with_case(-1, groups=(Group(stretched._replace(powers={}), rests),)))
    claim_of_more = replace(PROVED.statement and PROVED, statement=PROVED.statement._replace(rhs=RECURSION[1] + t))
    assert "no group holds" in caught(claim_of_more, PROVED.certificate)


@pytest.mark.parametrize("place", range(3))
def test_a_case_is_missing(place):
    cases = PROVED.certificate.cases
    assert "no case covers" in caught(PROVED, ByTerms(cases[:place] + cases[place + 1 :]))


def test_a_case_of_another_value_or_wider_than_its_terms():
    edge, *_, inner = PROVED.certificate.cases
    ((symbol, at),) = edge.part.values
    caught(PROVED, with_case(0, part=Part(((symbol, at + 1),))))
    caught(PROVED, with_case(0, part=Part(((symbol, symbol + 1),))))
    others = (*PROVED.certificate.cases, TermsCase(Part(((t, S.Zero),)), inner.groups))
    assert "no value of a case" in caught(PROVED, ByTerms(others))
    assert "another one beside it" in caught(PROVED, ByTerms((TermsCase(Part(), inner.groups),)))


def test_the_ranges_are_those_of_the_statement():
    wider = PROVED.statement._replace(ranges={n: PROVED.statement.ranges[n]._replace(low=S.Zero)})
    wider.ranges.update({s: r for s, r in PROVED.statement.ranges.items() if s != n})
    caught(PROVED, PROVED.certificate, wider)


@pytest.mark.parametrize("relation", ["<", "<=", ">", ">="])
@pytest.mark.parametrize(
    "found",
    [
        prove(Sum(B(k, n, t), (k, 0, n)), 1, given={n: (6000, oo)}),  # no value is small enough to contradict
        prove(Sum(k, (k, 0, n)), n * (n + 1) / 2),
        prove(Sum(binomial(n, k) ** 2, (k, 0, n)), binomial(2 * n, n)),
        prove(step(t) ** n * b[0], Sum(B(i, n, t) * b[i], (i, 0, n))),
    ],
    ids=["terms", "induction", "telescoping", "points"],
)
def test_an_equation_proves_no_inequality(found, relation):
    assert found.status == "PROVED"
    found.replay()
    other = found.statement._replace(relation=relation)
    caught(found, found.certificate, of=other)
    with pytest.raises(ReplayFailed):
        replace(found, statement=other).replay()
    with pytest.raises(ReplayFailed):
        check_values(statement(b[0] + b[1], b[1] + b[0], {})._replace(relation=relation))


def test_the_steps_shown_are_those_of_the_certificate():
    for place, line in enumerate(PROVED.steps):
        false = line._replace(expression=line.expression + 1)
        steps = (*PROVED.steps[:place], false, *PROVED.steps[place + 1 :])
        with pytest.raises(ReplayFailed, match=f"step {place + 1} shows"):
            replace(PROVED, steps=steps).replay()
    with pytest.raises(ReplayFailed, match="steps are shown"):
        replace(PROVED, steps=PROVED.steps[:-1]).replay()
    with pytest.raises(ReplayFailed, match="step 1 shows"):
        replace(PROVED, steps=(Step(S.Zero, "because I say so"), *PROVED.steps[1:])).replay()


@pytest.mark.parametrize("name", CLAIMS)
def test_no_certificate_proves_a_false_mutant(name):
    """The certificate of a true equation, put to every third of its mutants that is false."""
    lhs, rhs, ranges = CLAIMS[name]
    verdict = prove(lhs, rhs, given=given(ranges))
    for left, right in some_mutants(lhs, rhs, name, 3):
        occurring = left.free_symbols | right.free_symbols
        try:
            mutant = statement(left, right, {s: e for s, e in given(ranges).items() if s in occurring})
            false = counterexample(mutant, Budget(1)).counterexample is not None
        except InvalidStatement:
            continue
        if false:
            caught(verdict, verdict.certificate, mutant)


def edits(node):
    """Every certificate that one edit makes: a number, a sign, an entry left out."""
    if isinstance(node, bool):
        yield not node
    elif isinstance(node, Expr):
        yield from (other for other in (node + 1, -node) if other != node)
    elif isinstance(node, dict):
        yield from ({key: value for key, value in node.items() if key != left_out} for left_out in node)
        yield from ({**node, key: other} for key, value in node.items() for other in edits(value))
    elif isinstance(node, frozenset):
        yield from (node - {sign} for sign in node)
    elif isinstance(node, tuple) and not isinstance(node, Proof):
        made = type(node)._make if hasattr(node, "_make") else tuple
        for place, part in enumerate(node):
            yield from (made((*node[:place], other, *node[place + 1 :])) for other in edits(part))
            if made is tuple:
                yield (*node[:place], *node[place + 1 :])


@pytest.mark.parametrize("name", [*CLAIMS, *INEQUALITIES])
def test_an_edited_certificate_shows_other_steps_or_fails(name):
    """Whatever one edit makes of it: it fails, or it is another proof, and shows just what was shown."""
    if name in CLAIMS:
        lhs, rhs, ranges = CLAIMS[name]
        verdict = prove(lhs, rhs, given=given(ranges))
    else:
        relation, lhs, rhs, ranges, _ = INEQUALITIES[name]
        verdict = prove(relation(lhs, rhs, evaluate=False), given=given_ranges(ranges))
    tried = 0
    every = list(edits(verdict.certificate))
    for edited in every[:: max(3, len(every) // 40)]:
        try:
            replace(verdict, certificate=edited).replay()
        except ReplayFailed:
            tried += 1
    assert tried


def induction():
    return prove(*PARTIAL_SUMS[1][:2], given=FROM_ONE)


def test_an_induction_with_a_wrong_base_or_step():
    verdict = induction()
    symbol, upward, first, step_ = verdict.certificate
    other = prove(Sum(k**2, (k, 1, 1)), 1)
    wrong = Lemma(other.statement._replace(rhs=Integer(2)), first.proof)
    assert "it needs" in caught(verdict, ByInduction(symbol, upward, wrong, step_))
    assert "it needs" in caught(verdict, ByInduction(symbol, upward, step_, first))
    shorter = step_.statement._replace(ranges={n: step_.statement.ranges[n]._replace(low=Integer(2))})
    assert "it needs" in caught(verdict, ByInduction(symbol, upward, first, Lemma(shorter, step_.proof)))
    assert "no certificate" in caught(
        verdict, ByInduction(symbol, upward, first, Lemma(step_.statement, step_.proof._replace(certificate=None)))
    )
    assert "from this end" in caught(verdict, ByInduction(symbol, False, first, step_))
    assert "no induction" in caught(verdict, ByInduction(t, True, first, step_))


def test_an_induction_whose_step_is_tampered_with():
    verdict = induction()
    symbol, upward, first, step_ = verdict.certificate
    (case,) = step_.proof.certificate.cases
    (group,) = case.groups
    false = ByTerms((case._replace(groups=(group._replace(rests=tuple(-2 * x for x in group.rests[:1])),)),))
    lemma = Lemma(step_.statement, step_.proof._replace(certificate=false))
    assert "the rest" in caught(verdict, ByInduction(symbol, upward, first, lemma))


def test_all_cases_with_one_missing_or_another_value():
    for found in ALL_CASES:
        verdict = by_all_cases(*found)
        cases = verdict.certificate.cases
        assert "the cases are not those" in caught(verdict, ByCases(cases[1:]))
        assert "the cases are not those" in caught(verdict, ByCases((*cases, cases[0])))
        (point, left, right), *more = cases
        assert "recorded is" in caught(verdict, ByCases(((point, left + 1, right + 1), *more)))
    endless = statement(B(i, n, t), B(n - i, n, 1 - t), {n: (2, oo), i: (0, n)})
    assert "has no end" in caught(verdict, ByCases(cases), endless)


def inequality(name):
    relation, lhs, rhs, ranges, _ = INEQUALITIES[name]
    return prove(relation(lhs, rhs, evaluate=False), given=given_ranges(ranges))


def test_signs_that_are_not_those_of_the_factors():
    verdict = inequality("log-concave")
    cases = verdict.certificate.cases
    assert isinstance(verdict.certificate, BySigns) and len(cases) > 1
    for place, case in enumerate(cases):
        for factors in (((case.factors[0][0] + 1, case.factors[0][1]), *case.factors[1:]), case.factors[1:]):
            if factors:
                edited = (*cases[:place], case._replace(factors=factors), *cases[place + 1 :])
                caught(verdict, BySigns(0, edited))
        assert "no case covers" in caught(verdict, BySigns(0, cases[:place] + cases[place + 1 :]))
    positive = cases[-1]._replace(factors=((cases[-1].factors[0][0], frozenset({-1})), *cases[-1].factors[1:]))
    caught(verdict, BySigns(0, (*cases[:-1], positive)))


def test_a_strict_inequality_does_not_replay_from_the_weak_one():
    verdict = inequality("higher power")
    strict = claim(Lt, *INEQUALITIES["higher power"][1:4])
    caught(verdict, verdict.certificate, strict)


def test_bounds_that_are_not_true_or_not_enough():
    verdict = inequality("at most 1")
    bounds, unity = verdict.certificate
    ((part, interval, reason),) = bounds
    assert unity is not None
    for other in (Interval(0, Rational(1, 2)), Interval(0, 2), Interval.open(0, 1)):
        assert "not known to lie" in caught(verdict, ByBounds(((part, other, reason),), unity))
    assert "lemmas" in caught(verdict, ByBounds(bounds, None))
    assert "parts of the difference" in caught(verdict, ByBounds((), unity))
    half = claim(Le, B(i, n, t), Rational(1, 2), WITHIN)
    assert "not enough" in caught(verdict, verdict.certificate, half)


def test_a_part_of_a_sum_with_other_ends():
    verdict = inequality("part of a sum")
    assert verdict.certificate == ByPartOfSum(i, n)
    for ends in ((i, n + 1), (S.Zero, n), (i + 1, n)):
        assert "no part of the sum" in caught(verdict, ByPartOfSum(*ends))
    signed = claim(Le, *INEQUALITIES["part of a sum"][1:3], WITHIN | {t: Interval(-1, 1)})
    assert "negative" in caught(verdict, verdict.certificate, signed)


def test_a_peak_at_another_place_or_of_other_powers():
    verdict = inequality("maximum")
    symbol, powers, peak = verdict.certificate
    for other in (peak + 1, (i + 1) / n, i / (n + 1), 1 - peak):
        caught(verdict, ByPeak(symbol, powers, other))
    caught(verdict, ByPeak(symbol, tuple((base, power + 1) for base, power in powers), peak))
    caught(verdict, ByPeak(symbol, powers[:1], peak))
    caught(verdict, ByPeak(u, powers, peak))
    turned = claim(Ge, *INEQUALITIES["maximum"][1:4])
    assert "growing" in caught(verdict, verdict.certificate, turned)


def test_growth_with_another_ratio_or_first_case():
    verdict = inequality("Bernoulli")
    found = verdict.certificate
    assert isinstance(found, ByGrowth)
    assert "is not the factor" in caught(verdict, found._replace(ratio=found.ratio + 1))
    assert "is not the first case" in caught(verdict, found._replace(start=Integer(1)))
    for name in ("first", "gap"):
        assert "no case covers" in caught(verdict, found._replace(**{name: ()}))
    caught(verdict, found._replace(larger=False))
    caught(verdict, found._replace(first=found.gap))


def test_cases_that_cover_a_triangle():
    """0 <= i <= n without i = n or i = 0; and with both, whatever the order."""
    conditions = [i, n - i]
    first, last, inner = Part(((i, S.Zero),)), Part(((i, n),)), Part((), (i - 1, n - i - 1))
    for parts in ([first, last, inner], [inner, last, first]):
        check_covered(conditions, parts)
    for parts in ([first, last], [first, inner], [last, inner], [], [Part((), (i - 1,))]):
        with pytest.raises(ReplayFailed, match="no case covers"):
            check_covered(conditions, parts)
    with pytest.raises(ReplayFailed, match="no linear form"):
        check_covered(conditions, [Part((), (i * n,))])


def test_an_inequality_of_signs_is_replayed_beside_the_search():
    found = claim(Ge, B(i, n, t), 0, WITHIN)
    replay_proof(found, by_signs(found, Budget(5)))
    with pytest.raises(ReplayFailed, match="an equation"):
        check_certificate(statement(B(j, r, t), 0), BySigns(0, ()))
