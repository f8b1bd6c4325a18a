"""Gosper's algorithm for a rational multiple of a hypergeometric term: is it a difference G(k + 1) - G(k)?

This is a search: what it finds is proved elsewhere. It looks at linear factors only, so it may miss something.
"""

from sympy import Dummy, Mul, Poly, S, cancel, expand, fraction, linsolve

from ..terms.failure import Failure
from ..terms.size import cancelled

HIGHEST = 8


def antidifference(amount, ratio, k, budget):
    """The g with g(k + 1) f(k + 1) - g(k) f(k) = amount(k) f(k), where f(k + 1) = ratio(k) f(k); ``Failure`` if none.

    >>> from bezteach.proof.budget import Budget
    >>> from sympy.abc import k
    >>> antidifference(k, 1, k, Budget(5)), antidifference(k, k + 1, k, Budget(5))
    (k*(k - 1)/2, 1)
    """
    budget.spend()
    above, below = fraction(cancelled(amount))
    ratio = cancelled(ratio * below / below.subs(k, k + 1))
    budget.spend()
    a, b, c = _normal_form(*fraction(ratio), k)
    budget.spend()
    x = _polynomial_solution(a, b.subs(k, k - 1), above * c, k)
    budget.spend()
    return cancelled(b.subs(k, k - 1) * x / (c * below)).factor()


def _normal_form(p, q, k):
    """a, b, c with p(k)/q(k) = a(k)/b(k) c(k+1)/c(k), and no factor of a(k) is one of b(k + h) for h = 0, 1, ..."""
    c = S.One
    for h in sorted({h for root in _roots(q, k) for other in _roots(p, k) if _is_shift(h := root - other)}):
        (p, q), before = map(lambda e: Poly(e, k), (p, q)), c
        shared = p.gcd(q.compose(Poly(k + h, k)))
        p, q = p.exquo(shared).as_expr(), q.exquo(shared.compose(Poly(k - h, k))).as_expr()
        c = before * Mul(*[shared.as_expr().subs(k, k - step) for step in range(1, int(h) + 1)])
    return p, q, c


def _roots(expr, k):
    """The roots of the linear factors."""
    _, factors = Poly(expr, k).factor_list()
    return {cancel(-part.nth(0) / part.nth(1)) for part, _ in factors if part.degree() == 1}


def _is_shift(value):
    return value.is_Integer and value >= 0


def _polynomial_solution(a, b, c, k):
    """The polynomial x with a(k) x(k + 1) - b(k) x(k) = c(k)."""
    a, b, c = (Poly(expand(part), k) for part in (a, b, c))
    first, second, highest = a.degree(), b.degree(), c.degree()
    if first != second or cancel(a.LC() - b.LC()) != 0:
        degrees = [highest - max(first, second)]
    else:
        degrees = [highest - first + 1]
        degrees += [cancel((b.nth(first - 1) - a.nth(first - 1)) / a.LC())] if first else [S.Zero]
    order = max((int(d) for d in map(S, degrees) if d.is_Integer and 0 <= d <= HIGHEST), default=None)
    if order is None:
        raise Failure("no degree for a solution")
    letters = [Dummy(f"c{place}") for place in range(order + 1)]
    x = sum(letter * k**place for place, letter in enumerate(letters))
    equation = Poly(expand(a.as_expr() * x.subs(k, k + 1) - b.as_expr() * x - c.as_expr()), k)
    solutions = linsolve(equation.coeffs(), *letters)
    if not solutions:
        raise Failure("it is no difference")
    (solution,) = solutions
    return sum(S(value).xreplace(dict.fromkeys(letters, S.Zero)) * k**place for place, value in enumerate(solution))
