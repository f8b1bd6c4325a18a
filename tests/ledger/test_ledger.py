"""Every statement of the sources holds, every false neighbour is refuted, every slip is one."""

import re
from pathlib import Path

import pytest
from sympy import Integer, Sum, oo

from bezteach import ledger
from bezteach.ledger.claim import Argument, Computed, Known, Shown, argued, claim, eq, statement_latex
from bezteach.ledger.claims.binomials import STEP
from bezteach.ledger.errata import found
from bezteach.ledger.judging import judged
from bezteach.ledger.reading import amended, refuted, refuted_words
from bezteach.ledger.report import claim_record, erratum_record
from bezteach.ledger.show import formula
from bezteach.ledger.summary import summary, written_into
from bezteach.proof import Verdict, prove
from bezteach.symbolic import B, i, n, t

ROWS = [(source, row) for source, rows in ledger.READINGS.items() for row in rows]
SLIPS = [(source, row) for source, row in ROWS if row.slip is not None]


def never(id):
    return False


def named(row):
    return f"{row[0]}: {row[1].place}"


@pytest.mark.parametrize("id", ledger.CLAIMS)
def test_every_claim_holds_and_its_false_neighbours_are_refuted(id):
    """And the proof of each is checked again, without the search that found it."""
    result = ledger.judge(id)
    assert result.status in ("PROVED", "ARGUED"), result.verdict
    assert [twin.verdict.status for twin in result.twins] == ["REFUTED"] * len(result.twins)
    assert result.twins or result.status == "ARGUED", "a proved claim needs a false neighbour"
    if result.status == "PROVED":
        verdicts = (
            [result.verdict]
            if isinstance(result.verdict, Verdict)
            else [
                line.step
                for line in result.verdict.lines
                if line.step is not None and not line.step.method.startswith("through")
            ]
        )
        for verdict in verdicts:
            verdict.replay()


@pytest.mark.parametrize("slip", SLIPS, ids=named)
def test_every_slip_is_what_it_is_said_to_be(slip):
    why, stands = found(slip[1].slip)
    assert stands, why
    assert why


def test_ids_are_unique_and_rows_name_claims():
    from bezteach.ledger.claims import CLAIMS

    assert len(CLAIMS) == len({claim.id for claim in CLAIMS})
    assert {row.claim for _, row in ROWS} <= set(ledger.CLAIMS)


@pytest.mark.parametrize("source", ledger.READINGS)
def test_a_place_is_one_place(source):
    places = [row.place for row in ledger.READINGS[source]]
    assert sorted(places) == sorted(set(places))


@pytest.mark.parametrize("id", ledger.CLAIMS)
def test_what_is_shown_is_one_line_of_text_and_latex(id):
    claim = ledger.CLAIMS[id]
    assert re.fullmatch(r"[a-z0-9-]+(/[a-z0-9-]+)+", id)
    assert 8 <= len(claim.title) <= 220 and "\n" not in claim.title
    latex = statement_latex(claim.statement, claim.title)
    assert latex.count("{") == latex.count("}")


# --- that the ledger can say no


def test_a_false_claim_does_not_hold():
    false = claim("x/y", "a false statement", (Sum(B(i, n, t), (i, 1, n)), Integer(1)))
    assert (judged(false, never).status, judged(false, never).holds) == ("REFUTED", False)


def test_a_true_neighbour_is_no_false_one():
    true = claim("x/y", "a true statement", (t, t), twins=[(2 * t, t + t)])
    assert judged(true, never).status == "PROVED" and not judged(true, never).holds


@pytest.mark.parametrize(
    "step",
    [
        Known("of a claim that is not settled", "x/open"),
        Shown("what is false", eq(t, 2 * t)),
        Computed("what does not come out", lambda: False),
        Computed("what says nothing", lambda: None),
    ],
)
def test_an_argument_with_a_step_that_fails_is_none(step):
    result = judged(argued("x/y", "an argument", "words", step), never)
    assert result.status == "UNDECIDED" and step.text in result.verdict.note


def test_an_argument_says_how_many_of_its_steps_are_checked():
    steps = ["words", Shown("an equation", eq(t + t, 2 * t)), Computed("a number", lambda: True)]
    result = judged(argued("x/y", "an argument", *steps), never)
    assert (result.status, result.method) == ("ARGUED", "2 of 3 steps checked, the others in words")


def test_the_one_lemma_is_proved_without_itself():
    """The binomial theorem's induction step is a quotient of terms, which closes no sum."""
    assert prove(STEP, given={n: (1, oo), i: (1, n)}).method == "ratio of terms"


def test_a_slip_that_is_none_does_not_stand():
    assert found(refuted((t, 2 * t))) == ("t = 1/2: 1/2 on the left, 1 on the right", True)
    assert found(refuted((2 * t, t + t)))[1] is False
    assert found(refuted_words("twice two is five", "2 + 2 = 4", lambda: 2 + 2 == 5)) == ("2 + 2 = 4", False)
    assert found(amended("t is positive", "only inside")) == ("only inside", True)
    assert found(refuted([t, 2 * t]))[0].startswith("line 2: t = 1/2")


# --- what a reader sees


