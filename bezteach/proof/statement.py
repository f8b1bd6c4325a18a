"""What a statement is: two expressions, a relation between them, and where their symbols range."""

from typing import NamedTuple

import sympy as sp

from bezteach.symbolic import E, latex, plain

from .errors import InvalidStatement
from .exact.evaluate import evaluator, expression
from .indices import stays, with_true_indices
from .ranges import SIGNS, ranges

RELATIONS = {sp.Eq: "=", sp.Ge: ">=", sp.Gt: ">", sp.Le: "<=", sp.Lt: "<"}
_IN_LATEX = {">=": r"\ge", "<=": r"\le"}


class Statement(NamedTuple):
    """lhs relation rhs for all values in the ranges, a dict {symbol: Integers or Interval} in the order of the walk."""

    lhs: sp.Expr
    relation: str
    rhs: sp.Expr
    ranges: dict

    def __repr__(self):
        return f"{plain(self.lhs)} {self.relation} {plain(self.rhs)}"

    def _repr_latex_(self):
        return rf"$\displaystyle {self.latex()}$"

    def latex(self):
        """The statement as the course writes it."""
        return f"{latex(self.lhs)} {_IN_LATEX.get(self.relation, self.relation)} {latex(self.rhs)}"


def statement(lhs, rhs=None, given=None):
    """The statement that lhs = rhs, or that a relation holds; ``given`` is {symbol: (low, high) or Interval}.

    ``InvalidStatement`` says what is wrong: what SymPy has already made True or False, a symbol that is neither integer
    nor real, two symbols of one name, a range of a symbol that does not occur, an empty or circular range, a function
    that is not known, a Sum without limits, an operator or points in an inequality, an operator added to a point.

    >>> from bezteach.symbolic import B, i, n, t
    >>> statement(B(i, n, t), B(n - i, n, 1 - t), {i: (0, n)}).ranges
    {n: Integers(low=0, high=oo), i: Integers(low=0, high=n), t: Interval(-oo, oo)}
    """
    left, relation, right = _parts(lhs, rhs)
    found = ranges([left, right], given)
    for side in (left, right):
        evaluator(side, tuple(found))
    sides = [with_checked_binders(side, found) for side in (left, right)]
    check_kinds(left, relation, right)
    return Statement(sides[0], relation, sides[1], found)


def _parts(lhs, rhs):
    if rhs is not None:
        return expression(lhs), "=", expression(rhs)
    if isinstance(lhs, bool | sp.logic.boolalg.BooleanAtom):
        raise InvalidStatement(f"SymPy has already made it {lhs}: give both sides, or the relation with evaluate=False")
    if type(lhs) not in RELATIONS:
        raise InvalidStatement(f"{lhs!r} is not a statement: =, >=, >, <= or < between two expressions")
    return expression(lhs.lhs), RELATIONS[type(lhs)], expression(lhs.rhs)


def with_checked_binders(side, found):
    """The expression with true indices, where no variable leaves what is assumed of it."""
    limits = [limit for node in side.atoms(sp.Sum, sp.Product) for limit in node.limits]
    if not all(stays(*limit) for limit in limits):
        _check_points(side, [index for index, *_ in limits])
    true = with_true_indices(side)
    _check_binders(true, found)
    return true


def _check_points(side, indices):
    """SymPy tells the points of Subs apart by their names alone: there an index cannot become another symbol."""
    for node in side.atoms(sp.Subs):
        if any(point.has(*indices) for point in node.point):
            raise InvalidStatement(f"in {node} stands an index that may go beyond what is assumed of it")


def _check_binders(side, found):
    for node in sp.preorder_traversal(side):
        if isinstance(node, sp.Derivative):
            for symbol, _ in node.variable_count:
                if symbol in found and not isinstance(found[symbol], sp.Interval):
                    raise InvalidStatement(f"{node} differentiates by {symbol}, which is an integer")
        if isinstance(node, sp.Subs):
            _check_values(node, zip(node.variables, node.point, strict=True))
        if isinstance(node, sp.Integral):
            _check_values(node, node.limits)
        if isinstance(node, sp.Sum | sp.Product | sp.Integral):
            whole = not isinstance(node, sp.Integral)
            for symbol, *limits in node.limits:
                _check_bound(node, symbol, limits, found, whole)


def _check_values(node, places):
    """SymPy goes by what is assumed of a symbol, whatever stands in its place; of indices ``indices`` takes care."""
    for symbol, *values in places:
        assumed = [name for name in ("integer", *SIGNS) if getattr(symbol, f"is_{name}")]
        if not all(getattr(value, f"is_{name}") for name in assumed for value in values):
            raise InvalidStatement(f"in {node} the variable {symbol} may go beyond what is assumed of it")


def _check_bound(node, symbol, limits, found, whole):
    if (symbol.is_integer is False) if whole else symbol.is_integer:
        raise InvalidStatement(f"in {node} the variable {symbol} is declared {'not ' if whole else ''}integer")
    for limit in limits if whole else ():
        if limit.is_number and limit.is_finite and not limit.is_integer:
            raise InvalidStatement(f"{node} has the limit {limit}, which is not an integer")
        for name in limit.free_symbols:
            if isinstance(found.get(name), sp.Interval):
                raise InvalidStatement(f"{node} has the limit {limit}, and {name} is real")


def check_kinds(left, relation, right):
    points = [side.has(sp.Indexed) for side in (left, right)]
    operators = [side.has(E) and not with_points for side, with_points in zip((left, right), points, strict=True)]
    if relation != "=" and any(points + operators):
        raise InvalidStatement(f"{relation} between operators or points: only = has a meaning there")
    if any(points) and any(operators):
        raise InvalidStatement("an operator on one side and points on the other: let the operator act on a point")
    for total in {*left.atoms(sp.Add), *right.atoms(sp.Add)}:
        with_point = {part for part in total.args if part.has(sp.Indexed)}
        if with_point and any(part.has(E) for part in {*total.args} - with_point):
            raise InvalidStatement(f"{total}: an operator and a point cannot be added")
