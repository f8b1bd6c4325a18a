"""What the checker decides, refutes and cannot decide, on examples that it judges.

The table is ``decided.md`` beside this file; ``python -m bezteach.homework.decided`` writes it anew.
"""

from fractions import Fraction
from pathlib import Path

from sympy import Interval, Le, Rational, Sum, binomial, oo, sqrt

from bezteach.display import escaped
from bezteach.numeric import evaluate
from bezteach.symbolic import B, E, b, i, n, step, t

from .formulas import is_expanded
from .kinds import asks_derivation, asks_formula, asks_position, asks_truth, asks_value, judged

PLACE = Path(__file__).with_suffix(".md")
WITHIN = {n: (0, oo), i: (0, n)}
POINTS = ((0, 0), (1, 3), (2, 1), (3, 3))


def _value(kind, right, mistakes=()):
    return asks_value(kind, lambda data: "", lambda data: right, lambda data: mistakes)


def _formula(right, letters, ranges=None, **more):
    return asks_formula(lambda data: "", lambda data: right, letters, ranges, **more)


def _truth(relation, ranges):
    return asks_truth(lambda data: "", lambda data: relation, ranges)


REFLECTED = _formula(t**2 * (1 - t), {t}, mistakes=lambda data: [(t * (1 - t) ** 2, "t and 1 - t are exchanged.")])
SUM = asks_derivation(lambda data: "", [Sum(B(i, n, t), (i, 0, n)), 1], {i, n, t}, {n: (0, oo)})
THROUGH = asks_position(
    lambda data: "",
    [
        (lambda data, found: len(found) == 3, "A parabola has three control points."),
        (lambda data, found: tuple(evaluate(found, Fraction(1, 2))) == (2, 2), "At t = 1/2 it is somewhere else."),
    ],
    lambda data: [(0, 0), (2, 4), (4, 0)],
)
# what is asked for, in words; the question; answers to it
ROWS = [
    ("a number: 1/3", _value("number", Fraction(1, 3)), ["1/3", 1 / 3, 0.333, "0.5", "t", "1/0"]),
    ("a number with a root: √2/2", _value("number", sqrt(2) / 2), ["1/sqrt(2)", 0.5**0.5, "sqrt(3)/2"]),
    ("a point: p(1/3)", _value("point", evaluate(POINTS, Fraction(1, 3))), ["(1, 5/3)", "(1, 2)", "1"]),
    (
        "a list of points",
        _value("points", POINTS, [(POINTS[::-1], "The order is reversed.")]),
        [list(POINTS), list(POINTS[::-1]), [(0, 0), (1, 3), (2, 1), (3, 2)], [(0, 0), (1, 3)]],
    ),
    ("a matrix", _value("matrix", ((1, 0), (-1, 1))), [[[1, 0], [-1, 1]], [[1, -1], [0, 1]]]),
    ("a polynomial: t² (1 - t)", REFLECTED, ["t^2 - t^3", "t(1-t)^2", "t^2", "x"]),
    (
        "the same, multiplied out",
        _formula(t**2 - t**3, {t}, form=("multiplied out", is_expanded)),
        ["t^2 - t^3", "t^2 (1-t)"],
    ),
    (
        "a formula for every n and i: B(i,n,t)",
        _formula(B(i, n, t), {i, n, t}, WITHIN),
        [
            "C(n,i) t^i (1-t)^(n-i)",
            "n!/(i!(n-i)!) * t^i (1-t)^(n-i)",
            "t^i (1-t)^(n-i)",
            "C(n,i) t^i (1-t)^n/(1-t)^i",
        ],
    ),
    (
        "a number for every n: C(2n, n)",
        _formula(binomial(2 * n, n), {i, n}, {n: (0, oo)}),
        [
            "sum(C(n,i)^2, i, 0, n)",
            "sum(C(n,i)^2, i, 1, n)",
            "(2n)!/n!^2",
        ],
    ),
    (
        "a point for every n: p(t)",
        _formula(step(t) ** n * b[0], {i, n, t, E, b}, {n: (0, oo)}),
        [
            "sum(b_i B(i,n,t), i, 0, n)",
            "((1-t) + t E)^n b_0",
            "sum(b_(n-i) B(i,n,t), i, 0, n)",
        ],
    ),
    (
        "a function with a root: √t, t > 0",
        _formula(sqrt(t), {t}, {t: Interval.open(0, oo)}),
        ["sqrt(t)", "sqrt(t^3)/t"],
    ),
    (
        "true or false: B(i,n,t) <= 1 for t in [0, 1]",
        _truth(Le(B(i, n, t), 1), {**WITHIN, t: Interval(0, 1)}),
        [True, False, (False, "n = 1, i = 0, t = 0")],
    ),
    (
        "true or false: B(i,n,t) <= 1/2 for t in [0, 1]",
        _truth(Le(B(i, n, t), Rational(1, 2)), {**WITHIN, t: Interval(0, 1)}),
        [(False, "n = 1, i = 0, t = 0"), False, (False, "n = 2, i = 1, t = 1/2"), (False, "n = 1, i = 0, t = 2"), True],
    ),
    (
        "a derivation that the B(i,n,t) have the sum 1",
        SUM,
        [
            "sum(B(i,n,t), i, 0, n)\n= ((1-t) + t)^n\n= 1",
            "sum(B(i,n,t), i, 0, n)\n= 1",
            "sum(B(i,n,t), i, 0, n)\n= sum(C(n,i) t^i (1-t)^(n-i), i, 0, n)",
            "sum(B(i,n,t), i, 0, n)\n= sum(B(i,n,t), i, 1, n)\n= 1",
        ],
    ),
    ("three control points with p(1/2) = (2, 2)", THROUGH, [[(0, 0), (2, 4), (4, 0)], [(0, 0), (2, 2), (4, 0)]]),
]


def page():
    """The table as Markdown: each answer is judged here and now."""
    head = "# What the checker decides\n\nEach row is an answer that was judged as in a notebook.\n\n"
    lines = ["| asked for | answer | verdict | what is said |", "|---|---|---|---|"]
    for asked, question, answers in ROWS:
        for answer in answers:
            verdict = judged(question, {}, answer)
            cells = (escaped(asked), _code(answer), verdict.status, escaped(verdict.feedback))
            lines.append("| " + " | ".join(cells) + " |")
    return head + "\n".join(lines) + "\n"


def _code(answer):
    return "`" + (answer if isinstance(answer, str) else repr(answer)).replace("\n", " ") + "`"


if __name__ == "__main__":
    PLACE.write_text(page(), encoding="utf-8")
