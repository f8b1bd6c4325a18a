"""SymPy cannot be interrupted while it multiplies out, cancels or factors: what is too large for that is not begun."""

from math import comb, prod

from sympy import Add, Mul, Pow, Rational, Symbol, cancel, expand, factor, fraction, together

from .failure import Failure

LARGEST = 100  # degree times number of symbols, which takes a few seconds at most
HIGHEST = 1000  # degree of what is cancelled in one symbol
MOST = 5000  # terms of a polynomial
MOST_TO_FACTOR = 250  # likewise, in three symbols and more
MOST_TERMS = 400  # hypergeometric terms of a sum


def degree(expr):
    """At most the degree of a rational function of its symbols that is multiplied out; None for anything else.

    >>> from bezteach.symbolic import n, t
    >>> degree((n * t + 1) ** 3), degree(n + t**2 + 1 / n**4), degree(t**n)
    (6, 6, None)
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
    if None in degrees:
        return None
    return sum(degrees) if expr.is_Mul else _of_sum(expr.args, degrees)


def _of_sum(parts, degrees):
    """Each part is multiplied by the denominators that others have and it has not."""
    below = [_denominators(part) for part in parts]
    common = {base: max(one.get(base, 0) for one in below) for base in set().union(*below)}
    return max(
        own + sum((times - one.get(base, 0)) * degree(base) for base, times in common.items())
        for own, one in zip(degrees, below, strict=True)
    )


def _denominators(part):
    """{base: exponent} of what a product divides by."""
    powers = [factor.as_base_exp() for factor in Mul.make_args(part)]
    return {base: -int(times) for base, times in powers if times.is_negative and not base.is_Rational}


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
    """A rational function in lowest terms; ``Failure`` where it is too large."""
    check_size(expr, LARGEST if len(expr.free_symbols) > 1 else HIGHEST)
    numerator, denominator = fraction(together(expr))  # SymPy would multiply all, those that divide one another too
    return cancel(expand(numerator, power_base=False, power_exp=False) / denominator)


def factored(expr):
    """A rational function as a product; ``Failure`` where it is too large.

    In three symbols and more SymPy's luck decides whether hundreds of terms take seconds or hours.
    """
    check_size(expr)
    if len(expr.free_symbols) > 2 and most_terms(expr) > MOST_TO_FACTOR:
        raise Failure("what would have to be factored is too large")
    return factor(expr)


def check_size(expr, largest=LARGEST):
    """``Failure`` where the degree of a rational function times the number of its symbols is too large."""
    symbols = len(expr.free_symbols)
    if (degree(expr) or 0) * symbols > largest or (symbols > 1 and most_terms(expr) > MOST):
        raise Failure("what would have to be multiplied out is too large")
