"""Sparse polynomials with exact coefficients: what an expression is worth where some letters stay letters.

A letter ("atom") is a control point, the shift operator E or a real variable. Only powers of E may be negative. A
polynomial that turns out to be a number is that number, an ``int`` or a ``Fraction``, never a ``Polynomial``.
"""

from fractions import Fraction

from sympy import Add, IndexedBase, Integer, Mul, Pow, Rational, Symbol

from bezteach.symbolic import E

from ..errors import Unsupported

OPERATOR, VARIABLE, POINT = range(3)
LARGEST_PRODUCT = 20_000
MOST_BITS = 12_000


def atom(kind, name, *place):
    """The letter itself as a value. ``place`` tells apart what has the same name, such as the points of one polygon.

    >>> atom(POINT, "b", 0) + atom(POINT, "b", 1) * 2
    b[0] + 2*b[1]
    """
    return Polynomial({(((kind, name, *place), 1),): 1})


class Polynomial:
    """A dict from monomials, sorted tuples of (atom, exponent), to coefficients that are not 0. Made by arithmetic.

    >>> t = atom(VARIABLE, "t")
    >>> (1 - t) * (1 + t) + t * t
    1
    """

    __slots__ = ("terms", "_hash")

    def __init__(self, terms):
        self.terms, self._hash = terms, None

    def __add__(self, other):
        terms = dict(self.terms)
        for monomial, coefficient in monomials(other):
            terms[monomial] = terms.get(monomial, 0) + coefficient
        return reduced(terms)

    def __mul__(self, other):
        if not isinstance(other, Polynomial):
            return reduced({monomial: coefficient * other for monomial, coefficient in self.terms.items()})
        if len(self.terms) * len(other.terms) > LARGEST_PRODUCT:
            raise Unsupported("a polynomial with too many terms")
        terms = {}
        for first, factor in self.terms.items():
            for second, coefficient in other.terms.items():
                monomial = times(first, second)
                terms[monomial] = terms.get(monomial, 0) + factor * coefficient
        return reduced(terms)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __pow__(self, exponent):
        """For an int >= 0; by halves."""
        if exponent == 0:
            return 1
        half = self ** (exponent // 2)
        return half * half * self if exponent % 2 else half * half

    def __eq__(self, other):
        return isinstance(other, Polynomial) and self.terms == other.terms

    def __hash__(self):
        if self._hash is None:
            self._hash = hash(frozenset(self.terms.items()))
        return self._hash

    def __repr__(self):
        return str(to_sympy(self))

    def inverse(self):
        """1 over it: a power of E has one, whatever else is a polynomial has none that this engine trusts."""
        (monomial, coefficient), *more = self.terms.items()
        if more or any(letter[0] != OPERATOR for letter, _ in monomial):
            raise Unsupported(f"division by {self}, which may vanish")
        return reduced({tuple((letter, -exponent) for letter, exponent in monomial): Fraction(1) / coefficient})


def bits(value):
    """The length of the longest number in a value."""
    parts = value.terms.values() if isinstance(value, Polynomial) else (value,)
    return max(max(part.numerator.bit_length(), part.denominator.bit_length()) for part in parts)


def monomials(value):
    """The (monomial, coefficient) of a value."""
    return value.terms.items() if isinstance(value, Polynomial) else [((), value)]


def reduced(terms):
    """The value that these terms are, without those that are 0."""
    terms = {monomial: coefficient for monomial, coefficient in terms.items() if coefficient}
    if not terms:
        return 0
    return terms[()] if len(terms) == 1 and () in terms else Polynomial(terms)


def times(first, second):
    """The product of two monomials."""
    if not first or not second:
        return first or second
    powers = dict(first)
    for letter, exponent in second:
        powers[letter] = powers.get(letter, 0) + exponent
    return tuple(sorted(pair for pair in powers.items() if pair[1]))


def acted(value):
    """Operators applied to points, E^k b_j = b_{j+k}: done last, since E only acts on a whole product.

    >>> b0, E = atom(POINT, "b", 0), atom(OPERATOR, "E")
    >>> acted((E * E - 1) * b0)
    -b[0] + b[2]
    """
    if not isinstance(value, Polynomial) or not any(letter[0] == OPERATOR for m in value.terms for letter, _ in m):
        return value
    total, kinds = 0, set()
    for monomial, coefficient in value.terms.items():
        shift = sum(exponent for letter, exponent in monomial if letter[0] == OPERATOR)
        points = [pair for pair in monomial if pair[0][0] == POINT]
        kinds.add(POINT if points else OPERATOR)
        if shift and points:
            ((letter, exponent), *more) = points
            if more or exponent != 1 or len(letter) != 3:
                raise Unsupported("E acts on one point with one index, not on a product")
            others = tuple(pair for pair in monomial if pair[0][0] == VARIABLE)
            monomial = times(others, (((POINT, letter[1], letter[2] + shift), 1),))
        total = total + reduced({monomial: coefficient})
    if len(kinds) > 1:
        raise Unsupported("an operator and a point cannot be added")
    return total


def to_sympy(value):
    """A value as a SymPy expression."""
    return Add(*[Mul(_number(c), *[Pow(_name(a), e) for a, e in monomial]) for monomial, c in monomials(value)])


def _number(value):
    return Integer(value) if isinstance(value, int) else Rational(value.numerator, value.denominator)


def _name(letter):
    kind, name, *place = letter
    if kind == POINT:
        return IndexedBase(name)[tuple(place)]
    return E if kind == OPERATOR else Symbol(name, real=True)
