"""By hand, for the book's numbers: right answers in several forms, then wrong ones and some of what is said to each."""

from fractions import Fraction as F

START, GOAL = "diff(B(i,n,t), t, 2)", "n(n-1)(B(i-2,n-2,t) - 2B(i-1,n-2,t) + B(i,n-2,t))"
ONCE = "n(diff(B(i-1,n-1,t), t) - diff(B(i,n-1,t), t))"
BOOK = {
    "07-derivatives/velocity": (
        ["(18, -9)", [18, -9], (18.0, F(-9))],
        [
            ((6, -3), "the factor before it is missing"),
            ((-18, 9), "points backwards"),
            ((12, -6), "the number of the level"),
            ((24, -12), "the number of its points"),
            ((18, 9), "t and 1 - t"),
            ("(9/2, 27/8)", "where the curve is"),
            ((18, 0), "1 of 2 numbers"),
        ],
    ),
    "07-derivatives/from-end": (
        ["(3, 7)", (3, 7), [F(3), "7"]],
        [
            ((3, 4), "This is b_3"),
            ((4, 5), "not the edge from b_3 to b_2"),
            ((7, -1), "going on from the end"),
            ((8, 30), "factors are missing"),
            ("(11/4, 27/4)", "not n^2"),
            ((5, 9), "one is missing"),
            ((1, 5), "the other sign"),
            ((2, 6), "was not used"),
            ((0, 0), "None of the 2 numbers"),
        ],
    ),
    "07-derivatives/curvature": (
        ["32/375", F(32, 375), 32 / 375],
        [
            ("-32/375", "The sign"),
            ("16/125", "(n - 1)/n is missing"),
            ("12/125", "not the number of the points"),
            ("16/375", "the triangle"),
            ("32/75", "not its square"),
            ("1/6", "the edge at the end"),
            ("-8/27", "at t = 0"),
            (1, "Not this"),
        ],
    ),
    "07-derivatives/highest": (
        ["(32/9, 11/3)", (F(32, 9), F(11, 3)), [32 / 9, 11 / 3]],
        [
            ((2, 5), "highest control point"),
            ("(5/2, 7/2)", "the point at t = 1/2"),
            ("(14/9, 3)", "t and 1 - t"),
            ("(4/3, 11/3)", "on the first edge"),
            ("(14/3, 11/3)", "on the second edge"),
            ("(32/9, 4)", "1 of 2 numbers"),
        ],
    ),
    "07-derivatives/third": (
        [
            "n(n-1)(n-2)(b_n - 3b_{n-1} + 3b_{n-2} - b_{n-3})",
            "n!/(n-3)! * (b[n] - 3b[n-1] + 3b[n-2] - b[n-3])",
            "n(n-1)(n-2)((b[n] - 2b[n-1] + b[n-2]) - (b[n-1] - 2b[n-2] + b[n-3]))",
        ],
        [
            ("n(n-1)(n-2)(b[n-3] - 3b[n-2] + 3b[n-1] - b[n])", "must count positive"),
            ("6(b[n] - 3b[n-1] + 3b[n-2] - b[n-3])", "that of cubics"),
            ("n(b[n] - 3b[n-1] + 3b[n-2] - b[n-3])", "of the first derivative"),
            ("n(n-1)(b[n] - 3b[n-1] + 3b[n-2] - b[n-3])", "of the second derivative"),
            ("n^3 (b[n] - 3b[n-1] + 3b[n-2] - b[n-3])", "falls by one"),
            ("b[n] - 3b[n-1] + 3b[n-2] - b[n-3]", "The factor is missing"),
            ("n(n-1)(n-2)(b[n] - 3b[n-1] + 3b[n-2] + b[n-3])", "must be 0"),
            ("n(n-1)(n-2)(b[3] - 3b[2] + 3b[1] - b[0])", "p'''(0)"),
            ("b[n] - b[n-1]", "your formula is"),
        ],
    ),
    "07-derivatives/integrate": (
        ["h + (u+v+w)/n", "h + u/n + v/n + w/n", "(n*h + u + v + w)/n"],
        [
            ("h + u + v + w", "longer than the edges"),
            ("h + n(u + v + w)", "multiplied by n"),
            ("h + (u+v+w)/3", "not the number of edges"),
            ("h + (u+v+w)/(n-1)", "that of the hodograph"),
            ("(u+v+w)/n", "From which height"),
            ("h + w/n", "one edge"),
            ("h", "your formula is"),
        ],
    ),
    "07-derivatives/steady": ([True, "true"], [("false: n = 1, t = 1", "Not so"), (False, "Not so")]),
    "07-derivatives/area": (
        [(False, "n = 3, i = 0"), "false: n = 1, i = 1"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ((False, "n = 2, i = 1"), "there the statement holds"),
            ((False, "n = 2, i = 3"), "outside"),
        ],
    ),
    "07-derivatives/basis-second": (
        [
            [START, ONCE, "n(n-1)(B(i-2,n-2,t) - B(i-1,n-2,t)) - n(n-1)(B(i-1,n-2,t) - B(i,n-2,t))", GOAL],
            f"{START}\n= diff(n(B(i-1,n-1,t) - B(i,n-1,t)), t)\n= {ONCE}\n= {GOAL}",
        ],
        [
            (f"{START}\n= {GOAL}", "at least 2"),
            (f"{START}\n= {ONCE}\n= {GOAL}", "at least 2"),
            (
                f"{START}\n= {ONCE}\n= n(n(B(i-2,n-2,t) - B(i-1,n-2,t)) - n(B(i-1,n-2,t) - B(i,n-2,t)))\n= {GOAL}",
                "Line 3 does not follow from line 2",
            ),
            (f"{START}\n= {ONCE.replace('-', '+', 3)}\n= {GOAL}", "Line 2 does not follow"),
            (f"{START}\n= {ONCE}", "Go on until"),
            (f"{GOAL}\n= {ONCE}\n= {START}", "begin with"),
        ],
    ),
    "07-derivatives/straight-end": (
        ["(0, 0), (1, 2), (7/2, 1), (6, 0)", [(0, 0), (1, 2), (2, F(8, 5)), (6, 0)], "[(0,0),(1,2),(-4,4),(6,0)]"],
        [
            ("(0, 0), (1, 2), (6, 0)", "four control points"),
            ("(0, 0), (1, 2), (7/2, 3/2), (6, 1)", "The ends"),
            ("(0, 0), (3, 6), (9/2, 3), (6, 0)", "p'(0) is another vector"),
            ("(0, 0), (1, 2), (6, 0), (6, 0)", "the velocity is 0"),
            ("(0, 0), (1, 2), (4, 0), (6, 0)", "the curvature is not 0"),
        ],
    ),
}
