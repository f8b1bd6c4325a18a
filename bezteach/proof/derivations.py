"""``check_derivation``: a chain of equalities, each line judged against the line before it and against the first.

All lines speak of the same values: what a symbol is, and where it ranges, is read off all of them together. A symbol
that a line brings in alone must cancel, since the line has to hold for all its values. A line that is no expression, or
does not fit the lines above it, is left out, and the next one is judged against the last line that means something.
"""

from collections import Counter
from dataclasses import replace

from sympy import Add, Mul, oo

from .budget import Budget
from .certificate import Through
from .engine import decided
from .errors import InvalidStatement, OutOfTime
from .exact.evaluate import evaluator, expression
from .exact.refuter import Counterexample
from .judgement import (
    CHECKED_ONLY,
    FOLLOWS,
    HOLDS,
    MEANINGLESS,
    NO_PROGRESS,
    NOT_SETTLED,
    OPEN,
    RIGHT_AGAIN,
    START,
    STILL_WRONG,
    WRONG,
    Judgement,
    Line,
)
from .ranges import Integers, about, ends, ranges
from .statement import Statement, check_binders, check_kinds
from .terms.linear import coefficients, least
from .verdict import (
    ARGUED,
    CHECKED,
    INVALID,
    PROVED,
    REFUTED,
    UNDECIDED,
    Proof,
    Verdict,
    verdict_of,
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
    clock, lines = Budget(budget), tuple(lines)
    try:
        accepted, faults, found = _understood(lines, given)
    except InvalidStatement as error:
        untold = tuple(Line(number, line, OPEN) for number, line in enumerate(lines, 1))
        return Judgement(INVALID, untold, seconds=clock.spent, note=str(error))
    numbers, chain = list(accepted), list(accepted.values())
    verdicts = _verdicts(chain, numbers, found, clock)
    while any([_complete(verdicts, place, numbers) for place in range(2, len(chain))]):
        pass
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
    for line in chain:
        check_binders(line, found)
    return accepted, faults, found


def _check_line(line, others):
    """``InvalidStatement`` if a line means nothing beside the others."""
    chain = [*others, expression(line)]
    try:
        found = ranges(chain, None)
        evaluator(chain[-1], tuple(found))
        for each in chain:
            check_binders(each, found)
    except RecursionError:
        raise InvalidStatement("the expression is nested too deeply") from None
    for other in others:
        check_kinds(other, "=", chain[-1])


def _verdicts(chain, numbers, found, clock):
    """The verdict on the equality of any two lines next to each other, and of any one with the first, by their places.

    What follows from the verdicts before needs no time; any other gets an equal part of what is left of the budget.
    """
    verdicts = {}

    def judge(one, other, left):
        claim = _claim(chain[one], chain[other], found)
        verdicts[one, other] = _judged(claim, clock.part(1 / left))

    for place in range(1, len(chain)):
        left = 2 * (len(chain) - place)
        judge(place - 1, place, left)
        if place == 1:
            continue
        if _form(chain[place]) == _form(chain[place - 1]):
            verdicts[0, place] = verdicts[0, place - 1]
            continue
        verdicts[0, place] = Verdict(UNDECIDED, statement=_claim(chain[0], chain[place], found))
        if not _complete(verdicts, place, numbers):
            judge(0, place, left - 1)
    return verdicts


def _judged(claim, clock):
    try:
        clock.spend()
        proof = decided(claim, clock)
    except OutOfTime:
        proof = Proof(UNDECIDED, "", note="out of time")
    except InvalidStatement as error:
        proof = Proof(INVALID, "", note=str(error))
    except RecursionError:
        proof = Proof(INVALID, "", note="the expression is nested too deeply")
    return verdict_of(proof, claim, clock.spent)


def _claim(left, right, found):
    """That two lines are equal, with the ranges of their symbols.

    A symbol that is in neither line stays if it may leave other symbols without a value: where i goes from 1 to n - 1,
    nothing is said of n = 1, in lines without i neither.
    """
    wanted, kept = left.free_symbols | right.free_symbols, set()
    for place, (symbol, values) in reversed(list(enumerate(found.items()))):
        if symbol in wanted or not _has_values(values, list(found.items())[:place]):
            kept.add(symbol)
            wanted |= set().union(*(end.free_symbols for end in ends(values)))
    return Statement(left, "=", right, {symbol: values for symbol, values in found.items() if symbol in kept})


def _has_values(values, before):
    """Whether a range is known to hold a value, whatever the symbols before it are."""
    low, high = ends(values)
    if low is -oo or high is oo or (low.is_number and high.is_number):
        return True
    if not isinstance(values, Integers) or not all(c.is_Integer for c in (coefficients(low) or {low: oo}).values()):
        return False
    conditions = []
    for symbol, other in before:
        if isinstance(other, Integers):
            conditions += [symbol - other.low] * (other.low is not -oo) + [other.high - symbol] * (other.high is not oo)
    return least(high - low, conditions) >= 0


def _form(expr):
    """The same for expressions that differ in nothing but the order of their terms and factors."""
    if not expr.args:
        return None, expr
    if not isinstance(expr, Add | Mul) or not expr.is_commutative:
        return expr.func, tuple(map(_form, expr.args))
    return expr.func, frozenset(Counter(map(_form, _flat(expr, expr.func))).items())


def _flat(expr, kind):
    for part in expr.args:
        yield from _flat(part, kind) if isinstance(part, kind) else (part,)


def _complete(verdicts, place, numbers):
    """Of three lines, two equalities settle the third: fill in what was left open, and say whether there was any."""
    triangle = ((0, place - 1), (place - 1, place), (0, place))
    for key in triangle:
        if verdicts[key].status in NOT_SETTLED:
            news = _from_others([verdicts[pair] for pair in triangle if pair != key], turned=verdicts[0, place])
            if news is not None:
                (between,) = {0, place - 1, place} - set(key)
                how = {"method": f"through line {numbers[between]}", "note": "", "steps": (), "certificate": None}
                verdicts[key] = replace(verdicts[key], **how | news)
                return True
    return False


def _from_others(others, turned):
    """What two sides of a triangle of equalities make of the third; if ``turned`` is the one that holds, the sides of
    the counterexample are exchanged.
    """
    holding = [verdict for verdict in others if verdict.status in HOLDS]
    failing = [verdict for verdict in others if verdict.status == REFUTED]
    if len(holding) == 2:
        status = ARGUED if ARGUED in (verdict.status for verdict in holding) else PROVED
        return {"status": status, "certificate": Through(tuple(holding))}
    if not holding or not failing:
        return None
    values, left, right = failing[0].counterexample
    left, right = (right, left) if holding[0] is turned else (left, right)
    return {"status": REFUTED, "counterexample": Counterexample(values, left, right)}


def _line(place, numbers, chain, verdicts, found):
    number, line = numbers[place], chain[place]
    if place == 0:
        return Line(number, line, START)
    before, first = numbers[place - 1], numbers[0]
    step, whole = verdicts[place - 1, place], verdicts[0, place]
    returns = _form(line) == _form(chain[0])
    remark = _remark(step, whole, place > 1 and verdicts[0, place - 1].status == REFUTED)
    if remark != MEANINGLESS and _form(line) == _form(chain[place - 1]):
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
