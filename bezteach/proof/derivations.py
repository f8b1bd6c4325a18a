"""``check_derivation``: a chain of equalities, each line judged against the line before it and against the first.

All lines speak of the same values: what a symbol is, and where it ranges, is read off all of them together. A symbol
that a line brings in alone must cancel, since the line has to hold for all its values. A line that is no expression, or
does not fit the lines above it, is left out, and the next one is judged against the last line that means something.
"""

from collections.abc import Iterable

from .budget import Budget
from .chains import chain_verdicts, form
from .errors import InvalidStatement
from .exact.evaluate import evaluator, expression
from .judgement import (
    CHECKED_ONLY,
    FOLLOWS,
    HOLDS,
    MEANINGLESS,
    NO_PROGRESS,
    OPEN,
    RIGHT_AGAIN,
    START,
    STILL_WRONG,
    WRONG,
    Judgement,
    Line,
)
from .ranges import about, ranges
from .statement import check_kinds, with_checked_binders
from .verdict import (
    ARGUED,
    CHECKED,
    INVALID,
    PROVED,
    REFUTED,
    UNDECIDED,
)


def check_derivation(lines, *, given=None, budget=20.0):
    """Judge the chain of equalities that the lines, SymPy expressions, are; ``given`` and ``budget`` as for ``prove``.

    >>> from bezteach.symbolic import B, i, n, u
    >>> check_derivation([u * B(i, n, u), (i + 1) * B(i + 1, n + 1, u) / n, (i + 1) * B(i + 1, n + 1, u) / (n + 1)],
    ...     given={n: (1, 3), i: (0, n)})
      1.   u*B(i, n, u)
    ✗ 2. = (i + 1)*B(i + 1, n + 1, u)/n    wrong: n = 1, i = 0, u = 1/2: 1/4 on the left, 1/2 on the right
    ✓ 3. = (i + 1)*B(i + 1, n + 1, u)/(n + 1)    right again: equals line 1, as line 2 does not
    REFUTED: line 2 is the first wrong one; the last line equals the first
    """
    if not isinstance(lines, Iterable):
        raise ValueError(f"the lines are {lines!r}: a list of expressions is needed")
    clock, lines = Budget(budget), tuple(lines)
    try:
        accepted, faults, found = _understood(lines, given)
    except InvalidStatement as error:
        untold = tuple(Line(number, line, OPEN) for number, line in enumerate(lines, 1))
        return Judgement(INVALID, untold, seconds=clock.spent, note=str(error))
    numbers, chain = list(accepted), list(accepted.values())
    verdicts = chain_verdicts(chain, numbers, found, clock)
    judged = {number: _line(place, numbers, chain, verdicts, found) for place, number in enumerate(numbers)}
    judged |= {number: Line(number, lines[number - 1], MEANINGLESS, note=why) for number, why in faults.items()}
    judged = tuple(judged[number] for number in sorted(judged))
    first_and_last = verdicts.get((0, len(chain) - 1)) if {1, len(lines)} <= set(accepted) else None
    status, note = _status(judged, first_and_last)
    return Judgement(status, judged, first_and_last, clock.spent, note)


def _understood(lines, given):
    """The lines that mean something by their numbers, what is wrong with the others, and where all symbols range.

    ``InvalidStatement`` if the fault lies in what is given.
    """
    accepted, faults = {}, {}
    for number, line in enumerate(lines, 1):
        try:
            _check_line(line, list(accepted.values()))
            accepted[number] = expression(line)
        except InvalidStatement as error:
            faults[number] = str(error)
    chain = list(accepted.values())
    found = ranges(chain, about(chain, given) if faults or len(chain) < 2 else given)
    return {number: with_checked_binders(line, found) for number, line in accepted.items()}, faults, found


def _check_line(line, others):
    """``InvalidStatement`` if a line means nothing beside the others."""
    chain = [*others, expression(line)]
    try:
        found = ranges(chain, None)
        evaluator(chain[-1], tuple(found))
        for each in chain:
            with_checked_binders(each, found)
    except RecursionError:
        raise InvalidStatement("the expression is nested too deeply") from None
    for other in others:
        check_kinds(other, "=", chain[-1])


def _line(place, numbers, chain, verdicts, found):
    number, line = numbers[place], chain[place]
    if place == 0:
        return Line(number, line, START)
    before, first = numbers[place - 1], numbers[0]
    step, whole = verdicts[place - 1, place], verdicts[0, place]
    returns = form(line) == form(chain[0])
    remark = _remark(step, whole, place > 1 and verdicts[0, place - 1].status == REFUTED)
    if remark != MEANINGLESS and form(line) == form(chain[place - 1]):
        remark = NO_PROGRESS
    elif remark == OPEN and step.status == REFUTED and returns:
        remark = RIGHT_AGAIN
    why = {
        FOLLOWS: step.method,
        NO_PROGRESS: f"the same as line {before}",
        WRONG: "",
        RIGHT_AGAIN: f"the same as line {first}" if returns else f"equals line {first}, as line {before} does not",
        STILL_WRONG: f"follows from line {before}" if step.status in HOLDS else step.note,
    }.get(remark, step.note)
    if step.status == REFUTED and remark in (CHECKED_ONLY, OPEN, MEANINGLESS):
        why = f"differs from line {before}; against line {first}: {whole.note}"
    differs = f"differs from line {first}" if whole.status == REFUTED and remark != WRONG else ""
    note = "; ".join(part for part in (why, _alone(place, chain, found, remark), differs) if part)
    return Line(number, line, remark, step, whole, note)


def _remark(step, whole, wrong_before):
    """The remark on a line, its form left aside; against a wrong line before it, what counts is the first line."""
    if step.status == REFUTED and whole.status in HOLDS:
        return RIGHT_AGAIN
    if step.status == REFUTED and (whole.status == REFUTED or not wrong_before):
        return WRONG
    if wrong_before and whole.status == REFUTED and step.status != UNDECIDED:
        return STILL_WRONG
    decisive = whole if step.status == REFUTED else step
    return {CHECKED: CHECKED_ONLY, UNDECIDED: OPEN, INVALID: MEANINGLESS}.get(decisive.status, FOLLOWS)


def _alone(place, chain, found, remark):
    """Words on the symbols that are in this line only."""
    others = set().union(*(line.free_symbols for other, line in enumerate(chain) if other != place))
    names = [str(symbol) for symbol in found if symbol in chain[place].free_symbols - others]
    if not names:
        return ""
    one = len(names) == 1
    cancel = f", and cancel{'s' * one}" if remark in (FOLLOWS, RIGHT_AGAIN) else ""
    return f"{', '.join(names)} {'is' if one else 'are'} in no other line{cancel}"


def _status(lines, whole):
    """The status of all equalities together, and why they are not a derivation if they are not."""
    if len(lines) < 2:
        return INVALID, "a derivation has at least two lines"
    invalid = next((line for line in lines if line.remark == MEANINGLESS), None)
    if invalid is not None:
        return INVALID, f"line {invalid.number} is invalid"
    found = [verdict.status for line in lines[1:] for verdict in (line.step, line.whole)]
    if REFUTED in found:
        return REFUTED, ""
    steps = {line.step.status for line in lines[1:]}
    if steps <= set(HOLDS) and whole.status in HOLDS:
        return (ARGUED if ARGUED in steps else PROVED), ""
    return (CHECKED if steps <= {*HOLDS, CHECKED} else UNDECIDED), ""
