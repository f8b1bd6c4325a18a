"""Homework on lesson 03: one degree down, parts, products, slopes and neighbours of the Bernstein functions."""

from fractions import Fraction as F
from math import comb

from sympy import Eq, Ge, Integral, Interval, Poly, Rational, binomial, diff, factor, integrate, oo

from bezteach import numeric
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, i, j, k, n, t

from ..formulas import is_factored
from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value

BOOK = {
    "at": EXAMPLES["deck/split"].given["t"],
    "down": 2,
    "cut": EXAMPLES["deck/segment"].given["start"],
    "factors": ((1, 2), (1, 3)),
    "bump": (3, 5),
    "ends": (1, 2),
}


def draw(chance):
    """Places with denominators 3 and 4, functions from the middle of the degrees 2 to 7."""
    places = [F(1, 3), F(2, 3), F(1, 4), F(3, 4)]
    return {
        "at": chance.choice(places),
        "down": chance.choice([1, 2]),
        "cut": chance.choice(places),
        "factors": ((chance.choice([1, 2]), 3), (chance.choice([1, 2]), chance.choice([2, 4]))),
        "bump": (chance.choice([2, 3]), chance.choice([5, 7])),
        "ends": (chance.randint(1, 4), chance.randint(1, 4)),
    }


def _words(numbers):
    return ", ".join(map(str, numbers))


# ---- One degree down


def _mixed(data, before, after, index=0):
    """Two neighbours of degree 4, the first one ``index`` places on from the number that is asked for."""
    values, first = numeric.bernstein(4, data["at"]), data["down"] + index
    return before * values[first] + after * values[first + 1]


def _down_mistakes(data):
    number = data["down"]
    same, next_one = F(4 - number, 4), F(number + 1, 4)
    return [
        (_mixed(data, next_one, same), "The factors are exchanged: try them on B(0,1,t) = 1 - t."),
        (_mixed(data, 1, 1), "You added the two values. Each of them has a factor before it."),
        (_mixed(data, F(1, 2), F(1, 2)), "You took the mean of two values: the factors depend on the index."),
        (_mixed(data, same, next_one, -1), "The factors are right, and both functions are one index too low."),
        (_mixed(data, same, next_one) * F(4, 3), "You divided by the lower one of the two degrees."),
    ]


# ---- The part of a function

HUMP = (0, 0, 1, 0)


def _part(data):
    return numeric.segment(HUMP, data["cut"], 1)


def _part_mistakes(data):
    cut = data["cut"]
    return [
        (numeric.segment(HUMP, 0, cut), f"This is the part before {cut}: the cut is its u = 1."),
        (_part(data)[::-1], "The numbers are right and their order is reversed: u = 0 is at the cut."),
        (numeric.segment(HUMP, 1 - cut, 1), f"This is the part from {1 - cut} on."),
        (
            numeric.evaluate(HUMP, [cut + (1 - cut) * F(place, 3) for place in range(4)]),
            "These are the values at u = 0, 1/3, 2/3, 1. Coefficients are no values, but at the ends.",
        ),
        (HUMP, "These are the coefficients on [0, 1]. Which value does the function have at the cut?"),
    ]


# ---- The area under a product


def _product(data):
    (first, low), (second, high) = data["factors"]
    return B(first, low, t) * B(second, high, t)


def _area_mistakes(data):
    (first, low), (second, high) = data["factors"]
    ways, degree = comb(low, first) * comb(high, second), low + high
    multiple = F(ways, comb(degree, first + second))
    return [
        (F(1, (low + 1) * (high + 1)), "You multiplied the two areas. The integral of a product is no product."),
        (F(1, degree + 1), "This is the area under one function of that degree. The product is a multiple of it."),
        (multiple, "This is the multiple. It still has to be multiplied by an area."),
        (multiple / degree, "The multiple is right. How many functions of that degree share the area 1?"),
        (F(ways, degree + 1), "The two binomials are there. The third one, of the new function, is missing."),
    ]


# ---- The slope, in factors


def _step(data, before, after, down=1):
    """Multiples of the two functions that the slope is made of; ``down`` is how far the degree falls."""
    number, degree = data["bump"]
    return before * B(number - 1, degree - down, t) + after * B(number, degree - down, t)


def _slope(data):
    degree = data["bump"][1]
    return factor(_step(data, degree, -degree).doit())


