"""SymPy cannot be interrupted while it multiplies out, cancels or factors: what is too large for that is not begun."""

from math import comb, prod

from sympy import Add, Mul, Pow, Rational, Symbol, cancel, factor

from .failure import Failure

LARGEST = 100  # degree times number of symbols, which takes a few seconds at most
MOST = 5000  # terms of a polynomial
MOST_TERMS = 400  # hypergeometric terms of a sum


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


def most_terms(expr):
    """At most how many terms an expression, or one of its parts, has when multiplied out; not counted beyond ``MOST``.

    >>> from bezteach.symbolic import n, t
    >>> most_terms((n + t + 1) ** 3), most_terms((n + 1) ** 3 * (n + 2) ** 3), most_terms(2**n * (n + t) ** 400)
    (10, 7, 401)
    """
    if expr.is_Mul and degree(expr) is None:
        plain = [part for part in expr.args if degree(part) is not None]
        count = most_terms(Mul(*plain)) * prod(most_terms(part) for part in expr.args if part not in plain)
        return min(count, MOST + 1)
    counts = [most_terms(part) for part in expr.args]
    if expr.is_Add:
        count = sum(counts)
    elif expr.is_Mul:
        count = prod(counts)
    elif expr.is_Pow and expr.exp.is_Integer:
        count = comb(abs(int(expr.exp)) + counts[0] - 1, counts[0] - 1)
    else:
        count = max(counts, default=1)
    highest, symbols = degree(expr), len(expr.free_symbols)
    return min(count, MOST + 1, count if highest is None else comb(highest + symbols, highest))


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
