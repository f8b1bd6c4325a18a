"""The questions of the lesson on the Bernstein basis."""

from fractions import Fraction as F
from itertools import pairwise

from ..numeric import bernstein, from_power, segment
from .asking import Choice, Entry, Goal


def _at_a_third():
    return [
        (bernstein(3, F(2, 3)), "These belong to t = 2/3: the power of t grows with the index, that of 1 - t falls."),
        (
            [F(8, 27), F(4, 27), F(2, 27), F(1, 27)],
            "The binomial coefficients 1, 3, 3, 1 are missing. Do your four numbers sum to 1?",
        ),
    ]


QUESTIONS = {
    "basis/before-binomial": Choice(
        "How many ways are there to choose 2 of 4 points?",
        {
            "4": "There are 4 points, but more pairs.",
            "6": "Yes: C(4, 2) = 4·3/2.",
            "8": "Write the pairs down: 12, 13, 14, 23, ...",
            "12": "That counts each pair twice, once in either order.",
        },
        "6",
    ),
    "basis/before-power": Choice(
        "((1 - t) + t) to the power n, multiplied out: what is the value for t = 1/4 and n = 5?",
        {
            "1": "Yes: before it is multiplied out it is 1 to the power 5.",
            "(1/4)⁵": "That is the last of its six terms alone.",
            "it depends on n": "Look inside the brackets first.",
        },
        "1",
    ),
    "basis/inner-reach": Choice(
        "Move t over the cubic functions. Does B₁ reach the value 1 somewhere?",
        {
            "yes, at t = 1/3": "At t = 1/3 it is greatest. Read its exact value there.",
            "no, only B₀ and B₃ reach 1": "Yes: if one of them were 1 the others would all be 0, "
            "and inside (0, 1) none is 0.",
            "yes, for a larger degree": "With the degree the humps get lower, not higher.",
        },
        "no, only B₀ and B₃ reach 1",
    ),
    "basis/sum-outside": Choice(
        "What is the sum of all Bᵢ,₃(t) at t = 2?",
        {
            "1": "Yes: the sum is 1 for every t. What ends outside [0, 1] is that none is negative.",
            "less than 1": "Multiply ((1 - t) + t) out at t = 2: nothing in it asks where t lies.",
            "not defined": "They are polynomials: t may be any number.",
        },
        "1",
    ),
    "basis/mirror": Choice(
        "Which function is the mirror image of B₁,₄, with 0 and 1 exchanged?",
        {
            "B₁,₄ itself": "Its peak is at 1/4; where is the mirror image's?",
            "B₃,₄": "Yes: exchanging t and 1 - t exchanges the exponents 1 and 3.",
            "B₄,₁": "The degree stays 4.",
        },
        "B₃,₄",
    ),
    "basis/peak": Choice(
        "Where is B₂,₅ greatest on [0, 1]?",
        {
            "at 1/2": "Only a function in the middle peaks there, and degree 5 has none.",
            "at 2/5": "Yes: at i/n.",
            "at 2/6": "There are 6 functions, but the peaks 0, 1/5, ..., 1 are 1/5 apart.",
            "at 3/5": "That is the peak of its mirror image.",
        },
        "at 2/5",
    ),
    "basis/derivative-degree": Choice(
        "The derivative of B₁,₃ is a combination of two Bernstein functions. Of which degree, and with which "
        "factor in front?",
        {
            "degree 2, factor 3": "Yes: n times a difference of two functions of degree n - 1.",
            "degree 2, factor 1": "At t = 0 the function leaves with slope 3.",
            "degree 3, factor 3": "A derivative has a degree less.",
        },
        "degree 2, factor 3",
    ),
    "basis/area": Choice(
        "Which of the cubic functions has the largest area under it, over [0, 1]?",
        {
            "B₀ and B₃, they reach 1": "They are high, but thin soon. The areas can be computed.",
            "B₁ and B₂, they are broad": "They are broad, but low. The areas can be computed.",
            "none, all areas are equal": "Yes: each is 1/4, since the four of them share the area 1 equally.",
        },
        "none, all areas are equal",
    ),
    "basis/sum-from-one": Choice(
        "A slide prints that the sum of the basis functions from i = 1 to n is 1. For which t is that true?",
        {
            "for every t": "Which function is left out, and where is it not 0?",
            "for no t": "The function left out is (1 - t) to the power n. Is it 0 somewhere?",
            "only at t = 1": "Yes: what is missing is (1 - t) to the power n.",
        },
        "only at t = 1",
    ),
    "basis/ends": Choice(
        "Which of the four cubic functions are not 0 at t = 0?",
        {
            "all four": "B₁, B₂ and B₃ have a factor t.",
            "only B₀": "Yes: the others have a factor t. So the curve begins in its first control point.",
            "B₀ and B₃": "B₃ is t³.",
        },
        "only B₀",
    ),
    "basis/recursion-weights": Choice(
        "At t = 1/4 you know B₂,₄ and B₁,₄. With which weights do they make B₂,₅?",
        {
            "3/4 and 1/4": "Yes: the last throw is tails with probability 1 - t, and then there were 2 heads before.",
            "1/4 and 3/4": "If you had 2 heads before, the last throw must be tails. How likely is that?",
            "1/2 and 1/2": "Heads and tails are not equally likely here.",
        },
        "3/4 and 1/4",
    ),
    "basis/elevation-multiple": Choice(
        "t B₁,₁(t) is t². Which multiple of which quadratic function is it?",
        {
            "1/2 of B₁,₂": "B₁,₂ is 2t(1 - t): it vanishes at t = 1, and t² does not.",
            "B₂,₂ itself": "Yes: (i + 1)/(n + 1) = 2/2, and the index has grown with the degree.",
            "2/3 of B₂,₂": "B₂,₂(1) = 1. What is t² there?",
        },
        "B₂,₂ itself",
    ),
    "basis/part-coefficient": Choice(
        "B₂,₂(t) = t². On the part up to t = 1/2, in terms of u = 2t, which multiple of B₂,₂(u) is it?",
        {
            "1/2": "t is u/2. What is t²?",
            "1/4": "Yes: t² = u²/4, and 1/4 is B₂,₂ at the place of the cut.",
            "1": "At u = 1 the function has the value that t² has at t = 1/2.",
        },
        "1/4",
    ),
    "basis/t-coefficients": Choice(
        "Write t as a combination of the four cubic functions. What are its coefficients?",
        {
            "0, 1, 0, 0": "That is B₁ itself, a hump.",
            "0, 1/3, 2/3, 1": "Yes: the coefficient before B_j is the place j/3 of its peak.",
            "1, 2/3, 1/3, 0": "These give 1 - t.",
        },
        "0, 1/3, 2/3, 1",
    ),
    "basis/zero-combination": Choice(
        "c₀B₀ + c₁B₁ + c₂B₂ + c₃B₃ is 0 for every t. What do you know of the coefficients?",
        {
            "they sum to 0": "At t = 0 only B₀ is left. What does that say of c₀ alone?",
            "c₀ and c₃ are 0, the others may be anything": "Divide what is left by t, and look at t = 0 again.",
            "all are 0": "Yes: at t = 0 only c₀ is left, so it is 0; divide by t, and so on.",
        },
        "all are 0",
    ),
    "basis/exercise-values": Entry(
        "Exercise 1. The values B₀,₃, B₁,₃, B₂,₃, B₃,₃ at t = 1/3:",
        lambda: bernstein(3, F(1, 3)),
        _at_a_third,
        "1/2, 1/4, 1/8, 1/8",
    ),
    "basis/exercise-peak": Entry(
        "Exercise 2. The greatest value of B₁,₄ on [0, 1]:",
        lambda: bernstein(4, F(1, 4))[1],
        lambda: [
            (F(1, 4), "That is where it is greatest. How great is it there?"),
            (F(27, 256), "The binomial coefficient is missing."),
            (1, "Only the first and the last function reach 1."),
        ],
        "1/2",
    ),
    "basis/exercise-recursion": Entry(
        "Exercise 3. At t = 1/4, B₁,₄ = 27/64 and B₀,₄ = 81/256. Find B₁,₅ there by the recursion:",
        lambda: bernstein(5, F(1, 4))[1],
        lambda: [
            (
                F(1, 4) * F(27, 64) + F(3, 4) * F(81, 256),
                "The weights are exchanged: the function with the same index takes 1 - t.",
            ),
            (F(27, 64) + F(81, 256), "Both parts need their weights, 1 - t and t."),
        ],
        "1/2",
    ),
    "basis/exercise-integral": Entry(
        "Exercise 4. The integral of B₂,₇ over [0, 1]:",
        lambda: F(1, 8),
        lambda: [
            (F(1, 7), "There are n + 1 functions to share the area 1."),
            (F(2, 7), "That is where it is greatest."),
        ],
        "1/2",
    ),
    "basis/exercise-coefficients": Entry(
        "Exercise 5. Write t² as a combination of B₀,₃, B₁,₃, B₂,₃, B₃,₃; its four coefficients:",
        lambda: from_power([0, 0, 1, 0]),
        lambda: [
            ((0, 0, 1, 0), "These are its coefficients in the power basis. At t = 1 they would give 0."),
            (
                (0, F(1, 9), F(4, 9), 1),
                "These are its values at 0, 1/3, 2/3, 1. Coefficients are no values, except at the ends.",
            ),
            ((0, 0, F(2, 3), 1), "C(2, 2) over C(3, 2) is the coefficient of B₂: which fraction is that?"),
        ],
        "1, 0, 1/2, 1",
    ),
    "basis/exercise-part": Entry(
        "Exercise 6. B₂,₂(t) = t², for t up to 1/2 only, in terms of u = 2t. Its coefficients in the Bernstein "
        "basis of u, B₀ first:",
        lambda: segment([0, 0, 1], 0, F(1, 2)),
        lambda: [
            ((0, 0, 1), "At u = 1, that is t = 1/2, the function is not 1."),
            ((0, 0, F(1, 2)), "At u = 1 it is t² with t = 1/2."),
        ],
        "0, 1, 1/2",
    ),
}


def _straight(state):
    """Heights that rise or fall by equal steps, over the places 0, 1/3, 2/3, 1."""
    heights = [y for _, y in state.points]
    steps = {later - now for now, later in pairwise(heights)}
    return len(heights) == 4 and len(steps) == 1 and steps != {0}


GOALS = {
    "basis/straight": Goal(
        "Task: make the graph a straight line, but not a horizontal one.",
        _straight,
        "Reached: heights at equal steps. Look at the polygon, too.",
    ),
}
