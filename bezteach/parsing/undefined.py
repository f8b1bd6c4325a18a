"""What may have no value, and must not get lost: t/t is 1, but not where t = 0, so SymPy must not cancel it."""

from functools import lru_cache

from sympy import Derivative, Indexed, Integral, Mul, Pow, Sum, binomial, factorial

from ..symbolic import B, E


def kept(evaluated, written):
    """``evaluated``, what SymPy makes of a formula, if all that may have no value is still there, or else ``written``.

    >>> from bezteach.symbolic import n, t
    >>> print(kept(t / t, Mul(t, 1 / t, evaluate=False)), kept(n / n**2, Mul(n, n**-2, evaluate=False)))
    t/t 1/n
    """
    return evaluated if risks(written) <= risks(evaluated) else written


@lru_cache(maxsize=4096)
def risks(expr):
    """What may have no value somewhere in a formula: a frozenset of pairs, the letters bound around it, and what it is.

    A divisor counts by its factors, whatever numbers, signs and powers of them stand there.

    >>> from bezteach.symbolic import i, n, t
    >>> risks(t**i / (2 - 2 * t) ** 2)
    frozenset({((), ('divides', t - 1))})
    >>> risks(Sum(t ** (n - i), (i, 0, 2 * n)))
    frozenset({(((i, 0, 2*n),), ('power', -i + n, t))})
    """
    bound, body = _bound(expr)
    found = {((*bound, *around), risk) for part in body for around, risk in risks(part)}
    rest = [part for part in expr.args if part not in body]
    return frozenset(found.union(*map(risks, rest), {((), risk) for risk in _own(expr)}))


def _bound(expr):
    """What a sum, integral or derivative runs over, and the parts in which it does; nothing of any other formula."""
    if isinstance(expr, Sum | Integral | Derivative):
        return expr.args[1:], expr.args[:1]
    return (), ()


def _own(expr):
    """What may make the value fail at this node, where its parts have one."""
    if isinstance(expr, Pow):
        return _in_power(expr.base, expr.exp)
    if isinstance(expr, Derivative):
        return [expr]
    if isinstance(expr, binomial | factorial | B):
        degree = expr.args[1] if isinstance(expr, B) else expr.args[0]
        return [] if degree.is_nonnegative and _are_whole(expr.args[:2]) else [expr]
    if isinstance(expr, Indexed):
        return [] if _are_whole(expr.indices) else [expr]
    if isinstance(expr, Sum):
        return [] if _are_whole(end for _, *ends in expr.limits for end in ends) else [expr.limits]
    return []


def _are_whole(forms):
    return all(form.is_integer for form in forms)


def _in_power(base, exponent):
    if base.as_base_exp()[0].is_Rational and base != 0:
        return []
    if not exponent.is_integer:
        return [("root", exponent.is_nonnegative, base.as_coeff_Mul()[1])]
    found = []
    for factor in Mul.make_args(base):
        inner, times = factor.as_base_exp()
        total = exponent * times
        if total.is_nonnegative or inner == E or (inner.is_Rational and inner != 0):
            continue
        found.append(("divides", _primitive(inner)) if total.is_Integer else ("power", total.primitive()[1], inner))
    return found


def _primitive(divisor):
    _, rest = divisor.primitive()
    return -rest if rest.could_extract_minus_sign() else rest
