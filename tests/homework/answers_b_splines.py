"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

MEANS = "(x+h-v)/h * (x+s)/p + (v-x)/h * (s+x+h)/p"

BOOK = {
    "11-b-splines/knots": (
        ["0, 0, 0, 0, 1, 2, 2, 2, 4, 4, 5, 5, 5, 5", [0, 0, 0, 0, 1, 2, 2.0, 2, "8/2", 4, 5, 5, F(5), 5]],
        [
            ("0, 0, 0, 0, 1, 1, 1, 2, 4, 4, 5, 5, 5, 5", "other way round"),
            ("0, 0, 0, 0, 1, 1, 2, 2, 2, 2, 4, 4, 4, 5, 5, 5, 5", "once too often"),
            ("0, 0, 0, 0, 1, 2, 4, 5, 5, 5, 5", "C2 is sure at each of them"),
            ("0, 0, 0, 1, 2, 2, 2, 4, 4, 5, 5, 5", "by the order"),
            ("0, 1, 2, 2, 2, 4, 4, 5", "stand more than once"),
            ("0, 0, 0, 0, 1, 2, 2, 4, 4, 4, 5, 5, 5, 5", "13 of 14"),
            ("0, 0, 0, 0, 1, 2, 2, 4, 4, 5, 5, 5, 5", "14 numbers"),
        ],
    ),
    "11-b-splines/count": (
        ["k(p - r) + p + 1", "(k + 1)(p - r) + r + 1", "2(p + 1) + k p - k r - (p + 1)"],
        [
            ("k(p - r) + 2p + 2", "the number of knots"),
            ("k(p - r) + p + 2", "one is still too many"),
            ("p + k(p - r)", "the last index"),
            ("k r + p + 1", "not the class"),
            ("k(p - r + 1) + p + 1", "once too often"),
            ("k + p + 1", "simple inner knots"),
            ("k(p - r)", "your formula is"),
        ],
    ),
    "11-b-splines/piece": (
        ["-5/6 * t^2 + 4t - 4", "4t - 4 - 5t^2/6"],
        [
            ("t(3-t)/3 + (4-t)(t-2)/2", "not multiplied out"),
            ("t - t^2/3", "one of the two terms"),
            ("(4-t)(t-2)/2", "one of the two terms"),
            ("t^2/6", "another span"),
            ("(4-t)^2/2", "another span"),
            ("t(3-t)/2 + (4-t)(t-2)", "over one"),
            ("(3-t)^2/3 + (t-2)^2/2", "exchanged"),
            ("1", "your formula is 1"),
        ],
    ),
    "11-b-splines/de-boor": (
        ["(6, 33/8)", (6, F(33, 8)), [6, 4.125]],
        [
            ("(6, 9/2)", "its own clock"),
            ("(6, 41/8)", "weights are exchanged"),
            ("(81/16, 5)", "nearer to each other"),
            ("(17/8, 45/8)", "wrong points"),
            ("(21/4, 19/4)", "second level"),
            ("(27/4, 7/2)", "second level"),
            ("(6, 4)", "1 of 2 numbers"),
        ],
    ),
    "11-b-splines/again": (
        [
            "(0, 0), (0, 4), (2, 6), (16/3, 16/3), (8, 0), (12, 8), (12, 0)",
            [(0, 0), (0, 4), (2, 6), (F(16, 3), "4 + 4/3"), (8, 0), (12, 8), (12, 0)],
        ],
        [
            ("(0, 0), (0, 4), (2, 6), (20/3, 8/3), (8, 0), (12, 8), (12, 0)", "exchanged"),
            ("(0, 0), (0, 4), (2, 6), (6, 4), (8, 0), (12, 8), (12, 0)", "not alike"),
            ("(0, 0), (0, 4), (2, 6), (4, 8), (16/3, 16/3), (8, 0), (12, 8), (12, 0)", "An old corner"),
            ("(2, 6), (16/3, 16/3)", "belong to the curve, too"),
            ("(0, 0), (0, 4), (4, 8), (20/3, 8/3), (10, 4), (12, 8), (12, 0)", "other inner knot"),
            ("(0, 0), (0, 4), (2, 6), (16/3, 16/3), (8, 0), (12, 4), (12, 0)", "6 of 7 rows"),
        ],
    ),
    "11-b-splines/back": (
        ["(-3, -19), (0, 5), (3, -1), (6, 17)", [(-3, -19), (0, F(5)), ("6/2", -1.0), (6, 17)]],
        [
            ("(0, 0), (1, 3), (2, 1), (3, 3)", "These are the Bézier points"),
            ("(1, 13/6), (4/3, 7/3), (5/3, 5/3), (2, 5/3)", "for control points"),
            ("(-1, -3), (0, 5), (3, -1), (4, 5)", "f(2, 3, 3)"),
            ("(-2, -11), (0, 5), (3, -1), (5, 11)", "f(2, 2, 3)"),
            ("(6, 17), (3, -1), (0, 5), (-3, -19)", "order is reversed"),
            ("(-3, -19), (0, 5), (3, -1), (6, 1)", "3 of 4 rows"),
        ],
    ),
    "11-b-splines/graph": (
        [
            "(0, 0), (1/2, -1), (3/2, -1), (5/2, 1), (7/2, 5), (4, 8)",
            [(0, 0), (F(1, 2), -1), (1.5, -1), ("5/2", 1), ("7/2", 5), (4, 8)],
        ],
        [
            ("(0, 0), (1/2, -3/4), (3/2, -3/4), (5/2, 5/4), (7/2, 21/4), (4, 8)", "lie on the parabola"),
            ("(0, 0), (1, -1), (2, 0), (3, 3), (4, 8)", "at the knots"),
            ("(0, 0), (0, 0), (1/2, -1), (3/2, -1), (5/2, 1), (7/2, 5)", "too early"),
            ("(0, 0), (1/2, -2), (3/2, -4), (5/2, -4), (7/2, -2), (4, 0)", "the mean of u and v"),
            ("(0, 0), (1, -1), (3, -1), (5, 1), (7, 5), (8, 8)", "the mean of u and v"),
            ("(0, 0), (1/2, -1), (3/2, -1), (5/2, 1), (7/2, 6), (4, 8)", "5 of 6 rows"),
        ],
    ),
    "11-b-splines/middle": ([True, "true"], [("false: p = 1, i = 0", "Not so")]),
    "11-b-splines/reach": (
        [(False, "p = 2, n = 2"), "false: p = 3, n = 4"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: p = 1, n = 1", "the statement holds"),
            ("false: p = 3, n = 2", "outside"),
        ],
    ),
    "11-b-splines/means": (
        [
            f"{MEANS}\n= ((x+h-v)(x+s) + (v-x)(s+x+h))/(h p)\n= (h s + h v)/(h p)\n= (s+v)/p",
            f"{MEANS}\n= (x+s)/p + (v-x)/h * ((s+x+h)/p - (x+s)/p)\n= (x+s)/p + (v-x)/p\n= (s+v)/p",
            [MEANS, "1/p * (s (x+h-v+v-x)/h + (x*(x+h-v) + (x+h)(v-x))/h)", "(s+v)/p"],
        ],
        [
            (f"{MEANS}\n= (s+v)/p", "show why"),
            (f"{MEANS}\n= (x+s)/p + (v-x)/h * (h+s)/p\n= (s+v)/p", "Line 2 does not follow"),
            (f"{MEANS}\n= (x+s)/p + (v-x)/h * h/p\n= (x+s)/p + (v-x)/p", "Go on until"),
            ("(x+s)/p + (v-x)/p\n= (s+v)/p", "begin with"),
        ],
    ),
}
