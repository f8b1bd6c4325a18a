"""SymPy nodes, each built after its bounds are checked, so that no text is dear to read and no result dear to use."""

from typing import Any, NamedTuple

from sympy import (
    Add,
    Eq,
    Expr,
    Ge,
    Gt,
    I,
    Indexed,
    Integer,
    Le,
    Lt,
    Mul,
    Pow,
    Rational,
    Symbol,
    binomial,
    factorial,
    nan,
    oo,
    zoo,
)

from ..symbolic import B, E
from .errors import InvalidAnswer
from .names import POINTS, WHOLE
from .undefined import kept

MAX_DIGITS = 40
MAX_EXPONENT = 200
MAX_FRACTION = 12
MAX_ROOT_LEVELS = 3
MAX_FACTORIAL = 400
MAX_RESULT_DIGITS = 4000
MAX_ROOT_DIGITS = 12
MAX_DEGREE = 400

_RELATIONS = {"=": Eq, "<": Lt, "<=": Le, ">": Gt, ">=": Ge}
_SYMBOLIC_EXPONENT = 8  # what a power with letters in its exponent counts as, when powers of powers are bounded


class Item(NamedTuple):
    """A value, which is a SymPy expression or a tuple, and the character where it begins."""

    value: Any
    position: int


def number(text, position):
    """The exact number that a row of digits is: 0.25 is 1/4."""
    whole, _, fraction = text.partition(".")
    if len(whole + fraction) > MAX_DIGITS:
        raise InvalidAnswer(
            f"a number of more than {MAX_DIGITS} digits: write it shorter, as a power or a product", position
        )
    return Rational(int(whole + fraction), 10 ** len(fraction))


def expression(value, position):
    """The value, unless it is a point or a list."""
    if isinstance(value, Expr):
        return value
    raise InvalidAnswer("a point or a list stands here: calculate with its coordinates, one by one", position)


def calculate(sign, left, right, position):
    """left + right, left - right, left * right or left / right; the position is the sign's."""
    if sign == "/" and right == 0:
        raise InvalidAnswer("this divides by zero: change the denominator", position)
    if sign == "-":
        right = negative(right, position)
    if sign == "/":
        right = _built(position, Pow, right, Integer(-1))
    return _built(position, Add if sign in "+-" else Mul, left, right)


def negative(value, position):
    """-value; a number in front takes the sign, so that -3/(n/i) is not shown as -1*3/(n/i)."""
    number, rest = value.as_coeff_Mul() if value.is_Mul else (Integer(1), value)
    return _built(position, Mul, -number, rest)


def power(base, exponent, position):
    """base ** exponent; the position is the exponent's."""
    short_formula(exponent, "an exponent", MAX_EXPONENT, position, letters=None)
    _refuse_dear_power(base, exponent, position)
    return bounded(_built(position, Pow, base, exponent), position)


def _refuse_dear_power(base, exponent, position):
    """SymPy multiplies powers of numbers out, factors the numbers under a root and asks for the sign of the rest there.

    To know that sign it evaluates integrals and sums numerically, so none may stand under a root.
    """
    bits = max((max(abs(x.p), x.q).bit_length() for x in base.atoms(Rational)), default=0)
    fraction, most = exponent.is_Rational and not exponent.is_Integer, MAX_DIGITS
    if exponent.is_Integer:
        bits, most = bits * max(1, abs(exponent.p)) if bits > 1 else 0, MAX_RESULT_DIGITS
    if fraction:
        most = MAX_ROOT_DIGITS
        if max(abs(exponent.p), exponent.q) > MAX_FRACTION:
            raise InvalidAnswer(
                f"an exponent that is a fraction has numbers up to {MAX_FRACTION}: take others", position
            )
        if levels(base, _is_root) >= MAX_ROOT_LEVELS:
            raise InvalidAnswer(f"more than {MAX_ROOT_LEVELS} roots stand inside one another: write fewer", position)
    if not exponent.is_integer and not all(map(_is_plain, _nodes(base))):
        raise InvalidAnswer("only numbers, letters and their powers are read under a root: leave out others", position)
    if bits > _bits(most):
        raise InvalidAnswer(f"the numbers of this power have more than {most} digits: take smaller ones", position)
    if base.is_Rational and base < 0 and not exponent.is_integer:
        raise InvalidAnswer("a root of a negative number is not a real number: change the sign", position)


def factorial_of(value, position):
    whole_formula(value, "the number before !", MAX_FACTORIAL, position, least=0)
    return _built(position, factorial, value)


def binomial_of(upper, lower):
    """The binomial coefficient of two items."""
    whole_formula(upper.value, "the upper number of a binomial coefficient", MAX_FACTORIAL, upper.position, least=0)
    whole_formula(lower.value, "the lower number of a binomial coefficient", MAX_FACTORIAL, lower.position)
    return _built(upper.position, binomial, upper.value, lower.value)


