"""A claim for a reader: what it says, where it stands, whether it holds, and why, line by line; and the slips."""

import re

from bezteach.display import Page, escaped
from bezteach.symbolic import Derivation, Step, latex

from .claim import Argument, Chain, Computed, Known, Shown, given_latex, statement_latex
from .report import erratum_lines, plain

LETTER = r"\b[A-Za-z]_(?:\{[^{}]*\}|\w+)(?:\^(?:\{[^{}]*\}|\w))?|\b[A-Za-z]\^(?:\{[^{}]*\}|\w)"
INDEXED = re.compile(rf"((?:{LETTER})(?:[.,;](?=\s|$))?)")  # with its stop, which must not begin a line
LONG = 110  # characters of LaTeX that fit into a line beside words
WIDE = 100  # letters that fit into a line of their own
UNSEEN = re.compile(r"\\\\.*?(?=\\end)|\\(?:begin|end)\{matrix\}|\\[A-Za-z]+|[{}_^\s\\]")  # and lower rows
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
        for number, step in _numbered(claim) if steps else ():
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
    yield f"**{_words(claim.title)}**" + f" ({escaped(where)})" * bool(where)
    if isinstance(claim.statement, Argument):
        yield f"**{judged.status}**: {escaped(judged.method)}"
        if steps:
            lines = (f"*{_mark(step)}*: {_words(step.text)}{_beside(step)}" for step in claim.statement.steps)
            yield "\n".join(f"{number}. {line}" for number, line in enumerate(lines, 1))
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
        written = statement_latex(statement) + where
        return f"$${_in_lines(written) if _is_wide(written) else written}$$"
    rows = [
        f"&{'=' if number else chr(92) + 'phantom{=}'} {latex(line)}" for number, line in enumerate(statement.lines)
    ]
    return "$$\\begin{aligned}" + r" \\[1ex] ".join(rows) + where + "\\end{aligned}$$"


def _words(text):
    """Words as Markdown, letters with an index set as formulas."""
    return "".join(f"${part}$" if k % 2 else escaped(part) for k, part in enumerate(INDEXED.split(text)))


def _numbered(claim):
    return enumerate(claim.statement.steps, 1)


def _beside(step):
    """The statement of a step that is proved, in the line of its words; a long one in lines of its own."""
    if not isinstance(step, Shown):
        return ""
    written = statement_latex(step.statement)
    if len(written) <= LONG or " = " not in written:
        return rf" $\displaystyle {written}$"
    return f" ${_in_lines(written, '[t]')}$"


def _in_lines(equation, place=""):
    """An equation with a line for each side."""
    lines = [line for side in re.split(" (?== )", equation) for line in _lines_of(side)]
    return rf"\begin{{aligned}}{place} &" + r" \\[1ex] &".join(lines) + r"\end{aligned}"


def _lines_of(side):
    """A side in one line; if it is too wide for it, in a line for each term that stands in no bracket."""
    if not _is_wide(side):
        return [side]
    first, *others = re.split("(?<!=)(?= [+-] )", side)
    lines = [first]
    for term in others:
        if _closed(lines[-1]):
            lines.append(rf"\quad{term}")
        else:
            lines[-1] += term
    return lines


def _is_wide(written):
    return len(UNSEEN.sub("", written)) > WIDE


def _closed(written):
    pairs = ((r"\left", r"\right"), ("{", "}"), ("(", ")"))
    return all(written.count(opening) == written.count(closing) for opening, closing in pairs)


def _mark(step):
    kind = MARK.get(type(step), "words")
    return f"{kind} {step.id}" if isinstance(step, Known) else kind


def errata_shown(errata):
    """Slips as a numbered list: where, what is printed, why it will not do, and what is true."""
    text, pages = [], []
    for number, erratum in enumerate(errata, 1):
        text += [*erratum_lines(erratum), ""]
        pages += [f"**{number}. {_place(erratum)}", *_fault(erratum), _correction(erratum)]
    return Page("\n".join(text).rstrip(), "\n\n".join(pages))


def erratum_shown(erratum):
    """A slip beside its claim, which says what is true: where, what is printed, and why it will not do."""
    return Page("\n".join(erratum_lines(erratum)[:-1]), "\n\n".join([f"**{_place(erratum)}", *_fault(erratum)]))


def _place(erratum):
    return f"{escaped(erratum.source)}, {escaped(erratum.place)}** ({erratum.slip.kind})"


def _fault(erratum):
    slip = erratum.slip
    printed = f"“{_words(slip.printed)}”" if isinstance(slip.printed, str) else formula(slip.printed, slip.given)
    why = "It fails at" if slip.kind == "refuted" and not slip.holds else "Because"
    return f"Printed: {printed}", f"{why}: {_words(erratum.why)}"


def _correction(erratum):
    claim = erratum.claim
    argued = isinstance(claim.statement, Argument)
    correct = _words(claim.title) if argued else formula(claim.statement, claim.given)
    return f"Correct (`{claim.id}`): {correct}"
