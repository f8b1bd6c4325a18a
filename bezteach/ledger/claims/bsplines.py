"""B-spline functions: the recursion, support, sign, sum and derivative.

Degree p, knots t_0 <= t_1 <= ...; the functions are N_{i,p}, span k is [t_k, t_{k+1}). What is
shown for every p are the steps of inductions on p, with the functions of lower degree as letters.
"""

from fractions import Fraction
from functools import cache

from sympy import Integer, Symbol, symbols

from bezteach.symbolic import t
from bezteach.symbolic.bspline import terms

from ..claim import Computed, Known, argued, claim
from ..forms import quotient
from ..knots import DEGREES, all_multiplicities, letters, one_span, piece, spans

p = Symbol("p", integer=True, positive=True)
s, A, B, C = symbols("s A B C", real=True)
g0, g1, g2, g3, g4 = GAPS = symbols("h0:5", positive=True)
RUN = [s, s + g0, s + g0 + g1, s + g0 + g1 + g2, s + g0 + g1 + g2 + g3, s + g0 + g1 + g2 + g3 + g4]
START, SECOND, THIRD, BEFORE_LAST, LAST, END = RUN
SHARES = quotient(t - s, g0) + quotient(s + g0 - t, g0)
QUADRATIC = sum(sum(terms(place, 2, RUN, t, 2)) for place in range(3))
ONE_LEFT_OUT = sum(sum(terms(place, 2, RUN, t, 2)) for place in range(2))

# N_{i,p-1} and N_{i+1,p-1} from the functions of degree p - 2, each divided by the length of its support: A, B, C
LOWER, HIGHER = (t - START) * A + (LAST - t) * B, (t - SECOND) * B + (END - t) * C
LOWER_SLOPE, HIGHER_SLOPE = (p - 1) * (A - B), (p - 1) * (B - C)
RISING = (LOWER + (t - START) * LOWER_SLOPE) / (LAST - START)
FALLING = (-HIGHER + (END - t) * HIGHER_SLOPE) / (END - SECOND)
FORMULA = p * LOWER / (LAST - START) - p * HIGHER / (END - SECOND)


@cache
def everywhere():
    """(p, knots, t, span, piece) of one function of each degree on each span, for knots with all multiplicities.

    The first knot is 0: only differences count.
    """
    return [
        (p, knots, t, span, piece(0, p, knots, t, span))
        for p in DEGREES
        for times in all_multiplicities(p + 2)
        for knots, t in [letters(*times, zero=0)]
        for span in spans(knots)
    ]


def recursion_degree():
    return all(found.numer.degree(t.numer) == p for p, _, t, _, found in everywhere())


def nothing_outside():
    """With two knots more on each side, all simple: no piece on the spans beside the support."""
    return all(
        bool(piece(2, p, knots, t, span)) is (2 <= span <= 2 + p)
        for p in DEGREES
        for knots, t in [letters(*[1] * (p + 6))]
        for span in spans(knots)
    )


def sums_to_one():
    return all(
        sum(piece(place, p, knots, t, p) for place in range(p + 1)) == 1 for p in DEGREES for knots, t in [one_span(p)]
    )


def less_than_one_outside():
    """The quadratics on the knots 0, ..., 5 at t = 1/2 and at t = 2."""
    _, t = letters(1)
    at = [sum(piece(place, 2, range(6), t, span) for place in range(3)) for span in (0, 2)]
    return at[0] == t**2 / 2 and at[1] == 1


def slopes_agree():
    return all(found.diff(t) - slope(p, knots, t, span) == 0 for p, knots, t, span, found in everywhere() if p)


def slope(p, knots, t, span):
    """The derivative formula for the first function; a support of length 0 leaves its part out."""
    signed = ((1, 0), (-1, 1))
    parts = (
        sign * p * piece(place, p - 1, knots, t, span) / (knots[place + p] - knots[place])
        for sign, place in signed
        if knots[place + p] != knots[place]
    )
    return sum(parts, 0 * t)


def no_term_turns_negative():
    """Each term at a point of the span with numbers for the knots: positive for all degrees and multiplicities."""
    return all(
        term > 0
        for p in DEGREES
        for times in all_multiplicities(p + 2)
        for knots in [[Fraction(3 * place * place) for place, count in enumerate(times) for _ in range(count)]]
        for span in spans(knots)
        for term in terms(0, p, knots, knots[span] + 1, span)
    )


def vanishing_with_too_many():
    return all(piece(0, p, knots, t, p + 2) == 0 for p in DEGREES for knots, t in [letters(p + 2, 1)]) and all(
        not terms(0, p, letters(p + 2)[0], letters(p + 2)[1], span) for p in DEGREES for span in range(p + 1)
    )


