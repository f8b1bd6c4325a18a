"""The Bernstein basis as a SymPy function, the alphabet of the course."""

from sympy import Function, S, binomial


class B(Function):
    r"""The Bernstein basis function B_{i,n}(t), of degree n; i, n and t may be symbols.

    It stays as it is until ``doit()`` or ``rewrite(binomial)`` expands it. It is 0 for i outside 0..n, and not a number
    for n < 0. Source: deck, section 1.1; games, "Bernstein basis".

    >>> from sympy import binomial
    >>> from sympy.abc import i, n, t
    >>> B(1, 3, t).doit()
    3*t*(1 - t)**2
    >>> B(i, n, t).rewrite(binomial)
    t**i*(1 - t)**(-i + n)*binomial(n, i)
    """

    nargs = 3

    def doit(self, deep=True, **hints):
        i, n, t = (arg.doit(deep=deep, **hints) for arg in self.args) if deep else self.args
        if n.is_negative:
            return S.NaN
        if i.is_negative or (n - i).is_negative:
            return S.Zero
        return _definition(i, n, t)

    def _eval_rewrite_as_binomial(self, i, n, t, **hints):
        return _definition(i, n, t)

    def _eval_derivative(self, symbol):
        return self.doit(deep=False).diff(symbol)

    def _eval_evalf(self, precision):
        return self.doit()._eval_evalf(precision)

    def _latex(self, printer, exp=None):
        i, n, t = map(printer._print, self.args)
        around = (r"\left(", r"\right)") if r"\frac" in t else "()"
        text = rf"B_{{{i},{n}}}{around[0]}{t}{around[1]}"
        return text if exp is None else rf"{text}^{{{exp}}}"


def _definition(i, n, t):
    return binomial(n, i) * t**i * (1 - t) ** (n - i)
