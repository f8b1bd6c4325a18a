"""The ledger as tables for a terminal and as lists for a program."""

from collections import Counter

from .claim import Argument, Chain, given_latex, given_plain, statement_latex

MARKS = {"PROVED": "✓", "ARGUED": "✓"}


def claim_record(judged, places):
    """A claim's verdict as JSON takes it; ``places`` is [(source, place)]."""
    claim = judged.claim
    return {
        "id": claim.id,
        "title": claim.title,
        "sources": [{"source": source, "place": place} for source, place in places],
        "statement": statement_latex(claim.statement, claim.title),
        "given": given_latex(claim.given),
        "status": judged.status,
        "method": judged.method,
        "seconds": round(judged.seconds, 3),
        "twins": [twin_record(twin) for twin in judged.twins],
    }


def twin_record(twin):
    found = twin.verdict.counterexample
    return {
        "statement": statement_latex(twin.statement),
        "status": twin.verdict.status,
        "counterexample": None if found is None else str(found),
    }


def erratum_record(erratum):
    """A slip as JSON takes it."""
    why = "counterexample" if erratum.slip.kind == "refuted" else "reason"
    return {
        "id": erratum.claim.id,
        "source": erratum.source,
        "place": erratum.place,
        "printed": erratum.printed,
        "corrected": erratum.corrected,
        "kind": erratum.slip.kind,
        why: erratum.why,
    }


def plain(statement, title=""):
    """A statement in one line of plain text."""
    if isinstance(statement, Argument | str):
        return statement if isinstance(statement, str) else title
    if isinstance(statement, Chain):
        return " = ".join(map(str, statement.lines))
    return f"{statement.lhs} {'=' if statement.rel_op == '==' else statement.rel_op} {statement.rhs}"


def _for(given):
    return f"   for {given_plain(given)}" if given else ""


def claim_line(judged, width):
    """One line of the table: status, id, what it says, how long it took."""
    mark = MARKS.get(judged.status, "✗") if judged.holds else "✗"
    end = f" {judged.seconds:6.2f} s"
    line = f"{mark} {judged.status:9} {judged.claim.id:32} {judged.claim.title}"
    room = max(width - len(end), 60)
    return line[: room - 1].ljust(room) + end


def count_line(results):
    """How many claims have which status, and how many false neighbours were refuted."""
    counts = Counter(judged.status for judged in results)
    twins = [twin.verdict.status for judged in results for twin in judged.twins]
    parts = ", ".join(f"{number} {status}" for status, number in sorted(counts.items(), key=lambda item: -item[1]))
    return f"{len(results)} claims: {parts}; {twins.count('REFUTED')} of {len(twins)} false neighbours REFUTED"


def erratum_lines(erratum):
    """A slip for a terminal: where, what is printed, why not, and what is true."""
    printed = plain(erratum.slip.printed) + _for(erratum.slip.given)
    corrected = plain(erratum.claim.statement, erratum.claim.title) + _for(erratum.claim.given)
    why = "fails" if erratum.slip.kind == "refuted" else "because"
    return [
        f"{erratum.source}, {erratum.place}  [{erratum.slip.kind}]",
        f"  printed  {printed}",
        f"  {why:8} {erratum.why}",
        f"  correct  {corrected}   ({erratum.claim.id})",
    ]
