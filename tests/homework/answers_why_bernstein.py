"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

SHIFTED = "sum((b_i + v) B(i,n,t), i, 0, n)", "sum(b_i B(i,n,t), i, 0, n) + v"

BOOK = {
    "01-why-bernstein/way": (
        ["10/3", F(10, 3), 10 / 3, "8/3 + 2/3"],
        [
            (2, "how far the end is"),
            (6, "length of the polygon"),
            (3, "does not turn at t = 1/2"),
            ("8/3", "the way out"),
            (F(2, 3), "the way back"),
            (4, "Not this"),
        ],
    ),
    "01-why-bernstein/coefficient": (
        ["(0, 0), (2, 5), (4, 5), (6, 9)", [(0, 0), (2, 5.0), (F(4), 5), ("6", 9)]],
        [
            ("(0, 0), (4, 9), (2, 1), (3, 3)", "no control point"),
            ("(0, 0), (4, 9), (5, 7), (6, 9)", "not its full weight"),
            ("(0, 0), (2, 5), (2, 1), (3, 3)", "the later functions"),
            ("(0, 0), (2, 5), (3, 3), (4, 5)", "as small at the end"),
            ("(3, 6), (3, 7), (3, 3), (3, 3)", "shares of 1 - t"),
            ("(3, 6), (4, 9), (5, 7), (6, 9)", "as a whole"),
            ("(0, 0), (2, 5), (4, 5), (6, 8)", "3 of 4 rows"),
        ],
    ),
    "01-why-bernstein/values": (
        ["[(1, 0, 0), (-1, 9/4, -1/4), (0, 0, 1)]", [[1, 0, 0], [-1, 2.25, -0.25], [0, 0, F(1)]]],
        [
            ("[(1, 0, 0), (4/9, 4/9, 1/9), (0, 0, 1)]", "the other way"),
            ("[(1, 0, 0), (-4, 9/2, -1/2), (3, -9/2, 3/2)]", "coefficients of 1, t, t^2"),
            ("[(1, -1, 0), (0, 9/4, 0), (0, -1/4, 1)]", "Rows and columns"),
            ("[(1, 0, 0), (-1/4, 9/4, -1), (0, 0, 1)]", "t and 1 - t"),
            ("[(1, 0, 0), (-1/2, 2, -1/2), (0, 0, 1)]", "taken at t = 1/2"),
            ("[(1, 0, 0), (0, 1, 0), (0, 0, 1)]", "through its middle control point"),
            ("[(1, 0, 0), (-1, 9/4, 1/4), (0, 0, 1)]", "2 of 3 rows"),
        ],
    ),
    "01-why-bernstein/nearest": (
        [16, "16", 16.0],
        [
            (22, "passes through the first sample"),
            ("16/3", "passes through the second sample"),
            (F(41, 3), "mean of the two heights"),
            ("13/2", "mean of the samples"),
            (F(50, 7), "divided by the sum of the weights"),
            (6.25, "not b_1 yet"),
            (20, "Not this"),
        ],
    ),
    "01-why-bernstein/raised": (
        ["2 - 1/2^n", "sum((1/2)^k, k, 0, n)", "(1 - (1/2)^(n+1))/(1 - 1/2)", "(2^(n+1) - 1)/2^n"],
        [
            ("n + 1", "happens at t = 1"),
            (1, "weights add up to 1"),
            ("2 - 1/2^(n-1)", "One term is missing"),
            ("1 - 1/2^n", "a_0 is missing"),
            (2, "infinitely many"),
            ("(1/2)^n", "the last coefficient"),
            ("2^n", "n = 1 your formula is 2"),
        ],
    ),
    "01-why-bernstein/size": (
        ["C(n,i)*2^(n-i)", "n!/(i!(n-i)!) * 2^n/2^i", "sum(C(n,i) C(n-i,j), j, 0, n-i)"],
        [
            ("2^n", "right for i = 0"),
            ("2^(n-i)", "a factor before them"),
            ("C(n,i)", "first coefficient alone"),
            ("C(n,i)*2^n", "How many brackets"),
            (0, "With their signs"),
            ("3^n", "your formula is 3"),
        ],
    ),
    "01-why-bernstein/arc": ([True, "true"], [("false: t = 1/2", "Not so")]),
    "01-why-bernstein/weaker": (
        [(False, "n = 2, i = 1, t = 1/4"), "false: n = 3, i = 1, t = 1/3"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 2, i = 1, t = 3/4", "the statement holds"),
            ("false: n = 2, i = 3, t = 1/2", "outside"),
        ],
    ),
    "01-why-bernstein/shifted": (
        [
            [
                SHIFTED[0],
                "sum(b_i B(i,n,t) + v B(i,n,t), i, 0, n)",
                "sum(b_i B(i,n,t), i, 0, n) + v sum(B(i,n,t), i, 0, n)",
                SHIFTED[1],
            ],
            f"{SHIFTED[0]}\n= sum(b_i B(i,n,t), i, 0, n) + v sum(C(n,i) t^i (1-t)^(n-i), i, 0, n)\n"
            f"= sum(b_i B(i,n,t), i, 0, n) + v ((1-t) + t)^n\n= {SHIFTED[1]}",
        ],
        [
            (SHIFTED, "show why"),
            ((SHIFTED[0], "sum(b_i B(i,n,t), i, 0, n) + (n+1) v", SHIFTED[1]), "Line 2 does not follow"),
            ((SHIFTED[0], "sum(b_i B(i,n,t) + v B(i,n,t), i, 0, n)"), "Go on until"),
            (SHIFTED[::-1], "begin with"),
        ],
    ),
    "01-why-bernstein/turned": (
        ["(0, 2), (6, 5), (4, 0)", [(0, 2), (F(-1, 2), 5), (4, 0)]],
        [
            ("(0, 2), (5, 4), (5, 4), (4, 0)", "three control points"),
            ("(0, 0), (6, 5), (4, 2)", "ends"),
            ("(0, 2), (6, 3), (4, 0)", "another height"),
            ("(0, 2), (4, 5), (4, 0)", "this is a graph"),
            ("(0, 2), (-6, 5), (4, 0)", "on one line"),
        ],
    ),
}
