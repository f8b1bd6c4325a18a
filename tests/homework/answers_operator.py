"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

BOOK = {
    "06-operator/look": (
        ["(7, 14)", (7, 14), [F(7), "28/2"]],
        [
            ((9, 14), "are exchanged"),
            ((3, -1), "one point too early"),
            ((-5, -4), "is not -E"),
            ((8, 4), "every term at b_2 itself"),
            ((8, 14), "a multiple of 1"),
            ((7, 13), "1 of 2 numbers"),
        ],
    ),
    "06-operator/mixed": (
        ["(2, 5)", (2, 5), [2.0, F(10, 2)]],
        [
            ((-4, 4), "g(1) is not 1"),
            ((1, F(16, 3)), "at the first parameter"),
            ("(3, 9/2)", "at the second parameter"),
            ((-1, 6), "A step is missing"),
            ((0, 6), "A step is missing"),
            ((-2, 6), "product of the parameters"),
            ("(2, 77/18)", "at the mean of the parameters"),
            ((-2, 5), "in each step"),
            ((4, 4), "g(1) is right"),
            ((2, 4), "1 of 2 numbers"),
        ],
    ),
    "06-operator/weights": (
        ["-4/9, 0, 1/3, 1/9", (F(-4, 9), 0, F(3, 9), F(1, 9)), [-4 / 9, 0, 1 / 3, "1/9"]],
        [
            ("4/9, 0, -1/3, -1/9", "signs are turned"),
            ("1/9, 1/3, 0, -4/9", "order is reversed"),
            ("-1/9, -1/3, 0, 4/9", "are exchanged"),
            ("-4/9, 2/9, 1/9, 1/9", "has a term twice"),
            ("-4/9, 4/9, -1/9, 1/9", "sum of the squares"),
            ("-2/3, 1/3, 1/3, 0", "One step is missing"),
            ("4/9, 8/9, 5/9, 1/9", "sum of two points"),
            ("-4/3, 0, 1, 1/3", "p'(t) of the cubic"),
            ("-4/9, 0, 1/3, 0", "3 of 4 numbers"),
        ],
    ),
    "06-operator/newton": (
        ["h + j v + j(j-1)/2 * w", "h + j v + C(j,2) w", "h + sum(v + i w, i, 0, j-1)", "h + j (v + (j-1)/2 * w)"],
        [
            ("h + j v + j^2/2 * w", "something falls"),
            ("h + j v + j^2 w", "how many w's are in b_1"),
            ("h + j v + j(j-1) w", "A factor is missing"),
            ("h + j v + C(j+1,2) w", "One w too early"),
            ("h + j(v + w)", "every edge"),
            ("h + j v", "w is missing"),
            ("h + j v + C(j,3) w", "your formula is"),
        ],
    ),
    "06-operator/again": (
        ["1 - s/t + s/t * x", "1 + s/t * (x - 1)", "(t - s + s x)/t", "1 - s + s (x - 1 + t)/t"],
        [
            ("(1-s) + s x", "g(s t)"),
            ("1 - t/s + t/s * x", "upside down"),
            ("s x/t", "g(0) is 1"),
            ("x + s - t", "a multiple of E - 1"),
            ("1 - s + s/t * x", "have the sum 1"),
            ("1 - s t + s t x", "your formula is"),
        ],
    ),
    "06-operator/last": (
        [
            "(1-t+t E)^k E^(n-k) b_0",
            "g(t)^k E^(n-k) b_0",
            "g(t)^k b_(n-k)",
            "E^(n-k) (1 + t(E-1))^k b[0]",
            "sum(B(i,k,t) b_(n-k+i), i, 0, k)",
            "(1-t) g(t)^(k-1) b_(n-k) + t g(t)^(k-1) b_(n-k+1)",
        ],
        [
            ("g(t)^k b_0", "first point of the level"),
            ("(1-t+t E)^(n-k) E^k b_0", "level n - k"),
            ("g(t)^k E^(n-k+1) b_0", "One shift too many"),
            ("g(t)^k E^(n-k-1) b_0", "One shift too few"),
            ("g(t)^k b_n", "begins at b_n"),
            ("g(t)^k E^k b_0", "number k of the level"),
            ("g(t)^n b_0", "the last level"),
            ("(t + (1-t) E)^k E^(n-k) b_0", "are exchanged"),
            ("E^n b_0", "your formula is"),
        ],
    ),
    "06-operator/speed": ([True, "true"], [("false: n = 1, t = 1", "Not so")]),
    "06-operator/two-steps": (
        [(False, "s = 0, t = 1"), "false: s = 3/4, t = 1/4"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: s = 1/4, t = 1/3", "the statement holds"),
            ("false: s = -1, t = 1", "outside"),
        ],
    ),
    "06-operator/ratio": (
        [
            "(1-t)(g(t)^n b_0 - g(t)^(n-1) b_0)\n= (1-t)(g(t)-1) g(t)^(n-1) b_0\n= (1-t) t (E-1) g(t)^(n-1) b_0\n"
            "= t (E-g(t)) g(t)^(n-1) b_0\n= t(g(t)^(n-1) b_1 - g(t)^n b_0)",
            "(1-t)((1-t+t E)^n b_0 - (1-t+t E)^(n-1) b_0)\n= t (1-t) (E-1) (1-t+t E)^(n-1) b_0\n"
            "= t ((1-t+t E)^(n-1) b_1 - (1-t+t E)^n b_0)",
            [
                "(1-t)(g(t)^n b_0 - g(t)^(n-1) b_0)",
                "g(t)^n b_0 - t g(t)^n b_0 - (1-t) g(t)^(n-1) b_0",
                "(1-t) g(t)^(n-1) b_0 + t g(t)^(n-1) b_1 - t g(t)^n b_0 - (1-t) g(t)^(n-1) b_0",
                "t(g(t)^(n-1) b_1 - g(t)^n b_0)",
            ],
        ],
        [
            ("(1-t)(g(t)^n b_0 - g(t)^(n-1) b_0)\n= t(g(t)^(n-1) b_1 - g(t)^n b_0)", "show why"),
            (
                "(1-t)(g(t)^n b_0 - g(t)^(n-1) b_0)\n= (1-t) t E g(t)^(n-1) b_0\n= t(g(t)^(n-1) b_1 - g(t)^n b_0)",
                "Line 2 does not follow",
            ),
            ("(1-t)(g(t)^n b_0 - g(t)^(n-1) b_0)\n= t (1-t) (E-1) g(t)^(n-1) b_0", "Go on until"),
            ("g(t)^n b_0\n= g(t)^(n-1) ((1-t) b_0 + t b_1)", "begin with"),
        ],
    ),
    "06-operator/turn": (
        ["(0, 0), (4, 8), (0, 0), (-4, -8)", [(1, 1), (5, 9), (-1, -1), (-5, -9)]],
        [
            ("(0, 0), (4, 8), (0, 0)", "Four control points"),
            ("(0, 0), (0, 0), (0, 0), (0, 0)", "p(1/2) is somewhere else"),
            ("(4, 8), (-4, -8), (4, 8), (-4, -8)", "To which points does E^2 lead"),
            ("(0, 0), (1, 2), (0, 0), (-1, -2)", "p(1/2) is somewhere else"),
        ],
    ),
}
