"""SymPy cannot be interrupted while it cancels or factors: what is too large for that is not begun."""

from sympy import Add, Mul, Pow, Rational, Symbol, cancel, factor

from .failure import Failure

LARGEST = 100  # degree times number of symbols, which takes a few seconds at most


def degree(expr):
    """At most the degree of a rational function of its symbols that is multiplied out; None for anything else.

    >>> from bezteach.symbolic import n, t
    >>> degree((n * t + 1) ** 3), degree(n + t**2 + 1 / n**4), degree(t**n)
    (6, 4, None)
    """
    if isinstance(expr, Symbol | Rational):
        return int(expr.is_Symbol)
    if isinstance(expr, Pow):
        base, exponent = expr.as_base_exp()
        found = degree(base) if exponent.is_Integer else None
        return None if found is None else found * abs(int(exponent))
    if not isinstance(expr, Add | Mul):
        return None
    degrees = [degree(part) for part in expr.args]
    return None if None in degrees else sum(degrees) if expr.is_Mul else max(degrees)


def cancelled(expr):
    """A rational function in lowest terms; ``Failure`` where several symbols make it too large."""
    if len(expr.free_symbols) > 1:
        check_size(expr)
    return cancel(expr)


def factored(expr):
    """A rational function as a product; ``Failure`` where it is too large."""
    check_size(expr)
    return factor(expr)


def check_size(expr):
    """``Failure`` where a rational function is too large to be factored."""
    if (degree(expr) or 0) * len(expr.free_symbols) > LARGEST:
        raise Failure("what would have to be multiplied out is too large")
