"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

BOOK = {
    "05-de-casteljau/triangle": (
        [
            "(-9/2, 9/2), (3/2, 6), (15/2, 3/2), (0, 45/8), (6, 21/8), (9/2, 27/8)",
            [(-4.5, 4.5), (1.5, 6), (7.5, 1.5), (0, 5.625), (6, F(21, 8)), ("9/2", "27/8")],
        ],
        [
            ("(-15/2, 3/2), (-3/2, 6), (9/2, 9/2), (-6, 21/8), (0, 45/8), (-9/2, 27/8)", "are exchanged"),
            ("(-6, 3), (0, 6), (6, 3), (-3, 9/2), (3, 9/2), (0, 9/2)", "middles of the edges"),
            ("(-9/2, 9/2), (0, 45/8), (9/2, 27/8), (3/2, 6), (6, 21/8), (15/2, 3/2)", "level by level"),
            ("(15/2, 3/2), (3/2, 6), (-9/2, 9/2), (6, 21/8), (0, 45/8), (9/2, 27/8)", "b_0^k comes first"),
            (
                "(-9, 0), (-3, 6), (3, 6), (9, 0), "
                "(-9/2, 9/2), (3/2, 6), (15/2, 3/2), (0, 45/8), (6, 21/8), (9/2, 27/8)",
                "six new ones",
            ),
            ([(F(9, 2), F(27, 8))], "the curve alone"),
            ("(-9/2, 9/2), (3/2, 6), (15/2, 3/2), (0, 45/8), (6, 3), (9/2, 27/8)", "5 of 6 rows"),
        ],
    ),
    "05-de-casteljau/program": (
        ["28/3, 14, 24, 18", (F(28, 3), 14, 24, 18), [28 / 3, 14.0, "24", 18]],
        [
            ((9, 6, 7, F(28, 3)), "first numbers of the levels"),
            ("18, 24, 14, 28/3", "order is reversed"),
            ("53/3, 20, 21, 18", "are exchanged"),
            ("304/27, 40/3, 24, 18", "ran backwards"),
            ("28/3, 50/3, 62/3, 18", "equally long"),
            ("28/3, 0, 27, 18", "the other places were written over"),
            ((6, 9, 24, 18), "one round"),
            ("28/3, 14, 24, 0", "3 of 4 numbers"),
        ],
    ),
    "05-de-casteljau/outside": (
        ["(-4, 2)", (-4, 2), [F(-8, 2), "6/3"]],
        [
            ((-4, 5), "are exchanged"),
            ((0, 1), "stopped at the end"),
            ((4, 10), "A sign was lost"),
            ((-1, 1), "first edge"),
            ((2, 0), "second edge"),
            ((0.5, 0.5), "middle in the last step"),
            ((-4, 3), "1 of 2 numbers"),
        ],
    ),
    "05-de-casteljau/back": (
        ["(15, 3)", (15, 3), ["45/3", 3.0]],
        [
            ((3, 6), "This is b_1,"),
            ((7, 5), "This is b_1^1"),
            ("(21/4, 15/4)", "are exchanged"),
            ((24, 0), "on from its end"),
            ("(7/9, 11/9)", "go outwards"),
            ((15, 2), "1 of 2 numbers"),
        ],
    ),
    "05-de-casteljau/rounds": (
        ["k n - k(k-1)/2", "k(2n-k+1)/2", "n(n+1)/2 - (n-k)(n-k+1)/2", "sum(n+1-r, r, 1, k)", "C(n+1,2) - C(n-k+1,2)"],
        [
            ("n k", "not equally long"),
            ("n(n+1)/2", "all n rounds"),
            ("sum(r, r, 1, k)", "the last k rounds"),
            ("(n-k)(n-k+1)/2", "still to be done"),
            ("k(n + n-k)/2", "times a mean"),
            ("k(2n-k+1)", "multiplications"),
            ("k n - k(k+1)/2", "one is missing"),
            ("(k+1)(n+1) - k(k+1)/2", "Level 0 is given"),
            ("k(n-k)", "your formula is"),
        ],
    ),
    "05-de-casteljau/share": (
        [
            "B(i-j, k, t)",
            "C(k,i-j) t^(i-j) (1-t)^(k-i+j)",
            "(1-t) B(i-j,k-1,t) + t B(i-j-1,k-1,t)",
            "k!/((i-j)! (k-i+j)!) * t^(i-j) (1-t)^(k-i+j)",
            "C(k,k+j-i) t^(i-j) (1-t)^k (1-t)^(j-i)",
        ],
        [
            ("B(i,k,t)", "from b_0 on"),
            ("C(j+k,i) t^i (1-t)^(j+k-i)", "weight in b_0^(j+k)"),
            ("C(k,i-j) (1-t)^(i-j) t^(k-i+j)", "are exchanged"),
            ("t^(i-j) (1-t)^(k-i+j)", "one way through the triangle"),
            ("B(i-j,k-1,t)", "level k - 1"),
            ("B(i+j,k,t)", "Test it with i = j"),
            ("C(k,i) t^(i-j) (1-t)^(k-i+j)", "your formula is"),
        ],
    ),
    "05-de-casteljau/half": ([True, "true"], [("false: n = 1", "Not so")]),
    "05-de-casteljau/heavier": (
        [(False, "n = 2, i = 1, t = 3/4"), "false: n = 3, i = 1, t = 1/2"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 2, i = 1, t = 1/4", "the statement holds"),
            ("false: n = 2, i = 0, t = 1/2", "outside"),
        ],
    ),
    "05-de-casteljau/even": (
        [
            "sum((j+i) B(i,k,t), i, 0, k)\n= j sum(B(i,k,t), i, 0, k) + sum(i B(i,k,t), i, 0, k)\n"
            "= j + sum(i B(i,k,t), i, 0, k)\n= j + k t",
            "sum((j+i) B(i,k,t), i, 0, k)\n= j + sum(i C(k,i) t^i (1-t)^(k-i), i, 1, k)\n"
            "= j + sum(k C(k-1,i-1) t^i (1-t)^(k-i), i, 1, k)\n"
            "= j + k t sum(C(k-1,i) t^i (1-t)^(k-1-i), i, 0, k-1)\n= j + k t ((1-t) + t)^(k-1)\n= j + k t",
            [
                "sum((j+i) B(i,k,t), i, 0, k)",
                "sum((j+i) ((1-t) B(i,k-1,t) + t B(i-1,k-1,t)), i, 0, k)",
                "(1-t) sum((j+i) B(i,k-1,t), i, 0, k-1) + t sum((j+1+i) B(i,k-1,t), i, 0, k-1)",
                "(1-t) (j + (k-1) t) + t (j + 1 + (k-1) t)",
                "j + k t",
            ],
        ],
        [
            ("sum((j+i) B(i,k,t), i, 0, k)\n= j + k t", "show why"),
            ("sum((j+i) B(i,k,t), i, 0, k)\n= j + sum(i B(i,k,t), i, 0, k)\n= j + k t", "show why"),
            (
                "sum((j+i) B(i,k,t), i, 0, k)\n= j + sum(i B(i,k,t), i, 0, k)\n"
                "= j + sum(k B(i-1,k-1,t), i, 1, k)\n= j + k t",
                "Line 3 does not follow",
            ),
            ("sum((j+i) B(i,k,t), i, 0, k)\n= j + sum(i B(i,k,t), i, 0, k)", "Go on until"),
            ("sum(i B(i,k,t), i, 0, k)\n= k t", "begin with"),
        ],
    ),
    "05-de-casteljau/tangent": (
        [
            "(0, 0), (3, 3), (6, 6), (0, -9)",
            [(0, 0), (1, 2), (14, 10), (-24, -21)],
            "(0, 0), (2, 3), (10, 6), (-12, -9)",
        ],
        [
            ("(0, 0), (3, 3), (6, 6)", "four control points"),
            ("(1, 0), (3, 3), (6, 6), (0, -9)", "does not start"),
            ("(0, 0), (2, 2), (5/2, 5/2), (6, 15/4)", "At 1 - t"),
            ("(0, 0), (3, 3), (24, 15), (-90, -54)", "wrong order"),
            ("(0, 0), (3, 3), (6, 7), (0, -9)", "b_0^2 is somewhere else"),
            ("(0, 0), (3, 3), (6, 6), (0, 0)", "b_1^2 is somewhere else"),
        ],
    ),
}
