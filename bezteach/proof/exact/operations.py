"""Builders of what has values for its arguments: sums of terms, products, powers, functions, cases.

Every part must have a value, so that 0 times an undefined number is undefined; only the cases of a ``Piecewise`` that
are not taken need none.
"""

from operator import eq, ge, gt, le, lt, ne

import sympy as sp

from bezteach.symbolic import B

from ..errors import InvalidStatement, Undefined, Unsupported
from . import arithmetic as exact
from .closure import BUILDERS, closure
from .polynomial import Polynomial


def _add(expr, scope):
    terms = [closure(term, scope) for term in expr.args]

    def total(frame):
        value, rest = 0, iter(terms)
        try:
            for term in rest:
                value = value + term(frame)
        except Unsupported:
            _look_for_undefined(rest, frame)
            raise
        return value

    return total


def _mul(expr, scope):
    factors = [closure(factor, scope) for factor in expr.args]

    def product(frame):
        value, rest = 1, iter(factors)
        try:
            for factor in rest:
                value = value * factor(frame)
                if isinstance(value, Polynomial):
                    frame[0].spend()
        except Unsupported:
            _look_for_undefined(rest, frame)
            raise
        return exact.small(value)

    return product


def _look_for_undefined(rest, frame):
    """Whatever the part is that cannot be evaluated, the whole has no value if one of the others has none."""
    for part in rest:
        try:
            part(frame)
        except Unsupported:
            continue


def _function(apply):
    """For a function that only needs the values of its arguments."""

    def build(expr, scope):
        arguments = [closure(argument, scope) for argument in expr.args]

        def value(frame):
            rest = iter(arguments)
            try:
                values = [argument(frame) for argument in rest]
            except Unsupported:
                _look_for_undefined(rest, frame)
                raise
            return apply(*values)

        return value

    return build


def _on_numbers(name, apply):
    return _function(lambda *values: apply(*[exact.number(value, name) for value in values]))


def _piecewise(expr, scope):
    branches = [(closure(value, scope), _condition(condition, scope)) for value, condition in expr.args]

    def value(frame):
        for branch, condition in branches:
            if condition(frame):
                return branch(frame)
        raise Undefined(f"none of the cases of {expr}")

    return value


_COMPARED = {sp.Eq: eq, sp.Ne: ne, sp.Ge: ge, sp.Gt: gt, sp.Le: le, sp.Lt: lt}


def _condition(expr, scope):
    if expr in (sp.true, sp.false):
        return lambda frame: expr == sp.true
    if isinstance(expr, sp.And | sp.Or):
        parts, decide = [_condition(part, scope) for part in expr.args], all if isinstance(expr, sp.And) else any
        return lambda frame: decide([part(frame) for part in parts])
    if isinstance(expr, sp.Not):
        part = _condition(expr.args[0], scope)
        return lambda frame: not part(frame)
    if type(expr) not in _COMPARED:
        raise InvalidStatement(f"{expr} is not a condition that is known here")
    compare, left, right = _COMPARED[type(expr)], closure(expr.lhs, scope), closure(expr.rhs, scope)
    return lambda frame: compare(exact.number(left(frame), "a condition"), exact.number(right(frame), "a condition"))


BUILDERS |= {
    sp.Add: _add,
    sp.Mul: _mul,
    sp.Pow: _function(exact.power),
    B: _function(exact.bernstein),
    sp.binomial: _function(exact.binomial),
    sp.factorial: _function(exact.factorial),
    sp.FallingFactorial: _function(exact.falling),
    sp.RisingFactorial: _function(exact.rising),
    sp.Abs: _on_numbers("the absolute value", abs),
    sp.Max: _on_numbers("the maximum", lambda *values: max(values)),
    sp.Min: _on_numbers("the minimum", lambda *values: min(values)),
    sp.floor: _on_numbers("the floor", lambda value: value.__floor__()),
    sp.ceiling: _on_numbers("the ceiling", lambda value: value.__ceil__()),
    sp.KroneckerDelta: _on_numbers("the Kronecker symbol", lambda i, j, *_: int(i == j)),
    sp.Piecewise: _piecewise,
}
