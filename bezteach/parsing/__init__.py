r"""Text to SymPy, safe and bounded: what a student types is read, never executed.

>>> parse("2t(1 - t) + 1/4"), parse("sum(B(i, n, t), i, 0, n) = 1")
(2*t*(1 - t) + 1/4, Eq(Sum(B(i, n, t), (i, 0, n)), 1))
>>> parse("t(1-t")
Traceback (most recent call last):
bezteach.parsing.errors.InvalidAnswer: character 2: the bracket "(" is not closed: write ")"

The language:

numbers     12, 0.25 (exactly 1/4), 1/3; no 2e3. Signs + - * / ^ (or **), and ! after a number, letter or bracket.
brackets    ( ) [ ] { } group. A comma in ( ) or [ ] makes a point or list, a Python tuple: (1/3, 1), [(0, 0), (1, 2)].
letters     i j k l m n p q r are whole numbers from 0 on, a c h s t u v w x y z real numbers, E the shift operator.
            Of the letter of a sum that may begin below 0 no sign is assumed, wherever it stands (``without_sign``).
products    without a sign where nobody can take it for something else: 2t, 2(1-t), n!(1-t), t E, tE, n(n-1), nB(i,n,t).
            An error instead of a guess: t2, 2 3, nt (write n*t), 1/2t, p(t), x(1-t).
points      b[0], b[i+1], b_0, b_{i+1}, b0, b₀; likewise a, c, x, y, z with [ ] or _ (coefficients, coordinates).
functions   B(i, n, t), binomial(n, i) or C(n, i), factorial(n), sqrt(2), abs(t), g(t) = (1 - t) + t E, Fraction(1, 3),
            sum(f, i, 0, n), integral(f, t, 0, 1), diff(f, t), diff(f, t, 2); the last three also as SymPy prints them.
statements  one of = (or ==) < <= > >= between two formulas gives the relation as it stands, unevaluated. A chain such
            as 0 <= t <= 1 is an error that asks for two statements; only ``parse_given`` reads chains.
lists       commas at the top give a tuple of formulas, points or statements.
LaTeX       \frac \tfrac \binom \sqrt \cdot \times \left \right \le \ge \equiv \vec{b} and spaces; B_{i,n}(t), B_i^n(t),
            C_n^i; \sum_{i=0}^n takes the product that follows it, \int_0^1 all up to dt, \frac{d}{dt} (d/dt) as \sum.
characters  full-width and mathematical forms of Latin letters, digits and signs, − × · ÷ ≤ ≥ √ ∑ ∫, ², ⁿ⁻¹ and b₁ are
            read; letters that only look like Latin ones and invisible characters are errors that name them.

The result is what SymPy makes of the formula written in Python, so 2*(1 - t) is 2 - 2*t; but what may have no value is
not cancelled, so t/t and C(n-3, 0) stay as they are. So do sums, integrals, derivatives and absolute values. Bounds:
2000 characters, 400 parts, 40 levels, 40 digits, exponents to 200, 400!, 64 items in a list; exponents, indices, limits
and what stands before ! are numbers or polynomials of degree 2 in letters; powers multiply up to degree 400, numbers to
4000 digits; three sums inside one another; 16 roots, three inside one another, of letters, points and numbers to 12
digits.
"""

from functools import partial

from sympy import I, nan, oo, zoo

from .characters import tokens_of
from .errors import BelowZero, InvalidAnswer
from .given import ranges
from .grammar import Grammar

__all__ = ["InvalidAnswer", "parse", "parse_given", "without_sign"]


def parse(text, integers=frozenset()):
    """The SymPy expression or relation that a text is, or the tuple of them; the language is described above.

    ``InvalidAnswer``, a ``ValueError``, says what is wrong and at which character, counted from 1 (``position``).
    ``integers`` names letters of whole numbers of which no sign is assumed either, for texts that belong together.

    >>> parse("C(n,i) t^i (1-t)^(n-i)"), parse(r"\\frac{1}{3}(E - 1) b_0")
    (t**i*(1 - t)**(-i + n)*binomial(n, i), (E/3 - 1/3)*b[0])
    >>> parse("(0, 0), (1/3, 0.5)")
    ((0, 0), (1/3, 1/2))
    >>> parse("9^9^9^9")
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: character 5: an exponent is too large: numbers up to 200 are read here
    """
    return _within_bounds(partial(_read, integers=integers), text)[0]


def without_sign(text):
    """The names of the letters of a text of which no sign is assumed: SymPy would go by it in sums from below 0 on.

    >>> sorted(without_sign("sum(0^(k+1), k, -1, n) = sum(1, j, 0, n)"))
    ['k']
    """
    return _within_bounds(_read, text)[1]


def parse_given(text, integers=frozenset()):
    """The ranges of letters, as ``proof.prove`` takes them: a pair for a whole number, an Interval for a real one.

    Ranges stand apart by commas or "and". A limit is a number or, for a whole number, a short formula in others; limits
    of one letter may be given in several places. A letter of a whole number is never below 0. Of two letters, n >= i
    gives the range of the left one. ``integers`` is what ``parse`` was given.

    >>> parse_given("n >= 1, 0 <= i <= n, 0 < t <= 1")
    {n: (1, oo), i: (0, n), t: Interval.Lopen(0, 1)}
    >>> parse_given("n > 5 and n <= 3")
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: character 16: no n is in this range: write the lower limit first
    """
    return _within_bounds(partial(ranges, integers=integers), text)


def _read(tokens, integers=frozenset()):
    """What the tokens say, and the letters without a sign."""
    try:
        values = Grammar(tokens, integers).statements()
    except BelowZero as found:
        return _read(tokens, integers | {found.name})
    if any(value.has(nan, zoo, oo, I) for value in _flat(values)):
        raise InvalidAnswer("this is not a real number: look for a division by zero or a root of a negative one", 1)
    return values, integers


def _flat(values):
    if not isinstance(values, tuple):
        return [values]
    return [value for part in values for value in _flat(part)]


def _within_bounds(read, text):
    try:
        return read(tokens_of(text))
    except (ArithmeticError, MemoryError, RecursionError) as error:
        raise InvalidAnswer("this is too large to be read: write it shorter") from error
