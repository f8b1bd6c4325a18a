"""The exact evaluator, the only judge of the provers: plain recursion over the tree, no simplification, no ``doit``.

``evaluator`` turns an expression into nested Python functions once, to be called at many points; ``evaluate`` does
both. Values are numbers, or polynomials in what stays a letter: control points b[k], the operator E, and the variable
of a derivative or an integral while it is taken. An operator next to a point acts on it, E^k b[j] = b[j+k].

Conventions: an empty Sum is 0 and an empty Product 1, whatever the limits; every part must have a value, so that 0
times an undefined number is undefined; a Derivative is taken of a polynomial, as is an Integral, between limits. For
the functions see ``arithmetic``.
"""

from fractions import Fraction

import sympy as sp

from ..budget import Budget
from ..errors import InvalidStatement
from . import arithmetic as exact
from . import binders, operations  # noqa: F401  they add their builders
from .closure import Scope, closure
from .polynomial import Polynomial, acted

DEFAULT_SECONDS = 10.0


def evaluate(expr, values, budget=None):
    """The exact value of an expression where every free symbol has a value: an int, a Fraction or a polynomial.

    >>> from bezteach.symbolic import B, b, i, n, step, t
    >>> evaluate(B(i, n, t), {i: 1, n: 3, t: Fraction(1, 3)})
    Fraction(4, 9)
    >>> evaluate(step(t) ** n * b[0], {n: 2, t: Fraction(1, 2)})
    b[0]/4 + b[1]/2 + b[2]/4
    """
    return evaluator(expr, tuple(values))(tuple(values.values()), budget)


def evaluator(expr, symbols):
    """A function of (values of the symbols, in their order; a Budget or None) that gives the exact value."""
    scope = Scope({symbol: place for place, symbol in enumerate(symbols, 1)}, [1 + len(symbols)])
    run, count = closure(expression(expr), scope), scope.taken

    def value(values, budget=None):
        frame = [budget or Budget(DEFAULT_SECONDS), *map(_exact, values)]
        frame += [None] * (count[0] - len(frame))
        return acted(exact.small(run(frame)))

    return value


def expression(value):
    """The SymPy expression that a number or an expression is; a text, a float or a matrix is none."""
    if isinstance(value, int | Fraction) and not isinstance(value, bool):
        return sp.Rational(value.numerator, value.denominator)
    if not isinstance(value, sp.Expr):
        raise InvalidStatement(f"{value!r} is not an expression")
    return value


def _exact(value):
    if isinstance(value, sp.Rational):
        return Fraction(int(value.p), int(value.q))
    if isinstance(value, bool) or not isinstance(value, int | Fraction | Polynomial):
        raise TypeError(f"{value!r} is not an exact value")
    return value