def test_a_claim_is_shown_with_its_place_its_proof_and_its_neighbours():
    text = repr(ledger.show("basis/unity"))
    assert text.startswith("basis/unity: ") and "deck, " in text
    assert "PROVED (binomial theorem)" in text and "not so: Sum(B(i, n, t), (i, 1, n)) = 1  (n = 0" in text
    assert r"\sum_{i=0}^{n} B_{i,n}" in ledger.show("basis/unity")._repr_markdown_()
    brief = ledger.show("basis/unity", steps=False)
    assert repr(brief) == text[: text.index("\n", text.index("PROVED"))]
    assert r"\sum_{i=0}^{n} B_{i,n}" in brief._repr_markdown_() and "aligned" not in brief._repr_markdown_()


def test_an_argument_is_shown_with_what_is_checked():
    text = repr(ledger.show("curve/hull"))
    assert "ARGUED" in text and "[words]" in text and "[claim basis/unity]" in text


def test_a_side_too_wide_for_a_line_has_a_line_for_each_term():
    page = ledger.show("interpolation/c2")._repr_markdown_()
    assert page.count(r"\\[1ex] &\quad - \left. \frac{d^{2}}{d t^{2}}") == 1
    assert page.count(r"\\[1ex] &= 6 {D}_{2} - 2 {v}_{2}") == 1


def test_an_equation_too_wide_for_a_line_has_a_line_for_each_side():
    wide, narrow = (ledger.CLAIMS[id] for id in ("joins/c2/points", "examples/parabola"))
    assert formula(wide.statement, wide.given).count(r"\\[1ex] &= ") == 1
    assert "aligned" not in formula(narrow.statement, narrow.given)


def test_the_stop_after_a_letter_with_an_index_is_in_its_formula():
    page = ledger.show("interpolation/c2")._repr_markdown_()
    assert "from $D_i$ to $D_{i+1}.$\n" in page and "$D_0,$ ..., $D_N$ a velocity" in page
    assert not re.search(r"\$[.,;](\s|$)", page, flags=re.M)


def test_the_lines_of_a_printed_proof_are_a_derivation():
    lines = ledger.proof("basis/recursion/proof")
    assert lines[0].left == B(i, n, t)
    with pytest.raises(ValueError, match="curve/hull is ARGUED and has no lines"):
        ledger.proof("curve/hull")


def test_the_slips_of_a_source_are_shown():
    page = ledger.show_errata("deck", "refuted")
    assert "basis/recursion/proof" in repr(page) and "(refuted)" in page._repr_markdown_()
    assert "[amended]" not in repr(page) and "[refuted]" not in repr(ledger.show_errata("deck", "amended"))


def test_an_unknown_claim_names_the_nearest():
    with pytest.raises(ValueError, match="there is no claim 'basis/unit': .*basis/unity"):
        ledger.show("basis/unit")


def test_what_is_printed_rightly_has_no_slip():
    assert ledger.slip("games", "basis/elevation/second").kind == "refuted"
    with pytest.raises(ValueError, match="deck has no slip at 'basis/unity'"):
        ledger.slip("deck", "basis/unity")


def test_claims_come_in_the_order_of_the_sources():
    ids = ledger.matching()
    assert sorted(ids) == sorted(ledger.CLAIMS)
    assert ids.index("basis/unity") < ids.index("basis/recursion") < ids.index("curve/hull")
    assert set(ledger.matching("recursion")) == {id for id in ids if "recursion" in id}
    assert ledger.matching("basis/un*")[0] == "basis/unity"
    assert ledger.matching(source="notes") == list(dict.fromkeys(row.claim for row in ledger.READINGS["notes"]))


def test_the_records_are_those_of_the_design():
    record = claim_record(ledger.judge("basis/unity"), ledger.places("basis/unity"))
    assert {"id", "sources", "statement", "status", "method", "seconds", "twins"} <= set(record)
    assert set(record["twins"][0]) == {"statement", "status", "counterexample"}
    assert set(record["sources"][0]) == {"source", "place"}
    for record in map(erratum_record, ledger.errata()):
        why = {"refuted": "counterexample", "amended": "reason"}[record["kind"]]
        assert set(record) == {"id", "source", "place", "printed", "corrected", "kind", why}
        assert all(record.values())


def test_no_argument_goes_in_a_circle():
    def behind(id, path):
        assert id not in path, f"{' -> '.join(path)} -> {id}"
        one = ledger.CLAIMS[id].statement
        for step in one.steps if isinstance(one, Argument) else ():
            if isinstance(step, Known):
                behind(step.id, [*path, id])

    for id in ledger.CLAIMS:
        behind(id, [])


def test_arguments_say_which_steps_are_words():
    for one in ledger.CLAIMS.values():
        if isinstance(one.statement, Argument):
            kinds = {type(step).__name__ for step in one.statement.steps}
            assert kinds & {"Known", "Shown", "Computed"}, f"{one.id} is words alone"


def test_the_counts_in_the_readme_are_those_of_the_ledger():
    results = [ledger.judge(id) for id in ledger.matching()]
    text = (Path(ledger.__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    assert written_into(text, summary(results, ledger.READINGS, ledger.errata())) == text


def test_of_several_slips_at_a_claim_the_place_chooses():
    first, second = (
        ledger.slip("transcript", "bspline/corner", f"multiple knots, {what}") for what in ("p times", "corners")
    )
    assert first is ledger.slip("transcript", "bspline/corner") and first is not second
    with pytest.raises(
        ValueError, match="no slip at 'bspline/corner' in 'knots': there is multiple knots, p times; mult"
    ):
        ledger.slip("transcript", "bspline/corner", "knots")
    with pytest.raises(ValueError, match="deck has no slip at 'basis/unity'"):
        ledger.slip("deck", "basis/unity")
