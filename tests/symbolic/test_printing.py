"""What is left as it is written, because it may have no value, is printed so that it is read again as the same."""

import pytest
from sympy import Mul, Pow

from bezteach.bench import judge
from bezteach.parsing import parse
from bezteach.symbolic import latex, n, plain, t, text

ONE = Mul(t, 1 / t, evaluate=False)


@pytest.mark.parametrize(
    ("expr", "line"),
    [
        (Mul(-1, 2, Pow(ONE, -1, evaluate=False), evaluate=False), "-1*2/(t/t)"),
        (Mul(2, Pow(ONE, -1, evaluate=False), evaluate=False), "2/(t/t)"),
        (Mul(t, -2, Pow(ONE, -2, evaluate=False), evaluate=False), "t*(-2)/(t/t)^2"),
        (Mul(1, t - 1, Pow(n, -1), evaluate=False), "1*(t - 1)/n"),
    ],
)
def test_a_divisor_keeps_its_brackets(expr, line):
    assert text(expr) == line
    values = {t: 3, n: 5}
    assert parse(line).subs(values) == expr.subs(values)


@pytest.mark.parametrize("line", ["1 - 2/(t/t)", "n/(t/t)", "2/(3/(t/t))", "(n/n)^(-2)", "1/(2*(t/t))", "(-1)^n/(t/t)"])
def test_a_line_comes_back_as_it_was(line):
    assert text(parse(line)) == line


def test_a_quotient_to_a_negative_power_ends():
    assert latex(parse("(n/n)^(-2)")) == r"\left(\frac{n}{n}\right)^{-2}"
    assert latex(parse("2 (n/n)^(-1)")) != latex(parse("2 (n/n)^(-2)"))


def test_a_statement_and_a_line_are_shown_with_what_may_have_no_value():
    """3/(n/i) is 3 i/n, but not at i = 0."""
    found = judge("t - 3/(n/i) = t - 3*i/n", "n >= 1")
    assert repr(found.statement) == "t - 3/(n/i) = -3*i/n + t" and found.status == "REFUTED"
    assert plain(parse("3/(n/i)")) == "3/(n/i)" and str(parse("3/(n/i)").doit()) == "3*i/n"
