"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

BOOK = {
    "09-degree-elevation/elevated": (
        [
            "(0, 0), (3/4, 9/4), (3/2, 2), (9/4, 3/2), (3, 3)",
            [(0, 0), (0.75, 2.25), (1.5, 2), (F(9, 4), F(3, 2)), (3, 3)],
        ],
        [
            ("(0, 0), (1/4, 3/4), (3/2, 2), (11/4, 5/2), (3, 3)", "weights are exchanged"),
            ("(0, 0), (3/4, 9/4), (7/4, 3/2), (11/4, 5/2), (3, 3)", "ratio of the first edge on all"),
            ("(0, 0), (1/2, 3/2), (3/2, 2), (5/2, 2), (3, 3)", "middles of the edges"),
            ("(0, 0), (2/3, 2), (4/3, 7/3), (2, 1), (3, 3)", "divided by the old degree"),
            ("(3/4, 9/4), (3/2, 2), (9/4, 3/2)", "inner points"),
            ("(0, 0), (3/4, 9/4), (3/2, 2), (2, 2), (3, 3)", "4 of 5 rows"),
        ],
    ),
    "09-degree-elevation/twice": (
        [
            "(0, 1), (1/2, 1), (2/3, 7/6), (1/2, 3/2), (0, 2)",
            [(0, 1), (F(1, 2), 1), ("2/3", "7/6"), (0.5, 1.5), (0, 2)],
        ],
        [
            ("(0, 1), (2/3, 1), (2/3, 4/3), (0, 2)", "one more step"),
            ("(0, 1), (4/9, 1), (2/3, 10/9), (2/3, 4/3), (0, 2)", "other denominators"),
            ("(0, 1), (1/3, 1), (2/3, 7/6), (1/3, 5/3), (0, 2)", "you took the middles"),
            ("(0, 1), (1/6, 1), (2/3, 7/6), (1/6, 11/6), (0, 2)", "weights are exchanged"),
            ("(0, 1), (1/2, 1), (1, 1), (1/2, 3/2), (0, 2)", "4 of 5 rows"),
        ],
    ),
    "09-degree-elevation/back": (
        ["(0, 0), (0, 4), (6, 6), (10, 2)", [(0, 0), (0, 4), (F(6), 6.0), (10, "4/2")]],
        [
            ("(0, 0), (0, 9/2), (11/2, 13/2), (10, 2)", "from degree 3 to degree 2"),
            ("(0, 0), (0, 3), (7, 5), (10, 2)", "left the middle point out"),
            ("(0, 0), (0, 12/5), (9/5, 21/5), (23/5, 5), (38/5, 22/5), (10, 2)", "up instead of down"),
            ("(10, 2), (6, 6), (0, 4), (0, 0)", "order is reversed"),
            ("(0, 0), (0, 4), (5, 6), (10, 2)", "3 of 4 rows"),
        ],
    ),
    "09-degree-elevation/times-t": (
        ["0, 1, 4, 2", (0, 1, 4, 2), ["0", "3/3", "2/3 * 6", F(2)]],
        [
            ((0, 3, 6, 2), "one place up"),
            ((3, 4, F(2, 3), 0), "(1 - t) p(t)"),
            ("0, 3, 4, 2/3", "the other way round"),
            ("3, 5, 14/3, 2", "the factor t is missing"),
            ("0, 3/4, 3, 3/2", "the new one is 3, not 4"),
            ("0, 1, 4, 3", "3 of 4 numbers"),
        ],
    ),
    "09-degree-elevation/loss": (
        ["1/70", F(1, 70), 1 / 70],
        [
            (1, "is dropped"),
            ("1/20", "20 belongs to a cubic"),
            (F(1, 16), "squared"),
            ("1/14", "signs"),
            ("-1/70", "not negative"),
            ("1/35", "Not this"),
        ],
    ),
    "09-degree-elevation/first": (
        ["(r b_0 + n b_1)/(n + r)", "b_0 + n/(n+r) * (b_1 - b_0)", "(1 - n/(n+r)) b0 + n/(n+r) * b1"],
        [
            ("(n b_0 + r b_1)/(n + r)", "exchanged"),
            ("1/(n+1) * b_0 + n/(n+1) * b_1", "right for r = 1"),
            ("(b_0 + (n + r - 1) b_1)/(n + r)", "the last step alone"),
            ("b_0 + (n/(n+1))^r (b_1 - b_0)", "r = 2 your formula is"),
        ],
    ),
    "09-degree-elevation/share": ([True, "true"], [("false: n = 1, i = 0", "Not so")]),
    "09-degree-elevation/smaller": (
        [(False, "n = 1, i = 1, t = 1/4"), "false: n = 2, i = 1, t = 1/10"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 1, i = 1, t = 3/4", "the statement holds"),
            ("false: n = 1, i = 2, t = 1/2", "outside"),
        ],
    ),
    "09-degree-elevation/product": (
        [
            "t (1-t) B(i,n,t)\n= t * (n+1-i)/(n+1) * B(i,n+1,t)\n= (n+1-i)/(n+1) * (i+1)/(n+2) * B(i+1,n+2,t)",
            "t (1-t) B(i,n,t)\n= C(n,i) t^(i+1) (1-t)^(n+1-i)\n"
            "= (i+1)(n+1-i)/((n+1)(n+2)) * C(n+2,i+1) t^(i+1) (1-t)^(n+1-i)\n"
            "= (i+1)(n+1-i)/((n+1)(n+2)) * B(i+1,n+2,t)",
            [
                "t (1-t) B(i,n,t)",
                "(1-t) * (i+1)/(n+1) * B(i+1,n+1,t)",
                "(i+1)/(n+1) * (1 - (i+1)/(n+2)) * B(i+1,n+2,t)",
                "(i+1)/(n+1) * (n+1-i)/(n+2) * B(i+1,n+2,t)",
            ],
        ],
        [
            ("t (1-t) B(i,n,t)\n= (i+1)(n+1-i)/((n+1)(n+2)) * B(i+1,n+2,t)", "show why"),
            (
                "t (1-t) B(i,n,t)\n= t * (n+1-i)/(n+1) * B(i,n+1,t)\n= (n+1-i)/(n+1) * (i+1)/(n+1) * B(i+1,n+2,t)",
                "Line 3 does not follow",
            ),
            ("t (1-t) B(i,n,t)\n= t * (n+1-i)/(n+1) * B(i,n+1,t)", "Go on until"),
            ("t B(i,n,t)\n= (i+1)/(n+1) * B(i+1,n+1,t)", "begin with"),
        ],
    ),
    "09-degree-elevation/disguise": (
        ["(0, 0), (0, 1), (2, 2), (6, 3)", [(0, 0), (0, F(1, 2)), (2, "3/2"), (6, 3)]],
        [
            ("(0, 0), (0, 3), (6, 3)", "four control points"),
            ("(0, 0), (0, 2), (2, 3), (6, 4)", "ends"),
            ("(0, 0), (2, 1), (4, 2), (6, 3)", "straight up"),
            ("(0, 0), (0, -1), (2, 0), (6, 3)", "straight up"),
            ("(0, 0), (0, 1), (6, 1), (6, 3)", "a true cubic"),
        ],
    ),
}
