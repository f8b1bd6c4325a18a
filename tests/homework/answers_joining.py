"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

GIVEN = "n(n-1)((1+r)^2 b[n] - 2r(1+r) b[n-1] + r^2 b[n-2] - 2(b[n] + r(b[n] - b[n-1])) + b[n])/r^2"
GOAL = "n(n-1)(b[n] - 2b[n-1] + b[n-2])"

BOOK = {
    "10-joining/unlike": (
        ["(9, 0), (17, -8), (29, -32)", [(9, 0), (17.0, -8), (F(29), "-32")]],
        [
            ("(9, 0), (21, -12), (45, -72)", "So the degrees were equal"),
            ("(9, 0), (13, -4), (18, -12)", "not equally long"),
            ("(9, 0), (11, -2), (53/4, -5)", "The intervals enter the other way round"),
            ("(9, 0), (27, -18), (81, -180)", "The degrees enter the other way round"),
            ("(9, 0), (17, -8), (27, -24)", "divided by the length twice"),
            ("(9, 0), (17, -8), (91/3, -112/3)", "not n^2"),
            ("(9, 0), (17, -8), (25, -16)", "straight on"),
            ("(9, 0), (17, -8), (29, 32)", "2 of 3 rows"),
        ],
    ),
    "10-joining/bend": (
        [9, "9", 9.0, "4 * (3/2)^2"],
        [
            (4, "two equal edges"),
            (6, "enter, but not so"),
            ("16/9", "the other way round"),
            (13.5, "above stands an area"),
            (-9, "turns left on one side"),
            (5, "Not this"),
        ],
    ),
    "10-joining/middle": (
        ["(39/8, 35/8)", (4.875, F(35, 8)), "(5 - 1/8, 4 + 3/8)"],
        [
            ((5, 4), "the neighbours enter"),
            ("(21/4, 13/4)", "the data for the control points"),
            ("(19/4, 19/4)", "too far away"),
            ("(37/8, 41/8)", "Half of the chord"),
            ("(41/8, 29/8)", "wrong sides"),
            ("(29/6, 9/2)", "between the inner control points"),
            ("(39/8, 4)", "1 of 2 numbers"),
        ],
    ),
    "10-joining/natural": (
        ["11/2, 1, -7/2", (5.5, 1, -3.5), [F(11, 2), "1", F(-7, 2)]],
        [
            ((4, 1, -2), "the one-sixth rule"),
            ("11/6, 1/3, -7/6", "edges of the control polygons"),
            ("0, 3/2, 0", "at the ends to 0"),
            ((7, 1, -5), "one parabola"),
            ("-7/2, 1, 11/2", "order is reversed"),
            ("11/2, 1, -3", "2 of 3 numbers"),
        ],
    ),
    "10-joining/jump": (
        ["y_0 - 2y_1 + 2y_3 - y_4", "(2y[1] - 5y[2] + 4y[3] - y[4]) - (-y[0] + 4y[1] - 5y[2] + 2y[3])"],
        [
            ("y_4 - 2y_3 + 2y_1 - y_0", "left side minus the right"),
            ("2y_1 - 5y_2 + 4y_3 - y_4", "derivative on the right"),
            ("-y_0 + 4y_1 - 5y_2 + 2y_3", "derivative on the left"),
            ("-y_0 + 6y_1 - 10y_2 + 6y_3 - y_4", "added the two sides"),
            ("(y_0 - 2y_1 + 2y_3 - y_4)/6", "A factor is missing"),
            (0, "makes the velocity go on"),
            ("y_0 - 4y_1 + 6y_2 - 4y_3 + y_4", "your formula is"),
        ],
    ),
    "10-joining/third": (
        [
            "8b[n] - 12b[n-1] + 6b[n-2] - b[n-3]",
            "3(4b[n] - 4b[n-1] + b[n-2]) - 3(2b[n] - b[n-1]) + b[n] + b[n] - 3b[n-1] + 3b[n-2] - b[n-3]",
        ],
        [
            ("7b[n] - 9b[n-1] + 3b[n-2]", "third difference is 0"),
            ("6b[n] - 6b[n-1] + b[n-3]", "the other sign"),
            ("6b[n] - 7b[n-1] + 2b[n-2]", "in one line"),
            ("2b[n] - b[n-3]", "half a turn"),
            ("4b[n] - 4b[n-1] + b[n-2]", "This is c_2"),
            ("b[n]", "your formula is"),
        ],
    ),
    "10-joining/raised": ([True, "true"], [("false: n = 1, x = 0, y = 2", "Not so")]),
    "10-joining/half-turn": (
        [(False, "x = 0, y = 0, z = 1"), "false: x = 1, y = 2, z = 2"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: x = 0, y = 1, z = 2", "the statement holds"),
            ("false: x = 0, y = 1", "a number for each of z"),
        ],
    ),
    "10-joining/clock": (
        [
            f"{GIVEN}\n= n(n-1)((1+2r+r^2) b[n] - 2r b[n-1] - 2r^2 b[n-1] + r^2 b[n-2] - 2b[n] - 2r b[n] + 2r b[n-1] "
            f"+ b[n])/r^2\n= n(n-1)(r^2 b[n] - 2r^2 b[n-1] + r^2 b[n-2])/r^2\n= {GOAL}",
            [GIVEN, "n(n-1) r^2 (b[n] - 2b[n-1] + b[n-2])/r^2", GOAL],
        ],
        [
            (f"{GIVEN}\n= {GOAL}", "show why"),
            ([GIVEN, "n(n-1)(r^2 b[n] - 2r b[n-1] + r^2 b[n-2])/r^2", GOAL], "Line 2 does not follow"),
            ([GIVEN, "n(n-1)(r^2 b[n] - 2r^2 b[n-1] + r^2 b[n-2])/r^2"], "Go on until"),
            ([GOAL, GIVEN], "begin with"),
        ],
    ),
    "10-joining/seam": (
        ["(3, 3), (7/2, 4), (4, 6), (8, 4)", [(3, 3), (5, 7), (7, 27), (8, 4)], "(3, 3), (7/2, 4), (5, 8), (8, 4)"],
        [
            ("(3, 3), (7/2, 4), (8, 4)", "four control points"),
            ("(3, 2), (7/2, 4), (4, 6), (8, 4)", "ends"),
            ("(3, 3), (2, 1), (4, 6), (8, 4)", "a corner"),
            ("(3, 3), (3, 3), (4, 6), (8, 4)", "a corner, or no tangent"),
            ("(3, 3), (4, 5), (5, 11), (8, 4)", "it is C1"),
            ("(3, 3), (7/2, 4), (5, 7), (8, 4)", "the curvature jumps"),
        ],
    ),
}
