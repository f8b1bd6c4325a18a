"""LaTeX as the course writes it: 1 - t before t - 1, and operators in E between the factors and the points."""

import re

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
        return self._signed(_from_the_last_point(terms) or sorted(terms, key=lambda term: -_complements(term)))

    def _print_operator_sum(self, expr):
        scalars, operators = _parted(expr.args, lambda term: not term.has(E))
        operators.sort(key=lambda term: (not term.as_independent(E)[0].is_Add, -_power_of_e(term)))
        if not scalars:
            return self._signed(operators)
        scalar = Add(*scalars)
        polynomial = all(_power_of_e(term) for term in operators) and not operators[0].could_extract_minus_sign()
        last = polynomial or (scalar.could_extract_minus_sign() and not scalar.is_Add)
        return self._signed([*operators, scalar] if last else [scalar, *operators])

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
        signs, others = _parted(others, lambda factor: factor.as_base_exp()[0] == -1 and not factor.is_Integer)
        if (binomials or signs) and len(expr.args) > 1:
            numbers, others = _parted(others, lambda factor: factor.is_Rational)
            if Mul(*numbers).is_negative:
                return f"- {self._print(-expr)}"
            rest = [Mul(*others)] if others else []
            return " ".join(map(self._factor, [*numbers, *signs, *binomials, *rest]))
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

    def _print_Derivative(self, expr):
        if len(expr.variable_count) > 1:
            return super()._print_Derivative(expr)
        ((symbol, order),) = expr.variable_count  # the letters beside it are fixed: no partial derivative
        power = "" if order == 1 else f"^{{{self._print(order)}}}"
        of = self._factor(expr.expr)
        return rf"\frac{{d{power}}}{{d {self._print(symbol)}{power}}} {of}"

    def _print_Pow(self, expr):
        if expr.base == E:
            return f"E^{{{self._print(expr.exp)}}}"
        if isinstance(expr.base, Add) and expr.base.has(E):
            return f"{self._bracketed(expr.base)}^{{{self._print(expr.exp)}}}"
        if expr.exp.is_negative and expr.base.is_Mul and fraction(expr)[1] == 1:  # SymPy prints (n/n)^(-2) forever
            return rf"\left({self._print(expr.base)}\right)^{{{self._print(expr.exp)}}}"
        return super()._print_Pow(expr)

    def _factor(self, expr):
        return rf"\left({self._print(expr)}\right)" if isinstance(expr, Add) else self._print(expr)

    def _bracketed(self, factor):
        return rf"\left[{self._print(factor)}\right]" if isinstance(factor, Add) else self._print(factor)


def _power_of_e(term):
    """k of a number times E^k, else 0."""
    coefficient, power = term.as_coeff_Mul()
    base, exponent = power.as_base_exp()
    return exponent if base == E and exponent.is_Integer else 0


def _complements(term):
    """How many factors of a term are 1 less something, as in (1 - t)^2 b_0 + 2 t (1 - t) b_1 + t^2 b_2."""
    if term.could_extract_minus_sign():
        return 0
    powers = [factor.as_base_exp() for factor in Mul.make_args(term)]
    heads = [(base.as_coeff_Add(), exponent) for base, exponent in powers if base.is_Add and exponent.is_Integer]
    return sum(int(exponent) for (one, rest), exponent in heads if one == 1 and rest.could_extract_minus_sign())


def _from_the_last_point(terms):
    """Differences of points from the last one to the first, as in b_2 - 2 b_1 + b_0; None for other terms."""
    points = [term.atoms(Indexed) for term in terms]
    signs = [term.could_extract_minus_sign() for term in terms]
    if not any(signs) or any(map(_complements, terms)) or any(len(found) != 1 for found in points):
        return None
    places = [found.pop().indices[0] for found in points]
    gaps = [place - places[0] for place in places]
    if not all(gap.is_Integer for gap in gaps):
        return None
    return [terms[at] for at in sorted(range(len(terms)), key=lambda at: -gaps[at])]


def _parted(items, test):
    """The items that pass the test, and the others, each in their order."""
    return [item for item in items if test(item)], [item for item in items if not test(item)]


_SPECIAL = {"\\": r"\backslash ", "^": r"\wedge "} | {mark: "\\" + mark for mark in "_{}%$#&"}


_POWER = r"\^[^\W_]+"  # with an exponent of letters and digits


def in_words(text):
    r"""Words as LaTeX sets them inside a formula; a mark with a meaning of its own stands outside the words, where
    MathJax and KaTeX know its name, and an exponent where it belongs.

    >>> print(in_words("at b_0"), in_words("p^e"))
    \text{at b}\_\text{0} \text{p}{}^{\text{e}}
    """
    runs = re.split(rf"({_POWER}|[\\^_{{}}%$#&])", text)
    return "".join(map(_run, filter(None, runs)))


def _run(run):
    if re.fullmatch(_POWER, run):
        return rf"{{}}^{{\text{{{run[1:]}}}}}"
    return _SPECIAL.get(run) or rf"\text{{{run}}}"


def latex(expr):
    r"""LaTeX of a SymPy expression, as the course writes it.

    >>> from sympy.abc import t, n
    >>> print(latex(1 - t), latex(((1 - t) + t * E) ** n))
    1 - t \left[\left(1 - t\right) + t E\right]^{n}
    """
    return _CoursePrinter({"fold_short_frac": False}).doprint(expr)