def _slope_mistakes(data):
    number, degree = data["bump"]
    powers = diff(t**number, t) * diff((1 - t) ** (degree - number), t)
    return [
        (_step(data, 1, -1), "The difference is right. The factor before it is missing."),
        (-_slope(data), "The sign: does the function rise or fall just after t = 0?"),
        (_step(data, degree, -degree, 0), "A derivative has a degree less: both functions, too."),
        (_step(data, degree, degree), "The derivative of 1 - t is -1: a sign is missing."),
        (
            comb(degree, number) * powers,
            "You multiplied the derivatives of the two powers. A product has another rule.",
        ),
    ]


# ---- Positive, with a negative height


def _is_positive(heights):
    """Whether a function with these control heights is positive on all of [0, 1]; exact."""
    powers = [Rational(height.numerator, height.denominator) for height in numeric.to_power(heights)]
    return bool(heights[0] > 0) and Poly(powers[::-1], t).count_roots(0, 1) == 0


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (
        lambda data, found: list(found[:, 0]) == [0, F(1, 3), F(2, 3), 1],
        "The control points of a graph stand above 0, 1/3, 2/3, 1, in this order.",
    ),
    (
        lambda data, found: (found[0][1], found[-1][1]) == data["ends"],
        "At t = 0 or at t = 1 the function has another value. Which heights decide that?",
    ),
    (lambda data, found: min(found[:, 1]) < 0, "No height is negative."),
    (
        lambda data, found: len(found) == 4 and _is_positive(found[:, 1]),
        "It is 0 or negative somewhere on [0, 1]: bring the negative height nearer to 0, or lift its neighbour.",
    ),
)


def _dip(data):
    left, right = data["ends"]
    return [(0, left), (F(1, 3), F(-left, 10)), (F(2, 3), right), (1, right)]


LINES = (
    (n - i) * t * B(i, n, t),
    (n - i) * binomial(n, i) * t ** (i + 1) * (1 - t) ** (n - i),
    (i + 1) * binomial(n, i + 1) * t ** (i + 1) * (1 - t) ** (n - i),
    (i + 1) * (1 - t) * B(i + 1, n, t),
)
FALLING = binomial(n - j, k) / binomial(n, k)

