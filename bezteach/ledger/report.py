"""The ledger as tables for a terminal and as lists for a program."""

from collections import Counter

from .claim import Argument, Chain, given_latex, given_plain, statement_latex


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


def plain(statement, title="", given=None):
    """A statement in one line of plain text, with its ranges; an argument is its title."""
    where = f"   for {given_plain(given)}" if given else ""
    if isinstance(statement, Argument | str):
        return (statement if isinstance(statement, str) else title) + where
    if isinstance(statement, Chain):
        return " = ".join(map(str, statement.lines)) + where
    return f"{statement.lhs} {'=' if statement.rel_op == '==' else statement.rel_op} {statement.rhs}" + where


def claim_line(judged, width):
    """One line of the table: status, id, what it says, how long it took."""
    mark = "✓" if judged.holds else "✗"
    end = f" {judged.seconds:6.2f} s"
    line = f"{mark} {judged.status:9} {judged.claim.id:32} {judged.claim.title}"
    room = max(width - len(end), 60)
    return line[: room - 1].ljust(room) + end


def counts(results):
    """How many claims have which status, and how many false neighbours were refuted: two pieces of text."""
    statuses = Counter(judged.status for judged in results).most_common()
    twins = [twin.verdict.status for judged in results for twin in judged.twins]
    return (
        f"{len(results)} claims: {', '.join(f'{number} {status}' for status, number in statuses)}",
        f"{twins.count('REFUTED')} of {len(twins)} false neighbours REFUTED",
    )


def count_line(results):
    """The counts in one line."""
    return "; ".join(counts(results))


def erratum_lines(erratum):
    """A slip for a terminal: where, what is printed, why not, and what is true."""
    printed = plain(erratum.slip.printed, given=erratum.slip.given)
    corrected = plain(erratum.claim.statement, erratum.claim.title, erratum.claim.given)
    why = "fails" if erratum.slip.kind == "refuted" else "because"
    return [
        f"{erratum.source}, {erratum.place}  [{erratum.slip.kind}]",
        f"  printed  {printed}",
        f"  {why:8} {erratum.why}",
        f"  correct  {corrected}   ({erratum.claim.id})",
    ]
