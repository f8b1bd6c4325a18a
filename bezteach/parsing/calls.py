"""The functions of the language: what each takes, and the SymPy node that it builds."""

from typing import Any, NamedTuple

from sympy import Abs, Derivative, Expr, Integral, Rational, Sum, Symbol

from ..symbolic import B, E, step
from .errors import BelowZero, InvalidAnswer
from .names import WHOLE
from .nodes import (
    MAX_EXPONENT,
    MAX_FACTORIAL,
    Item,
    binomial_of,
    bounded,
    calculate,
    expression,
    factorial_of,
    levels,
    power,
    whole_formula,
)

MAX_SUMS = 3


def call(rule, items, position):
    """What a function of the language makes of its arguments; ``position`` is where its name begins."""
    build, most, usage = RULES[rule]
    least = most if build not in _OPEN else 2
    if not least <= len(items) <= most:
        raise InvalidAnswer(f"this function takes other arguments: write {usage}", position)
    if build not in _OPEN:
        items = [Item(expression(*item), item.position) for item in items]
    return build(position, *items)


def basis(position, index, degree, at):
    """B(i, n, t), a node of its own: nothing is expanded."""
    whole_formula(index.value, "the index of B", MAX_EXPONENT, index.position)
    whole_formula(degree.value, "the degree of B", MAX_EXPONENT, degree.position, least=0)
    return bounded(B(index.value, degree.value, at.value), position)


def _binomial(_, upper, lower):
    return binomial_of(upper, lower)


def _factorial(_, value):
    return factorial_of(value.value, value.position)


def _root(_, value):
    return power(value.value, Rational(1, 2), value.position)


def _absolute(_, value):
    return abs(value.value) if value.value.is_Rational else Abs(value.value, evaluate=False)


def _fraction(_, upper, lower):
    return calculate("/", upper.value, lower.value, lower.position)


def _step(_, at):
    if at.value.has(E):
        raise InvalidAnswer("the step g takes a number such as t, not the operator E", at.position)
    return step(at.value)


def _sum(position, body, *limits):
    return sum_over(position, expression(*body), _limits("sum", position, limits))


def _integral(position, body, *limits):
    return integral_over(position, expression(*body), _limits("integral", position, limits))


def _limits(rule, position, items):
    """The triples letter, lower, upper: given as one triple or three arguments."""
    if len(items) == 3 and isinstance(items[0].value, Expr):
        return [items]
    triples = []
    for value, at in items:
        if not isinstance(value, tuple) or len(value) != 3:
            raise InvalidAnswer(f"the letter and its two limits are missing: write {RULES[rule].usage}", at)
        triples.append([Item(part, at) for part in value])
    return triples


def sum_over(position, body, triples):
    """Sum(body, (index, lower, upper), ...), never evaluated."""
    for index, *bounds in triples:
        if index.value not in WHOLE:
            raise InvalidAnswer("a sum runs over a letter of whole numbers: take one such as i, j, k", index.position)
        for bound in bounds:
            whole_formula(expression(*bound), "a limit of the sum", MAX_FACTORIAL, bound.position)
            _refuse_own_letter(index, bound)
        if index.value.is_nonnegative and not bounds[0].value.is_nonnegative:
            raise BelowZero(index.value.name)
    result = Sum(body, *[tuple(item.value for item in triple) for triple in triples])
    if levels(result, lambda node: isinstance(node, Sum) and len(node.limits)) > MAX_SUMS:
        raise InvalidAnswer(f"more than {MAX_SUMS} sums stand inside one another: write fewer", position)
    return result


def integral_over(position, body, triples):
    """Integral(body, (letter, lower, upper), ...), never evaluated."""
    for letter, *bounds in triples:
        if not isinstance(letter.value, Symbol) or letter.value in WHOLE or letter.value == E:
            raise InvalidAnswer("an integral runs over a letter for real numbers: take t or u", letter.position)
        for bound in bounds:
            expression(*bound)
            _refuse_own_letter(letter, bound)
    return Integral(body, *[tuple(item.value for item in triple) for triple in triples])


def _refuse_own_letter(letter, bound):
    if bound.value.has(letter.value):
        raise InvalidAnswer(f"the limit contains {letter.value} itself: take another letter", bound.position)


def _derivative(position, body, letter, order=None):
    if isinstance(letter.value, tuple) and len(letter.value) == 2 and order is None:
        letter, order = (Item(part, letter.position) for part in letter.value)
    return derivative_by(position, expression(*body), letter, order or Item(Rational(1), position))


def derivative_by(position, body, letter, order):
    """Derivative(body, (letter, order)), never evaluated."""
    if not isinstance(letter.value, Symbol) or letter.value in WHOLE:
        raise InvalidAnswer("a derivative is taken by a letter for real numbers: take t or u", letter.position)
    whole_formula(expression(*order), "the order of a derivative", MAX_EXPONENT, order.position, least=1)
    if isinstance(body, Derivative) and not all(inner.is_nonnegative for _, inner in body.variable_count):
        raise InvalidAnswer("the order inside may be negative: write one derivative, of the whole order", position)
    return Derivative(body, (letter.value, order.value))


class Rule(NamedTuple):
    build: Any
    most: int
    usage: str


RULES = {
    "B": Rule(basis, 3, "B(i, n, t)"),
    "binomial": Rule(_binomial, 2, "binomial(n, i)"),
    "factorial": Rule(_factorial, 1, "factorial(n)"),
    "sqrt": Rule(_root, 1, "sqrt(2)"),
    "abs": Rule(_absolute, 1, "abs(t)"),
    "g": Rule(_step, 1, "g(t)"),
    "fraction": Rule(_fraction, 2, "Fraction(1, 3)"),
    "sum": Rule(_sum, 4, "sum(i^2, i, 0, n)"),
    "integral": Rule(_integral, 4, "integral(t^2, t, 0, 1)"),
    "diff": Rule(_derivative, 3, "diff(t^2, t) or diff(t^2, t, 2)"),
}
_OPEN = (_sum, _integral, _derivative)
