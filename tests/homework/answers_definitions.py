"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

BOOK = {
    "02-definitions/walk": (
        ["(9/2, 27/8)", (F(9, 2), F(27, 8)), [4.5, 3.375]],
        [
            ("(369/64, -27/16)", "vectors for control points"),
            ("(27/2, 27/8)", "begins at the origin"),
            ("(-9/2, 27/8)", "the point at 1 - t"),
            ("(855/64, 27/8)", "as seen from b_0"),
            ("(9/2, 27/4)", "1 of 2 numbers"),
        ],
    ),
    "02-definitions/shift": (
        ["(7/3, 14/3)", (F(7, 3), F(14, 3)), "(7/27 * 9, 7/27 * 18)"],
        [
            ((2, 4), "if b_k alone moves"),
            ("(1/3, 2/3)", "One function is missing"),
            ((9, 18), "vertices behind the edge"),
            ("(20/3, 40/3)", "exchanged"),
            ((1, 2), "None of the 2 numbers"),
        ],
    ),
    "02-definitions/combination": (
        [
            "B(0,3,t) + 3 B(1,3,t) + 4 B(2,3,t) + 6 B(3,3,t)",
            "6 B_{3,3}(t) + 4 B_{2,3}(t) + 3 B_{1,3}(t) + B_{0,3}(t)",
            "B(0,3,t) + 3 (B(1,3,t) + 2 B(3,3,t)) + 4 B(2,3,t)",
        ],
        [
            ("B(0,3,t) + 6 B(1,3,t) - 3 B(2,3,t) + 2 B(3,3,t)", "t is not B(1, 3, t)"),
            ("B(0,3,t) + 7 B(1,3,t) + 4 B(2,3,t) + 6 B(3,3,t)", "added up the coefficients"),
            ("B(0,3,t) + 74/27 * B(1,3,t) + 115/27 * B(2,3,t) + 6 B(3,3,t)", "not on the curve"),
            ("1 + 6t - 3t^2 + 2t^3", "not a combination"),
            ("B(0,3,t) + 3 B(1,3,t) + 4 B(2,3,t) + 5 B(3,3,t)", "your formula is"),
        ],
    ),
    "02-definitions/powers": (
        ["(0, 0), (0, 9), (9, -9), (-6, 0)", [(0, 0), (0, 9.0), (F(9), "-9"), (-6, 0)]],
        [
            ("(-6, 0), (9, -9), (0, 9), (0, 0)", "highest power first"),
            ("(0, 0), (0, 3), (3, -3), (-6, 0)", "differences at b_0"),
            ("(0, 0), (0, 9), (18, -18), (-36, 0)", "derivatives at t = 0"),
            ("(6, 0), (-9, -9), (0, 9), (3, 0)", "rows and the columns"),
            ("(0, 0), (0, 9), (9, 9), (-6, 0)", "3 of 4 rows"),
        ],
    ),
    "02-definitions/matrix": (
        ["[[1, -2, 1], [-2, 2, 0], [1, 0, 0]]", [(1, -2, 1), (-2, 2, 0), (1, 0, 0)]],
        [
            ("[[1, 0, 0], [-2, 2, 0], [1, -2, 1]]", "the matrix for [1 t t^2]"),
            ("[[1, -2, 1], [0, 2, -2], [0, 0, 1]]", "in the order b_2, b_1, b_0."),
            ("[[0, 0, 1], [0, 2, -2], [1, -2, 1]]", "and the powers 1, t, t^2"),
            ("[[1, 0, 0], [1, 1/2, 0], [1, 1, 1]]", "the way back"),
            ("[[1, 2, 1], [-2, 2, 0], [1, 0, 0]]", "2 of 3 rows"),
        ],
    ),
    "02-definitions/second": (
        [
            "C(n,2) (b_2 - 2b_1 + b_0)",
            "n(n-1)/2 * b_0 - n(n-1) b_1 + n(n-1)/2 * b_2",
            "n!/(2 (n-2)!) * (b0 + b2 - 2b1)",
        ],
        [
            ("b_2 - 2b_1 + b_0", "A factor is missing"),
            ("n(n-1) (b_2 - 2b_1 + b_0)", "second derivative"),
            ("n (b_2 - 2b_1 + b_0)", "belongs to t"),
            ("C(n,2) b_2", "bring a t^2, too"),
            ("C(n,2) (b_2 - b_0)", "your formula is"),
        ],
    ),
    "02-definitions/steady": ([True, "true"], [("false: n = 2, t = 1/2", "Not so")]),
    "02-definitions/symmetric": (
        [(False, "n = 2, i = 1, t = 1/2"), "false: n = 3, i = 3, t = 1/2"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 3, i = 2, t = 1/3", "the statement holds"),
            ("false: n = 2, i = 0, t = 1/2", "outside"),
        ],
    ),
    "02-definitions/switch": (
        [
            "sum(B(i,n,t), i, 1, n)\n= sum(B(i,n,t), i, 0, n) - B(0,n,t)\n= 1 - B(0,n,t)\n= 1 - (1-t)^n",
            "sum(B(i,n,t), i, 1, n)\n= sum(C(n,i) t^i (1-t)^(n-i), i, 1, n)\n"
            "= sum(C(n,i) t^i (1-t)^(n-i), i, 0, n) - (1-t)^n\n= ((1-t) + t)^n - (1-t)^n\n= 1 - (1-t)^n",
            ["sum(B(i,n,t), i, 1, n)", "1 - B(0,n,t)", "1 - (1-t)^n"],
        ],
        [
            ("sum(B(i,n,t), i, 1, n)\n= 1 - (1-t)^n", "show why"),
            ("sum(B(i,n,t), i, 1, n)\n= sum(B(i,n,t), i, 0, n)\n= 1 - (1-t)^n", "Line 2 does not follow"),
            ("sum(B(i,n,t), i, 1, n)\n= 1 - B(0,n,t)\n= 1 - t^n", "Line 3 does not follow"),
            ("sum(B(i,n,t), i, 0, n)\n= 1", "begin with"),
        ],
    ),
    "02-definitions/start": (
        ["(0, 0), (1, 2), (3, 3), (12, 9)", [(0, 0), (1, F(6, 3)), (4, 2), ("9", 12)]],
        [
            ("(0, 0), (1, 2), (3, 3)", "four control points"),
            ("(1, 0), (2, 2), (3, 3), (8, 9)", "does not start"),
            ("(0, 0), (3, 6), (3, 3), (6, -3)", "The velocity"),
            ("(0, 0), (1, 2), (3, 3), (3, 3)", "somewhere else"),
        ],
    ),
}