def point(letter, index, position):
    """The control point b[index], or a coordinate such as x[index]."""
    return POINTS[letter][whole_formula(expression(index, position), "an index", MAX_FACTORIAL, position)]


def relation(sign, left, right, position):
    """The equation or inequality, as it stands: nothing decides here whether it holds."""
    if not (isinstance(left, Expr) and isinstance(right, Expr)):
        raise InvalidAnswer("points are not compared here: write one equation for each coordinate", position)
    return _RELATIONS[sign](left, right, evaluate=False)


def whole_formula(value, what, most, position, least=None):
    """The value, which must be a whole number or a short formula in the letters of whole numbers."""
    short_formula(value, what, most, position, letters=WHOLE)
    if value.is_Rational and not value.is_Integer:
        raise InvalidAnswer(f"{what} is a whole number, not {value}", position)
    if least is not None and value.is_Integer and value < least:
        raise InvalidAnswer(f"{what} is at least {least}, not {value}", position)
    return value


def short_formula(value, what, most, position, letters):
    """Refuse all but numbers up to ``most`` and polynomials of degree 2 at most with such numbers in the letters."""
    whole = "whole " * (letters is not None)
    for number in value.atoms(Rational):
        if max(abs(number.p), number.q) > most:
            raise InvalidAnswer(f"{what} is too large: numbers up to {most} are read here", position)
    wrong = value.free_symbols - letters if letters is not None else value.free_symbols & {E}
    if wrong:
        raise InvalidAnswer(
            f"{what} is a {whole}number: {min(map(str, wrong))} is none, write one such as n - 1", position
        )
    plain = not value.has(Indexed) and all(
        _is_plain(node) and (not isinstance(node, Pow) or node.exp in (-1, 2)) for node in _nodes(value)
    )
    if not plain or _degree(value) > 2:
        raise InvalidAnswer(f"{what} is a number or a short formula: write one such as n - 1", position)


def bounded(value, position):
    """The value, unless its powers of powers, or products of powers, add up to too high a degree."""
    if _degree(value) > MAX_DEGREE:
        raise InvalidAnswer(f"the powers multiply up to a degree above {MAX_DEGREE}: take smaller exponents", position)
    return value


def _degree(value):
    """A bound for the degree that a value has when it is expanded."""
    if value.is_Rational:
        return 0
    if isinstance(value, Pow):
        exponent = value.exp
        times = -(-abs(exponent.p) // exponent.q) if exponent.is_Rational else _SYMBOLIC_EXPONENT
        return times * max(_degree(value.base), int(not exponent.is_Integer))
    degrees = [_degree(arg) for arg in value.args if isinstance(arg, Expr)]
    if isinstance(value, Mul):
        return sum(degrees)
    if isinstance(value, B):
        degree = value.args[1]
        return max(1, degrees[2]) * (max(1, degree.p) if degree.is_Integer else _SYMBOLIC_EXPONENT)
    return max([*degrees, int(not isinstance(value, Add))])


def levels(value, test):
    """How many nodes that pass the test stand inside one another."""
    return max((levels(arg, test) for arg in value.args), default=0) + test(value)


def _is_root(value):
    return isinstance(value, Pow) and value.exp.is_Rational and not value.exp.is_Integer


def _is_plain(node):
    return isinstance(node, Symbol | Rational | Indexed | Add | Mul) or isinstance(node, Pow) and node.exp.is_Rational


def _nodes(value):
    yield value
    if not isinstance(value, Indexed):
        for arg in value.args:
            yield from _nodes(arg)


def _built(position, build, *args):
    """The node, as SymPy evaluates it if nothing gets lost that may have no value, and if its numbers are short."""
    try:
        as_written = build(*args, evaluate=False)
        result = build(*args)
    except (ArithmeticError, TypeError, ValueError, NotImplementedError) as error:
        raise InvalidAnswer("this cannot be calculated: write it in a simpler way", position) from error
    if result.has(zoo, nan, oo):
        raise InvalidAnswer("this divides by zero: 0 has no negative power", position)
    if result.has(I):
        raise InvalidAnswer("a root of a negative number is not a real number: change the sign", position)
    for term in Add.make_args(result):
        coefficient = term.as_coeff_Mul()[0]
        if coefficient.is_Rational and max(abs(coefficient.p), coefficient.q).bit_length() > _bits(MAX_RESULT_DIGITS):
            raise InvalidAnswer(f"this number has more than {MAX_RESULT_DIGITS} digits: take a smaller one", position)
    return kept(result, as_written)


def _bits(digits):
    return digits * 10 // 3
