"""The verdicts on the equalities of a chain: each line against the one before and the first, and what follows."""

from collections import Counter
from dataclasses import replace

from sympy import Add, Mul

from .certificate import Through
from .engine import decided
from .errors import InvalidStatement, OutOfTime
from .exact.refuter import Counterexample
from .judgement import HOLDS, NOT_SETTLED
from .ranges import ends
from .regions import has_values
from .statement import Statement
from .verdict import ARGUED, INVALID, PROVED, REFUTED, UNDECIDED, Proof, Verdict, verdict_of


def chain_verdicts(chain, numbers, found, clock):
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
        if form(chain[place]) == form(chain[place - 1]):
            verdicts[0, place] = verdicts[0, place - 1]
            continue
        verdicts[0, place] = Verdict(UNDECIDED, statement=_claim(chain[0], chain[place], found))
        if not _complete(verdicts, place, numbers):
            judge(0, place, left - 1)
    while any([_complete(verdicts, place, numbers) for place in range(2, len(chain))]):
        pass
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
        if symbol in wanted or not has_values(values, dict(list(found.items())[:place])):
            kept.add(symbol)
            wanted |= set().union(*(end.free_symbols for end in ends(values)))
    return Statement(left, "=", right, {symbol: values for symbol, values in found.items() if symbol in kept})


def form(expr):
    """The same for expressions that differ in nothing but the order of their terms and factors."""
    if not expr.args:
        return None, expr
    if not isinstance(expr, Add | Mul) or not expr.is_commutative:
        return expr.func, tuple(map(form, expr.args))
    return expr.func, frozenset(Counter(map(form, _flat(expr, expr.func))).items())


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