SET = Set(
    BOOK,
    draw,
    {
        "down": asks_value(
            "number",
            lambda data: (
                f"At a place t that is not told, B(0,4,t), ..., B(4,4,t) have the values "
                f"{_words(numeric.bernstein(4, data['at']))}. Give the value of B({data['down']},3,t) there."
            ),
            lambda data: numeric.bernstein(3, data["at"])[data["down"]],
            _down_mistakes,
            (
                "You need not find t. Which property writes a function with the next higher degree?",
                "B(i,n,t) is a sum of multiples of B(i,n+1,t) and B(i+1,n+1,t): the third elevation formula.",
            ),
        ),
        "part": asks_value(
            "numbers",
            lambda data: (
                f"Of B(2,3,t), the part over [{data['cut']}, 1] is taken, with the parameter u of its own: "
                f"t = {data['cut']} + {1 - data['cut']} u. Written as c_0 B(0,3,u) + ... + c_3 B(3,3,u), which "
                f"numbers are c_0, c_1, c_2, c_3?"
            ),
            _part,
            _part_mistakes,
            (
                "Two of the four numbers are values of the function at the ends of the part.",
                "Property 8 is for a part from 0 on. Look at it in the mirror.",
                "Or put 1 - t and t in u into 3 t^2 (1-t), and sort by powers of u and 1 - u.",
            ),
        ),
        "area": asks_value(
            "number",
            lambda data: "The area under the product {} * {}, over [0, 1]?".format(
                *(f"B({number},{degree},t)" for number, degree in data["factors"])
            ),
            lambda data: integrate(_product(data).doit(), (t, 0, 1)),
            _area_mistakes,
            (
                "Multiply the two, powers with powers: which function of a higher degree is it a multiple of?",
                "The multiple has three binomials. And all functions of one degree have the same area.",
            ),
        ),
        "slope": asks_formula(
            lambda data: (
                "Write the derivative of B({},{},t) as a product of a number, powers of t and 1-t, and one more "
                "factor, which shows where the peak is, for t in (0, 1).".format(*data["bump"])
            ),
            _slope,
            {t},
            {t: Interval.open(0, 1)},
            mistakes=_slope_mistakes,
            hints=(
                "n times a difference of two functions of degree n - 1.",
                "Take out all powers of t and 1-t that the two have in common.",
            ),
            form=("a product of such factors", is_factored),
        ),
        "crossing": asks_formula(
            lambda data: (
                "For n >= 1 and i = 0, ..., n-1, the graphs of the neighbours B(i,n,t) and B(i+1,n,t) cross at one "
                "place t in (0, 1). Write this place in i and n, as one fraction."
            ),
            lambda data: (i + 1) / (n + 1),
            {i, n},
            {n: (1, oo), i: (0, n - 1)},
            lambda data: [
                (i / n, "This is the peak of the first one."),
                ((i + 1) / n, "This is the peak of the second one."),
                ((2 * i + 1) / (2 * n), "This is midway between the peaks. Try i = 0 with n = 2."),
                ((n - i) / (n + 1), "This is 1 - t: which one of the two is larger near t = 0?"),
                ((i + 1) / (n + 2), "Try n = 1: where do 1 - t and t cross?"),
            ],
            (
                "Divide one function by the other: nearly everything cancels.",
                "Where is (n-i)/(i+1) t/(1-t) equal to 1?",
            ),
        ),
        "falling": asks_formula(
            lambda data: (
                "(1-t)^k is written with degree n >= 1, for k = 0, ..., n, as a combination of B(0,n,t), ..., "
                "B(n,n,t). Write the number before B(j,n,t) with binomials, in j, k and n; C(p,q) is 0 for p < q."
            ),
            lambda data: FALLING,
            {j, k, n},
            {n: (1, oo), j: (0, n), k: (0, n)},
            lambda data: [
                (FALLING.subs(j, n - j), "This is the number for t^k. Which end is 1 here?"),
                (FALLING * binomial(n, k), "At t = 0 the function is 1. What do you get for j = 0?"),
                (1 - j / n, "This is right for k = 1."),
                (1 - FALLING.subs(j, n - j), "This is the number for 1 - t^k."),
                (FALLING * binomial(n, k) / binomial(n, j), "(1-t)^0 is 1 everywhere. What do you get for k = 0?"),
            ],
            (
                "The lesson has the numbers for t^k. What does a mirror do to them?",
                "Or multiply (1-t)^k by ((1-t) + t)^(n-k), and expand the second power.",
            ),
        ),
        "neighbours": asks_truth(
            lambda data: (
                "True or false, for all n >= 2, i = 1, ..., n-1 and t in [0, 1]: the square of a function is at least "
                "the product of its two neighbours, B(i,n,t)^2 >= B(i-1,n,t) B(i+1,n,t)? "
                "If false, give a counterexample."
            ),
            lambda data: Ge(B(i, n, t) ** 2, B(i - 1, n, t) * B(i + 1, n, t)),
            {n: (2, oo), i: (1, n - 1), t: Interval(0, 1)},
            ("Write both sides out: the powers are the same.", "Are binomials larger in the middle of a row?"),
        ),
        "half-area": asks_truth(
            lambda data: (
                "All areas over [0, 1] are 1/(n+1). True or false, for all n >= 0 and i = 0, ..., n: half of the "
                "interval has half of the area, int(B(i,n,t), t, 0, 1/2) = 1/(2(n+1))? "
                "If false, give a counterexample."
            ),
            lambda data: Eq(Integral(B(i, n, t), (t, 0, Rational(1, 2))), 1 / (2 * (n + 1)), evaluate=False),
            {n: (0, oo), i: (0, n)},
            ("Draw the functions of degree 1 and 2.", "Which of them is its own mirror image?"),
        ),
        "ratio": asks_derivation(
            lambda data: (
                "From one function to the next one: for n >= 1 and i = 0, ..., n-1, begin with (n-i) t B(i,n,t), end "
                "with (i+1) (1-t) B(i+1,n,t), and write at least two lines between."
            ),
            LINES,
            {i, n, t},
            {n: (1, oo), i: (0, n - 1)},
            least=2,
            hints=(
                "Write the function out, and collect the powers of t.",
                "(n-i) C(n,i) = (i+1) C(n,i+1): write both with factorials.",
            ),
        ),
        "dip": asks_position(
            lambda data: (
                "If no height is negative, the function is not negative. The other way round? Give the four control "
                "points, above 0, 1/3, 2/3, 1, of the graph of a function that is {} at t = 0 and {} at t = 1 and "
                "positive on all of [0, 1], though one control height is negative.".format(*data["ends"])
            ),
            DEMANDS,
            _dip,
            (
                "Which two heights are given? One of the other two is to be negative.",
                "Only a little below 0: the neighbours hold the graph up. Where is it lowest? Try that place.",
            ),
        ),
    },
)
