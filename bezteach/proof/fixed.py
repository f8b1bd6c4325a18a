"""Fixed degrees: for each value of the integer symbols both sides are expanded, and compared as polynomials.

Equal polynomials in the real symbols are equal for all their values, since the evaluator divides by none of them. Where
the integer ranges are finite and all of it was done, that proves the statement; otherwise it is CHECKED for the degrees
listed, which is not a proof.
"""

from itertools import islice

from sympy import Max, Min, oo

from bezteach.symbolic import Step

from .certificate import ByCases
from .errors import InvalidStatement, OutOfTime, Unsupported
from .exact.evaluate import evaluator
from .exact.polynomial import VARIABLE, atom, to_sympy
from .exact.refuter import counterexample_at, prober
from .exact.walk import integer_points
from .ranges import Integers
from .verdict import CHECKED, PROVED, REFUTED, Proof

MOST_CASES = 3_000
HIGHEST = {1: 8, 2: 5}
STEPS_SHOWN = 9
VALUES_TRIED = 60


def by_cases(statement, budget):
    """A ``Proof``: PROVED by all cases, CHECKED for some degrees, REFUTED if a case fails; None if it decides nothing.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import B, i, n, t
    >>> by_cases(statement(B(i, n, t), B(n - i, n, 1 - t), {n: (2, 3), i: (0, n)}), Budget(5)).status
    'PROVED'
    >>> by_cases(statement(B(i, n, t), B(n - i, n, 1 - t), {i: (0, n)}), Budget(5)).note
    'exact for n = 0..8 and every value of the other symbols, and for nothing else'
    """
    try:
        return _all_cases(statement, budget) or _some_degrees(statement, budget)
    except Unsupported:
        return None


def _all_cases(statement, budget):
    if _endless(statement.ranges):
        return None
    try:
        cases = list(islice(integer_points(statement.ranges, None, budget), MOST_CASES + 1))
        if not cases:
            raise InvalidStatement("the ranges of the integers allow no value")
        if len(cases) > MOST_CASES:
            return None
        done, failed = _hold(statement, cases, budget)
    except OutOfTime:
        return None
    if failed or len(done) < len(cases):
        return failed
    number = "the only case" if len(cases) == 1 else f"all {len(cases)} cases"
    note, certificate = f"{number}, as identities of polynomials", ByCases(tuple(done))
    return Proof(PROVED, "all cases", steps_of(statement, done), note, certificate=certificate)


def _some_degrees(statement, budget):
    wide = _endless(statement.ranges) or _numerous(statement.ranges)
    if not wide or any(statement.ranges[symbol].low is -oo for symbol in wide):
        return None
    span = HIGHEST.get(len(wide), 3)
    ranges = {symbol: _capped(found, span) if symbol in wide else found for symbol, found in statement.ranges.items()}
    points = integer_points(ranges, None, budget)
    try:
        cases = list(islice(points, MOST_CASES + 1))
    except OutOfTime:
        return None
    done, failed = _hold(statement, cases[:MOST_CASES], budget)
    if failed or not done:
        return failed
    first = next(iter(ranges))
    if len(done) < len(cases):
        # Out of time, or too many: the last value of the first symbol is not finished.
        last = cases[len(done)][0] - 1
        if first not in wide or last < cases[0][0]:
            return None
        ranges[first] = Integers(ranges[first].low, last)
    listed = ", ".join(f"{symbol} = {ranges[symbol].low}..{ranges[symbol].high}" for symbol in ranges if symbol in wide)
    note = f"exact for {listed} and every value of the other symbols, and for nothing else"
    return Proof(CHECKED, "fixed degrees", steps_of(statement, done), note)


def _hold(statement, cases, budget):
    """The cases in which the relation holds, each with the values of both sides, up to the end of the budget; and a
    refutation if it fails in one of them.
    """
    probe, values, done = prober(statement), both_sides(statement), []
    try:
        for case in cases:
            budget.spend()
            if probe((*case, *letters(statement)), budget) is not None:
                return done, _refuted(statement, case, budget)
            done.append((case, *values(case, budget)))
    except OutOfTime:
        pass
    return done, None


def both_sides(statement):
    """A function of the values of the integer symbols: both sides, as polynomials in the real ones."""
    symbols, reals = tuple(statement.ranges), letters(statement)
    left = evaluator(statement.lhs, symbols)
    right = left if statement.relation == "=" else evaluator(statement.rhs, symbols)  # the refuter has compared them

    def values(case, budget):
        value = left((*case, *reals), budget)
        return value, value if right is left else right((*case, *reals), budget)

    return values


def letters(statement):
    """The real symbols, each as the polynomial that it is."""
    reals = [symbol for symbol, found in statement.ranges.items() if not isinstance(found, Integers)]
    return tuple(atom(VARIABLE, symbol.name) for symbol in reals)


def _refuted(statement, case, budget):
    """Different polynomials differ somewhere: find where, within the ranges of the real symbols."""
    found = counterexample_at(statement, case, budget, VALUES_TRIED)
    if found.undefined:
        raise InvalidStatement(f"neither side has a value at {found.undefined.point()}")
    if found.counterexample is None:
        raise Unsupported("the sides differ, but at no value that was tried")
    return Proof(REFUTED, "refuter", note=str(found), counterexample=found.counterexample)


def steps_of(statement, cases):
    """The lines for the first of the cases (values, left, right)."""
    shown = cases[:STEPS_SHOWN] if statement.relation == "=" else ()
    return tuple(_step(statement, case, value) for case, value, _ in shown)


def _step(statement, case, value):
    where = ", ".join(f"{symbol} = {number}" for symbol, number in zip(statement.ranges, case, strict=False))
    return Step(to_sympy(value), f"both sides, expanded{' for ' if where else ''}{where}")


def _endless(ranges):
    """The integer symbols without a first or a last value."""
    return [s for s, found in ranges.items() if isinstance(found, Integers) and (found.low is -oo or found.high is oo)]


def _numerous(ranges):
    """The integer symbols with more values than can be done one by one."""
    sizes = {s: found.high - found.low for s, found in ranges.items() if isinstance(found, Integers)}
    return [symbol for symbol, size in sizes.items() if size.is_number and size > HIGHEST[1]]


def _capped(found, span):
    return Integers(found.low, Min(found.high, Max(found.low + span // 2, span)))
