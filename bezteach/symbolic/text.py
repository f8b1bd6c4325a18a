"""Formulas as plain text, in the words that the parser reads: C(n, i), t^i, b_(i - 1), sum(B(i, n, t), i, 0, n)."""

from itertools import chain

from sympy import Indexed, Pow, S, expand
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from .operator import step
from .symbols import E


class _AsWrittenPrinter(StrPrinter):
    """SymPy's, but for products that it has not multiplied out: it would do so, or leave brackets out in a divisor."""

    def _print_Mul(self, expr):
        if not _is_as_written(expr):
            return super()._print_Mul(expr)
        below = [factor for factor in expr.args if factor.is_Pow and factor.exp.could_extract_minus_sign()]
        first, *more = [factor for factor in expr.args if factor not in below] or [S.One]
        line = self._print(first) if first.is_Number else self.parenthesize(first, PRECEDENCE["Mul"])
        line += "".join("*" + self.parenthesize(factor, PRECEDENCE["Mul"]) for factor in more)
        divisors = [Pow(one.base, -one.exp, evaluate=False) if one.exp != -1 else one.base for one in below]
        return line + "".join("/" + self.parenthesize(one, PRECEDENCE["Mul"]) for one in divisors)


class _TextPrinter(_AsWrittenPrinter):
    printmethod = "_text"  # and not "_sympystr", by which an Indexed prints itself

    def _as_ordered_terms(self, expr, order=None):
        terms = super()._as_ordered_terms(expr, order)
        first = next((term for term in terms if not term.could_extract_minus_sign()), terms[0])
        return [first, *(term for term in terms if term is not first)]

    def _print_Add(self, expr, order=None):
        return f"g({self._print(expr.coeff(E))})" if _is_step(expr) else super()._print_Add(expr, order)

    def parenthesize(self, item, level, strict=False):
        return self._print(item) if _is_step(item) else super().parenthesize(item, level, strict)

    def _print_Indexed(self, expr):
        index, *others = expr.indices
        if others:
            return str(expr)
        plain = index.is_Symbol or (index.is_Integer and index >= 0)
        return f"{expr.base}_{index}" if plain else f"{expr.base}_({self._print(index)})"

    def _print_binomial(self, expr):
        return f"C({self.stringify(expr.args, ', ')})"

    def _print_Sum(self, expr):
        return self._bound("sum", expr)

    def _print_Integral(self, expr):
        return self._bound("int", expr)

    def _bound(self, name, expr):
        inside = self._print(expr.function)
        for limits in expr.limits:
            inside = f"{name}({inside}, {self.stringify(limits, ', ')})"
        return inside

    def _print_Derivative(self, expr):
        orders = [(symbol,) if count == 1 else (symbol, count) for symbol, count in expr.variable_count]
        return f"diff({self.stringify([expr.expr, *chain(*orders)], ', ')})"

    def _print_Pow(self, expr, rational=False):
        printed = super()._print_Pow(expr, rational)
        if isinstance(expr.base, Indexed):  # b_1^2 is a point on the way: only b[1]^2 is a power
            printed = printed.replace(f"{self._print(expr.base)}**", f"{expr.base}**")
        return printed.replace("**", "^")


def _is_as_written(expr):
    """Whether a product is one that SymPy has not multiplied out."""
    whole = (f.is_Number or (f.is_Pow and all(part.is_Integer for part in f.args)) for f in expr.args[1:])
    return expr.args[0] == 1 or any(whole) or any(f.is_Pow and f.exp == -1 and f.base.is_Mul for f in expr.args)


def _is_step(expr):
    """Whether it is 1 - t + t E, for any t."""
    return expr.is_Add and expr.has(E) and expand(expr - step(expr.coeff(E))) == 0


def text(expr):
    """A formula as a line of plain text, which ``parsing.parse`` reads again.

    >>> from bezteach.symbolic import B, b, i, n, t
    >>> from sympy import Sum
    >>> print(text(Sum(b[i] * B(i, n, t), (i, 0, n))), text(t**2 * b[i - 1]))
    sum(B(i, n, t)*b_i, i, 0, n) t^2*b_(i - 1)
    """
    return _TextPrinter().doprint(expr)


def plain(expr):
    """Anything as SymPy prints it, but in a formula what is not multiplied out as it stands.

    >>> from bezteach.symbolic import i, n
    >>> from sympy import Mul
    >>> kept = Mul(-3, Pow(n / i, -1, evaluate=False), evaluate=False)
    >>> print(plain(kept), kept)
    -3/(n/i) -3*i/n
    """
    return str(expr) if getattr(expr, "is_Matrix", True) else _AsWrittenPrinter().doprint(expr)
