"""The indices of sums and products: symbols of their own, of which nothing is assumed that their limits do not say."""

from collections import Counter

from sympy import Add, Dummy, Mul, Pow, Product, Sum, Symbol
from sympy.core.function import Application


def with_indices(expr, letter):
    """Each index of a sum or product replaced by ``letter(index, low, high)``, from the outermost on."""
    if not expr.has(Sum, Product):
        return expr
    if not isinstance(expr, Sum | Product):
        return rebuilt(expr, [with_indices(part, letter) for part in expr.args])
    function, inner, limits = expr.function, list(expr.limits), []
    while inner:  # its ends are outside, and stay
        index, *ends = inner.pop()
        other = {index: letter(index, *ends)}
        function, inner = renamed(function, other), [renamed(limit, other) for limit in inner]
        limits.insert(0, (other[index], *ends))
    return expr.func(with_indices(function, letter), *limits)


def renamed(expr, names):
    """The expression with other symbols, or other parts, {part: part}, and for the rest as it stands.

    >>> from bezteach.symbolic import i, k
    >>> renamed(Mul(i, 1 / i, evaluate=False), {i: k})
    k/k
    """
    if expr in names:
        return names[expr]
    return rebuilt(expr, [renamed(part, names) for part in expr.args]) if expr.args else expr


def rebuilt(expr, parts):
    """The expression with other parts, as it stands: what SymPy would cancel, or work out, may not be defined.

    >>> from sympy import binomial
    >>> from bezteach.symbolic import n
    >>> rebuilt(binomial(n, 0, evaluate=False), [n - 30, 0])
    binomial(n - 30, 0)
    """
    if parts == list(expr.args):
        return expr
    result = expr.func(*parts)
    if not isinstance(expr, Add | Mul | Pow | Application):
        return result
    as_it_stands = result.func is expr.func and Counter(result.args) == Counter(parts)
    return result if as_it_stands else expr.func(*parts, evaluate=False)


def with_fresh_indices(expr):
    """Every index a symbol of its own, so that it is never taken for a symbol outside of the same name.

    >>> from bezteach.symbolic import i, n
    >>> with_fresh_indices(Sum(i, (i, 0, i), (i, 1, n)))
    Sum(_i, (_i, 0, _i), (_i, 1, n))
    """
    return with_indices(expr, lambda index, *ends: Dummy(index.name, integer=True))


def with_true_indices(expr):
    """No index is assumed to have a sign that its limits do not give it: SymPy goes by what is assumed.

    >>> from bezteach.symbolic import k, n
    >>> [sum.limits[0][0].is_nonnegative for sum in map(with_true_indices, (Sum(k, (k, 0, n)), Sum(k, (k, -1, n))))]
    [True, None]
    """
    return with_indices(expr, lambda index, low, high: index if stays(index, low, high) else _integer(index))


def stays(symbol, low, high):
    """Whether all values from low to high have the sign that is assumed of a symbol."""
    signs = (
        (symbol.is_nonnegative, low.is_nonnegative),
        (symbol.is_positive, low.is_positive),
        (symbol.is_nonpositive, high.is_nonpositive),
        (symbol.is_negative, high.is_negative),
    )
    return all(known or not assumed for assumed, known in signs)


def _integer(index):
    return Symbol(index.name, integer=True)
