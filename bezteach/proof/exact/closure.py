"""An expression as a Python function of a frame: the list of the budget and of what every name is worth.

A builder makes that function for one kind of expression; ``BUILDERS`` has them all, and each module of builders adds
its own. The function of the whole is nested from those of its parts, so that the tree is looked at once and not at each
point.
"""

from fractions import Fraction

import sympy as sp
from sympy.core.numbers import Infinity, NegativeInfinity

from bezteach.symbolic import E

from ..errors import InvalidStatement, Unsupported
from . import arithmetic as exact
from .polynomial import OPERATOR, POINT, atom

DEEPEST = 100
BUILDERS = {}


class Scope:
    """Which place of the frame a name means here; every binder takes a new place."""

    def __init__(self, places, taken, depth=0):
        self.places, self.taken, self.depth = places, taken, depth

    def deeper(self):
        return Scope(self.places, self.taken, self.depth + 1)

    def bind(self, symbol):
        place = self.taken[0]
        self.taken[0] += 1
        return place, Scope({**self.places, symbol: place}, self.taken, self.depth)


def closure(expr, scope):
    """The function of a frame that an expression is."""
    if scope.depth > DEEPEST:
        raise InvalidStatement(f"an expression nested more than {DEEPEST} deep")
    for kind in type(expr).__mro__:
        if kind in BUILDERS:
            return BUILDERS[kind](expr, scope.deeper())
    if isinstance(expr, sp.Float):
        raise InvalidStatement(f"{expr} is a float: write it as a fraction")
    if expr is sp.S.Exp1:
        raise InvalidStatement("this E is Euler's number; the operator is bezteach.symbolic.E")
    raise InvalidStatement(f"{expr} is of a kind that is not known here: {type(expr).__name__}")


def _constant(expr, scope):
    value = int(expr.p) if expr.q == 1 else Fraction(int(expr.p), int(expr.q))
    return lambda frame: value


def _infinity(expr, scope):
    def value(frame):
        raise Unsupported("infinity")

    return value


def _symbol(expr, scope):
    if expr == E and expr not in scope.places:
        operator = atom(OPERATOR, "E")
        return lambda frame: operator
    if expr not in scope.places:
        raise InvalidStatement(f"{expr} has no value")
    place = scope.places[expr]
    return lambda frame: frame[place]


def _point(expr, scope):
    name, indices = str(expr.base.label), [closure(index, scope) for index in expr.indices]
    return lambda frame: atom(POINT, name, *[exact.whole(index(frame), f"an index of {name}") for index in indices])


BUILDERS |= {
    sp.Rational: _constant,
    Infinity: _infinity,
    NegativeInfinity: _infinity,
    sp.Symbol: _symbol,
    sp.Indexed: _point,
}
