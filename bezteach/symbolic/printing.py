"""LaTeX as the course writes it: 1 - t before t - 1, and operators in E between the factors and the points."""

from sympy import Add, Indexed, Mul, binomial, fraction
from sympy.printing.latex import LatexPrinter

from .symbols import E


class _CoursePrinter(LatexPrinter):
    def _print_Add(self, expr, order=None):
        if expr.has(E):
            return self._print_operator_sum(expr)
        terms = sorted(self._as_ordered_terms(expr, order=order), key=lambda term: not isinstance(term, Add))
        if terms[0].could_extract_minus_sign():
            one_letter = len(expr.free_symbols) == 1
            terms = terms[::-1] if one_letter else sorted(terms, key=lambda term: term.could_extract_minus_sign())
        return self._signed(terms)

    def _print_operator_sum(self, expr):
        scalars, operators = _parted(expr.args, lambda term: not term.has(E))
        scalar = Add(*scalars)
        if scalar.is_number and scalar < 0:
            return self._signed([*operators, scalar])
        operators.sort(key=lambda term: not term.as_independent(E)[0].is_Add)
        text = [self._factor(scalar)] if scalars else []
        return " + ".join(text + [self._print(term) for term in operators])

    def _signed(self, terms):
        text = ""
        for term in terms:
            minus = term.could_extract_minus_sign() and not isinstance(term, Add)
            body = self._factor(-term if minus else term)
            joint = " - " if minus else " + "
            text += joint + body if text else ("- " if minus else "") + body
        return text

    def _print_Mul(self, expr):
        if not isinstance(expr, Mul):
            return super()._print_Mul(expr)
        numerator, denominator = fraction(expr)
        if denominator.has(Indexed, binomial):
            return rf"\frac{{{self._print(numerator)}}}{{{self._print(denominator)}}}"
        binomials, others = _parted(expr.args, lambda factor: isinstance(factor, binomial))
        if binomials and others:
            return " ".join(map(self._factor, [*binomials, Mul(*others)]))
        if not expr.has(E, Indexed):
            return super()._print_Mul(expr)
        points, rest = _parted(expr.args, lambda factor: factor.has(Indexed))
        operators, scalars = _parted(rest, lambda factor: factor.has(E))
        scalar = Mul(*scalars)
        text = [] if scalar == 1 else ["-"] if scalar == -1 else [self._factor(scalar)]
        text += [self._bracketed(factor) for factor in sorted(operators, key=lambda f: f.as_base_exp()[0] == E)]
        return " ".join(text + [self._factor(factor) for factor in points])

    def _print_Sum(self, expr):
        signs = [
            rf"\sum_{{{self._print(k)}={self._print(low)}}}^{{{self._print(high)}}}"
            for k, low, high in expr.limits[::-1]
        ]
        return " ".join([*signs, self._factor(expr.function)])

    def _print_Pow(self, expr):
        if isinstance(expr.base, Add) and expr.base.has(E):
            return f"{self._bracketed(expr.base)}^{{{self._print(expr.exp)}}}"
        return super()._print_Pow(expr)

    def _factor(self, expr):
        return rf"\left({self._print(expr)}\right)" if isinstance(expr, Add) else self._print(expr)

    def _bracketed(self, factor):
        return rf"\left[{self._print(factor)}\right]" if isinstance(factor, Add) else self._print(factor)


def _parted(items, test):
    """The items that pass the test, and the others, each in their order."""
    return [item for item in items if test(item)], [item for item in items if not test(item)]


def latex(expr):
    r"""LaTeX of a SymPy expression, as the course writes it.

    >>> from sympy.abc import t, n
    >>> print(latex(1 - t), latex(((1 - t) + t * E) ** n))
    1 - t \left[\left(1 - t\right) + t E\right]^{n}
    """
    return _CoursePrinter({"fold_short_frac": False}).doprint(expr)
