"""A claim for a reader: what it says, where it stands, whether it holds, and why, line by line; and the slips."""

from bezteach.display import Page, escaped
from bezteach.symbolic import Derivation, Step, latex

from .claim import Argument, Chain, Computed, Known, Shown, given_latex, statement_latex
from .report import erratum_lines, plain

MARK = {Known: "claim", Shown: "proved", Computed: "computed"}


def proof(judged):
    """The lines of a proof with their reasons, a ``Derivation``; ``ValueError`` for what has no such lines."""
    statement, verdict = judged.claim.statement, judged.verdict
    if isinstance(statement, Chain):
        how = [line.step.method for line in verdict.lines[1:]]
        reasons = [said or method for said, method in zip(statement.reasons[1:], how, strict=True)]
        steps = [Step(line, why) for line, why in zip(statement.lines[1:], reasons, strict=True)]
        return Derivation([steps[0]._replace(left=statement.lines[0]), *steps[1:]])
    if isinstance(statement, Argument) or not verdict.steps:
        raise ValueError(f"{judged.claim.id} is {judged.status} and has no lines: ledger.show displays it")
    return Derivation(verdict.steps)


def shown(judged, places, steps=True):
    """The claim with its places and its verdict, and with the lines of its proof and its refuted neighbours."""
    return Page("\n".join(_text(judged, places, steps)), "\n\n".join(_markdown(judged, places, steps)))


def _text(judged, places, steps):
    claim = judged.claim
    yield f"{claim.id}: {claim.title}"
    yield from (f"  {source}, {place}" for source, place in places)
    if isinstance(claim.statement, Argument):
        yield f"{judged.status} ({judged.method})"
        for number, step in _numbered(claim):
            beside = f" {plain(step.statement)}" if isinstance(step, Shown) else ""
            yield f"  {number}. [{_mark(step)}] {step.text}{beside}"
        return
    yield f"  {plain(claim.statement, given=claim.given)}"
    yield f"{judged.status} ({judged.method})"
    if not steps:
        return
    yield from (f"  {step!r}" for step in (proof(judged) if judged.settled else [judged.verdict]))
    for twin in judged.twins:
        yield f"not so: {plain(twin.statement)}  ({twin.verdict.counterexample})"


def _markdown(judged, places, steps):
    claim = judged.claim
    where = "; ".join(f"{source}, {place}" for source, place in places)
    yield f"**{escaped(claim.title)}**" + f" ({escaped(where)})" * bool(where)
    if isinstance(claim.statement, Argument):
        yield f"**{judged.status}**: {escaped(judged.method)}"
        yield "\n".join(
            f"{number}. *{_mark(step)}*: {escaped(step.text)}{_beside(step)}" for number, step in _numbered(claim)
        )
        return
    yield formula(claim.statement, claim.given)
    yield f"**{judged.status}**: {escaped(judged.method)}"
    if not steps:
        return
    if judged.settled:
        yield proof(judged)._repr_latex_()
    for twin in judged.twins:
        yield f"not so: ${statement_latex(twin.statement)}$ &ensp; ({escaped(str(twin.verdict.counterexample))})"


def formula(statement, given):
    """A statement as a displayed formula with its ranges; a chain with a line for each of its lines."""
    where = rf"\qquad ({given_latex(given)})" if given else ""
    if not isinstance(statement, Chain):
        return f"$${statement_latex(statement)}{where}$$"
    rows = [
        f"&{'=' if number else chr(92) + 'phantom{=}'} {latex(line)}" for number, line in enumerate(statement.lines)
    ]
    return "$$\\begin{aligned}" + r" \\[1ex] ".join(rows) + where + "\\end{aligned}$$"


def _numbered(claim):
    return enumerate(claim.statement.steps, 1)


def _beside(step):
    """The statement of a step that is proved, in the line of its words."""
    return f" ${statement_latex(step.statement)}$" if isinstance(step, Shown) else ""


def _mark(step):
    kind = MARK.get(type(step), "words")
    return f"{kind} {step.id}" if isinstance(step, Known) else kind


def errata_shown(errata):
    """Slips as a numbered list: where, what is printed, why it will not do, and what is true."""
    text, pages = [], []
    for number, slip in enumerate(errata, 1):
        text += [*erratum_lines(slip), ""]
        pages.append(_erratum(number, slip))
    return Page("\n".join(text).rstrip(), "\n\n".join(pages))


def _erratum(number, slip):
    printed = (
        f"“{escaped(slip.slip.printed)}”"
        if isinstance(slip.slip.printed, str)
        else formula(slip.slip.printed, slip.slip.given)
    )
    argued = isinstance(slip.claim.statement, Argument)
    correct = escaped(slip.claim.title) if argued else formula(slip.claim.statement, slip.claim.given)
    why = "It fails at" if slip.slip.kind == "refuted" and not slip.slip.holds else "Because"
    return "\n\n".join(
        [
            f"**{number}. {escaped(slip.source)}, {escaped(slip.place)}** ({slip.slip.kind})",
            f"Printed: {printed}",
            f"{why}: {escaped(slip.why)}",
            f"Correct (`{slip.claim.id}`): {correct}",
        ]
    )
