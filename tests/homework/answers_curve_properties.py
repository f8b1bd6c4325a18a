"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

BOOK = {
    "04-curve-properties/clock": (
        ["(3/2, 3)", (F(3, 2), 3), [1.5, 3]],
        [
            ((3, 6), "measured in t"),
            ((6, 12), "is the point faster"),
            ((F(1, 2), 1), "a factor more"),
            ("(3/2, 9/2)", "at the start"),
            ("(-3/2, -3)", "points back"),
            ("(3/2, 1)", "1 of 2 numbers"),
        ],
    ),
    "04-curve-properties/moved": (
        ["(4, 4)", (4, 4.0), "(4/9 * 9, 2/9 * 18)"],
        [
            ((2, 8), "exchanged"),
            ((9, 18), "the weight of its point"),
            ((4.5, 9), "not 1/2 each"),
            ("(4/3, 4/3)", "binomial coefficients are missing"),
            ("(8/3, 8)", "counted from 0"),
            ((4, 0), "1 of 2 numbers"),
        ],
    ),
    "04-curve-properties/even": (
        ["(1, 1), (3, 5), (5, 9), (7, 13)", [(1, 1), (3, 5), (5, F(9)), ("7", 13)]],
        [
            ("(1, 1), (2, 3), (3, 5), (4, 7)", "at t = 1 only"),
            ("(1, 1), (4, 7), (4, 7), (7, 13)", "the first edge is long"),
            ("(1, 1), (5/2, 4), (11/2, 10), (7, 13)", "the edges are not equal"),
            ("(1, 1), (4, 7), (7, 13)", "with degree 2"),
            ("(7, 13), (5, 9), (3, 5), (1, 1)", "order is reversed"),
            ("(1, 1), (3, 5), (5, 9), (8, 13)", "3 of 4 rows"),
        ],
    ),
    "04-curve-properties/image": (
        ["(0, 5), (1, 3), (-2, 5), (0, 2)", [(0, 5), (1, 3.0), (-2, 5), (F(0), 2)]],
        [
            ("(0, 2), (-2, 5), (1, 3), (0, 5)", "begins where p ends"),
            ("(0, 3), (1, 1), (-2, 3), (0, 0)", "The shift is missing"),
            ("(3, 3), (2, 1), (1, 3), (0, 0)", "did not map it"),
            ("(-2, 5), (-1, 3), (-4, 5), (-2, 2)", "shifted first"),
            ("(0, 5), (1, 3), (-2, 5), (0, 0)", "3 of 4 rows"),
        ],
    ),
    "04-curve-properties/alternate": (
        ["(1-2t)^n", "sum((-1)^j B(j,n,t), j, 0, n)", "((1-t) - t)^n"],
        [
            ("(1-t)^n - t^n", "two ends alone"),
            ("(1-t)^n + (-1)^n t^n", "two ends alone"),
            ("1 - 2t", "right for n = 1"),
            ("(2t-1)^n", "The sign"),
            ("(t + (1-t))^n", "The heights alternate"),
            ("(1-t)^n", "your formula is"),
        ],
    ),
    "04-curve-properties/half": (
        [(False, "n = 3, i = 1"), "false: n = 4, i = 2"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 2, i = 1", "the statement holds"),
            ("false: n = 3, i = 4", "outside"),
        ],
    ),
    "04-curve-properties/parabola": ([True, "true"], [("false: n = 1, t = 1/2", "Not so")]),
    "04-curve-properties/doubling": (
        [
            "sum(2^j B(j,n,t), j, 0, n)\n= sum(2^j C(n,j) t^j (1-t)^(n-j), j, 0, n)\n"
            "= sum(C(n,j) (2t)^j (1-t)^(n-j), j, 0, n)\n= ((1-t) + 2t)^n\n= (1+t)^n",
            ["sum(2^j B(j,n,t), j, 0, n)", "sum(C(n,j) (2t)^j (1-t)^(n-j), j, 0, n)", "(1+t)^n"],
        ],
        [
            ("sum(2^j B(j,n,t), j, 0, n)\n= (1+t)^n", "show why"),
            (
                "sum(2^j B(j,n,t), j, 0, n)\n= sum(2^j C(n,j) t^j (1-t)^(n-j), j, 0, n)\n= 2^n\n= (1+t)^n",
                "Line 3 does not follow",
            ),
            ("sum(2^j B(j,n,t), j, 0, n)\n= sum((2t)^j C(n,j) (1-t)^(n-j), j, 0, n)", "Go on until"),
            ("(1+t)^n\n= sum(2^j B(j,n,t), j, 0, n)", "begin with"),
        ],
    ),
    "04-curve-properties/mirror": (
        ["(0, 0), (0, 4), (6, 4), (6, 0)", [(0, 0), (1, 4), ("5", 4), (6, F(0))]],
        [
            ("(0, 0), (3, 6), (6, 0)", "four control points"),
            ("(1, 0), (0, 4), (6, 4), (5, 0)", "does not start"),
            ("(0, 0), (0, 4), (6, 4), (7, 0)", "exchange the points in pairs"),
            ("(0, 0), (0, 3), (6, 3), (6, 0)", "somewhere else"),
        ],
    ),
}
