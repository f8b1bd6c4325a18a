"""The order of two sums exchanged, where the range is a triangle."""

from sympy import Mul, Sum, expand

from .linear import least


def exchanged(function, limits, conditions):
    """The sum of a product with one inner sum, as a sum over the inner index with the outer one inside; None if it is
    not over a triangle.

    >>> from bezteach.symbolic import i, j, k, n
    >>> exchanged(Sum(i * j, (j, i, n)), (i, k, n), [k, n - k])
    Sum(i*j, (i, k, j), (j, k, n))
    """
    factors = Mul.make_args(function)
    totals = [factor for factor in factors if isinstance(factor, Sum)]
    if len(totals) != 1:
        return None
    (total,), (k, low, high) = totals, limits
    *inner, (j, first, last) = total.limits
    front = Mul(*[factor for factor in factors if factor is not total])
    if front.has(j) or low.has(j) or high.has(j):
        return None
    body = front * (Sum(total.function, *inner) if inner else total.function)
    below, above = expand(first - k), expand(last - k)
    # k + below <= j <= last, and each such k is at most high: k goes up to j - below.
    if not below.has(k) and not last.has(k) and least(high + below - last, conditions) >= 0:
        return Sum(body, (k, low, expand(j - below)), (j, expand(low + below), last))
    if not above.has(k) and not first.has(k) and least(first - above - low, conditions) >= 0:
        return Sum(body, (k, expand(j - above), high), (j, first, expand(high + above)))
    return None