CLAIMS = [
    argued(
        "bspline/definition",
        "the recursion gives piecewise polynomials: on each span that is not empty one of degree p at most",
        "N_{i,0} is 1 for t_i <= t < t_{i+1} and 0 elsewhere: a constant on each span, and 0 if t_i = t_{i+1}.",
        "N_{i,p}(t) = (t - t_i)/(t_{i+p} - t_i) N_{i,p-1}(t) + (t_{i+p+1} - t)/(t_{i+p+1} - t_{i+1}) N_{i+1,p-1}(t). A "
        "factor whose denominator is 0 stands before a function that is 0 everywhere, and the product counts as 0.",
        "Each step multiplies polynomials of degree p - 1 at most by polynomials of degree 1: by induction the degree "
        "is p at most. The factors are polynomials in t, no numbers: numbers would not raise the degree.",
        Computed("For p = 0, ..., 4 and knots of all multiplicities every piece has the degree p.", recursion_degree),
    ),
    argued(
        "bspline/support",
        "N_{i,p} is 0 outside of t_i <= t < t_{i+p+1}, and on each span there are p + 1 functions at most",
        "For p = 0 it is the definition. N_{i,p-1} and N_{i+1,p-1} are 0 outside of [t_i, t_{i+p}) and "
        "[t_{i+1}, t_{i+p+1}), both within [t_i, t_{i+p+1}): by induction it holds for every p.",
        "So on span k only the functions with k - p <= i <= k may differ from 0. If p + 2 knots are one, the support "
        "is empty, and the function is 0 everywhere.",
        Computed("For p = 0, ..., 4 and simple knots the function has exactly p + 1 pieces.", nothing_outside),
        Computed("For p = 0, ..., 4 and one knot p + 2 times nothing is left.", vanishing_with_too_many),
    ),
    argued(
        "bspline/non-negative",
        "no B-spline function is negative, and inside its support it is positive",
        "For p = 0 it is the definition. On span k with i <= k <= i + p: t - t_i >= 0 and t_{i+p+1} - t >= 0, and the "
        "denominators are positive where they are not left out. So, by induction on p, N_{i,p} is a sum of products "
        "that are not negative.",
        "For t_i < t < t_{i+p+1} both factors are positive, and so is one of the lower functions, by induction: the "
        "first if t < t_{i+p}, the second if t > t_{i+1}. Else t_{i+1} = ... = t_{i+p} = t, and the second, which "
        "begins with p knots at t, is 1 there: each step leaves it the factor (t_{i+p+1} - t)/(t_{i+p+1} - t) = 1.",
        Known("Outside of the support it is 0.", "bspline/support"),
        Computed(
            "Instances: p = 0, ..., 4, knots of all multiplicities, a point in each span: every term is positive.",
            no_term_turns_negative,
        ),
    ),
    claim(
        "bspline/unity/step",
        "the two factors of one lower function add up to one: the step of the induction, for every degree",
        (SHARES, Integer(1)),
        twins=[
            (quotient(t - s, g0) + quotient(s + g0 - t, g1), Integer(1)),
            (quotient(t - s, g0) + quotient(t - s - g0, g0), Integer(1)),
        ],
    ),
    claim(
        "bspline/unity/quadratic",
        "degree 2, simple knots, the middle one of five spans: the three pieces add up to one",
        (QUADRATIC, Integer(1)),
        twins=[(ONE_LEFT_OUT, Integer(1)), (QUADRATIC, t)],
    ),
    argued(
        "bspline/unity",
        "on the domain from t_p to t_{n+1} the functions add up to one",
        "Let t lie in a span k with p <= k <= n. There N_{k-p,p}, ..., N_{k,p} are all that may differ from 0. By the "
        "recursion their sum is that of the N_{i,p-1} with k - p + 1 <= i <= k, each with two factors, from N_{i,p} "
        "and from N_{i-1,p}; what stands outside of these indices is 0 on the span.",
        Known("The functions of degree p - 1 that are not 0 on span k are these p.", "bspline/support"),
        Known(
            "The two factors add up to one; t_{i+p} - t_i is positive, as span k lies between.", "bspline/unity/step"
        ),
        "So the sum is the same for p - 1, and so on down to N_{k,0} = 1: the proof is for every p.",
        Computed("The pieces on a span [0, 1] among other knots that are letters, for p = 0, ..., 4.", sums_to_one),
        Computed(
            "Before t_p some are missing: degree 2, knots 0, ..., 5: the sum is t^2/2 on [0, 1).", less_than_one_outside
        ),
    ),
    claim(
        "bspline/derivative/step",
        "the derivative of the recursion, its lower functions differentiated by the formula: the formula again",
        (RISING + FALLING, FORMULA),
        twins=[(RISING + FALLING, (p - 1) * FORMULA / p), (RISING - FALLING, FORMULA)],
    ),
    argued(
        "bspline/derivative",
        "N_{i,p}' = p/(t_{i+p} - t_i) N_{i,p-1} - p/(t_{i+p+1} - t_{i+1}) N_{i+1,p-1}, at a knot from the right",
        "On a span that is not empty. For p = 1 the recursion is two constants times linear functions: the formula.",
        "Let p >= 2, and let A, B and C be N_{i,p-2}, N_{i+1,p-2} and N_{i+2,p-2}, each divided by the length of its "
        "support, or 0 if that is 0. Then N_{i,p-1} = (t - t_i) A + (t_{i+p} - t) B and, by the formula for p - 1, its "
        "derivative is (p - 1)(A - B); likewise for N_{i+1,p-1} with B and C.",
        Known("Put into the derivative of the recursion this is the formula for p.", "bspline/derivative/step"),
        "If t_i = t_{i+p}, then A = B = 0 and the first part is left out on both sides; if t_{i+1} = t_{i+p+1}, then "
        "B = C = 0 and the second is. So the proof is for every p and all knots.",
        Computed("The pieces, differentiated, for p = 1, ..., 4 and knots of all multiplicities.", slopes_agree),
        "For the curve: its derivative has the degree p - 1 and the control points p (b_i - b_{i-1})/(t_{i+p} - t_i).",
    ),
]
