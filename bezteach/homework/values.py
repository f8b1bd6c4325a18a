"""Numbers, points, lists of points and matrices: whether two are the same, and where they differ."""

from fractions import Fraction

from sympy import Basic, Rational, sympify

from bezteach.numeric.exact import is_zero
from bezteach.parsing import InvalidAnswer

from .reading import read
from .verdict import CORRECT, OPEN, PARTLY, WRONG, Verdict

NEAR = 1e-12
ROUNDED = Fraction(1, 200)
ADVICE = "Right. Write fractions, such as 1/3, and the answer is exact."
ADVICE_ON_ROOTS = 'Right. Write roots in quotes, such as "sqrt(2)", and the answer is exact.'
SHAPES = {"number": 0, "point": 1, "numbers": 1, "points": 2, "matrix": 2}
EXAMPLES = {
    "number": "a number like 2, -5/3 or 0.25",
    "point": "a point like (1/2, 3)",
    "numbers": "a list of numbers like (1/2, 3, 0)",
    "points": "a list of points like [(0, 0), (1/2, 1)]",
    "matrix": "a matrix, a list of rows like [[1, 0], [1/2, 1]],",
}


def value_of(kind, answer):
    """An answer of this kind (a name of ``SHAPES``); ``InvalidAnswer`` if it has another shape, or letters in it.

    >>> value_of("point", "(1/3, 1)")
    (Fraction(1, 3), Fraction(1, 1))
    >>> value_of("points", [(0, 0), 1])
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: item 2 is a number: a list of points like [(0, 0), (1/2, 1)] is asked for
    """
    value = read(answer)
    for leaf, place in _leaves(value):
        if isinstance(leaf, Basic) and not (leaf.is_number and leaf.is_real):
            raise InvalidAnswer(f"{_at(place)}{leaf} is no number")
    _check_shape(kind, value)
    return value


def _check_shape(kind, value):
    wanted, depth, asked = SHAPES[kind], _depth(value), f"{EXAMPLES[kind]} is asked for"
    if value == ():
        raise InvalidAnswer(f"this is an empty list: {asked}")
    if (depth == 0) != (wanted == 0) or depth > wanted:
        raise InvalidAnswer(f"this is {_named(value)}: {asked}")
    for i, row in enumerate(value if wanted == 2 else (), 1):
        if _depth(row) != 1 or not row:
            raise InvalidAnswer(f"item {i} is {_named(row)}: {asked}")
        if len(row) != len(value[0]):
            raise InvalidAnswer(f"item {i} has {len(row)} numbers, and item 1 has {len(value[0])}: {asked}")


def _depth(value):
    return 1 + max(map(_depth, value), default=0) if isinstance(value, tuple) else 0


def _named(value):
    kinds = ("a number", "a list of numbers", "a list of lists")
    return kinds[min(_depth(value), 2)] if value != () else "an empty list"


def _leaves(value, place=()):
    if not isinstance(value, tuple):
        return [(value, place)]
    return [found for i, one in enumerate(value, 1) for found in _leaves(one, (*place, i))]


def _at(place):
    return f"at place {', '.join(map(str, place))}: " if place else ""


def same(given, right):
    """True, False, or None where it cannot be decided; a float counts within 1e-12 of the right number."""
    if isinstance(given, tuple) != isinstance(right, tuple):
        return False
    if not isinstance(given, tuple):
        return _same_number(given, right)
    if len(given) != len(right):
        return False
    found = [same(one, other) for one, other in zip(given, right, strict=True)]
    return False if False in found else None if None in found else True


def _same_number(given, right):
    if isinstance(given, float):
        exact = Fraction(str(right.evalf(25))) if isinstance(right, Basic) else right
        return abs(Fraction(given) - exact) <= NEAR * max(1, abs(exact))
    if isinstance(given, Basic) or isinstance(right, Basic):
        return is_zero(_sympy(given) - _sympy(right))
    return given == right


def _sympy(value):
    return Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else sympify(value)


def compared(given, right, mistakes):
    """The ``Verdict`` on a value against the right one; ``mistakes`` are (value, feedback)."""
    found = same(given, right)
    if found:
        return Verdict(CORRECT, _praise(given, right))
    for mistake, feedback in mistakes:
        if same(given, mistake):
            return Verdict(WRONG, feedback)
    if found is None:
        return Verdict(OPEN, "Whether this number is the right one could not be decided: write it in a simpler form.")
    if isinstance(given, tuple) and _sizes(given) != _sizes(right):
        return Verdict(WRONG, f"The answer is {_size_words(right)}; yours is {_size_words(given)}.")
    if _is_rounded(given, right):
        return Verdict(WRONG, "This is rounded, and so not the number itself: write a fraction, such as 1/3.")
    return _by_parts(given, right)


def _is_rounded(given, right):
    """Whether decimal numbers stand for what is near to them, and fractions for themselves."""
    if isinstance(given, tuple):
        return all(map(_is_rounded, given, right))
    if isinstance(given, Basic) or isinstance(right, Basic) or same(given, right):
        return bool(same(given, right))
    return abs(Fraction(given) - right) <= ROUNDED * max(1, abs(right)) and is_decimal(Fraction(given))


def is_decimal(fraction):
    """Whether a fraction can be written with a point: floats always can.

    >>> is_decimal(Fraction(333, 1000)), is_decimal(Fraction(0.3)), is_decimal(Fraction(1, 3))
    (True, True, False)
    """
    return 10 ** fraction.denominator.bit_length() % fraction.denominator == 0


def _praise(given, right):
    if not any(isinstance(leaf, float) for leaf, _ in _leaves(given)):
        return "Right."
    return ADVICE_ON_ROOTS if any(isinstance(leaf, Basic) for leaf, _ in _leaves(right)) else ADVICE


def _sizes(value):
    return (len(value), *_sizes(value[0])) if isinstance(value, tuple) else ()


def _size_words(value):
    count, *rest = _sizes(value)
    return f"{count} numbers" if not rest else f"{count} rows of {rest[0]} numbers"


def _by_parts(given, right):
    if not isinstance(given, tuple) or len(given) < 2:
        return Verdict(WRONG, "Not this. Do one step after the other, and look at each.")
    wrong = [i for i, (one, other) in enumerate(zip(given, right, strict=True), 1) if same(one, other) is not True]
    part = "number" if len(_sizes(given)) == 1 else "row"
    if len(wrong) == len(given):
        return Verdict(WRONG, f"None of the {len(given)} {part}s is right.")
    return Verdict(
        PARTLY, f"{len(given) - len(wrong)} of {len(given)} {part}s are right: look at number {wrong[0]} again."
    )
