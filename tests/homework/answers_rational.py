"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

HALF = """((1-t)^2 - t^2)^2 + (2t(1-t))^2
= (1-t)^4 - 2t^2 (1-t)^2 + t^4 + 4t^2 (1-t)^2
= (1-t)^4 + 2t^2 (1-t)^2 + t^4
= ((1-t)^2 + t^2)^2"""
BOOK = {
    "12-ahead-rational/level": (
        ["(2, 2), (5, 1), (4, 4/3)", [(2, 2.0), ("5", 1), (4, F(4, 3))]],
        [
            ("(3/2, 3/2), (9/2, 3/2), (3, 3/2)", "equal weights"),
            ("(3, 3), (15, 3), (9, 3)", "X and Y of points in space"),
            ("(2, 2), (5, 1), (7/2, 3/2)", "not midway"),
            ("(1, 1), (4, 2), (2, 4/3)", "the smaller weights"),
            ("(5, 1), (2, 2), (4, 4/3)", "changed places"),
            ("(2, 2), (5, 1), (4, 1)", "2 of 3 rows"),
        ],
    ),
    "12-ahead-rational/raised": (
        [
            "(1, 0, 1), (1, 2/3, 1), (1/2, 1, 4/3), (0, 1, 2)",
            [(1, 0, 1), (1, F(2, 3), 1), (0.5, 1, F(4, 3)), (0, 1, 2)],
        ],
        [
            ("(1, 0, 1), (1, 2/3, 1), (2/3, 1, 4/3), (0, 1, 2)", "those of equal weights"),
            ("(1, 0, 1), (1, 2/3, 1), (2/3, 4/3, 4/3), (0, 2, 2)", "the points in space"),
            ("(1, 0, 1), (1, 2/3, 1), (1/2, 1, 1), (0, 1, 1)", "a weight of its own"),
            ("(1, 0, 1), (1, 1/3, 1), (1/5, 1, 5/3), (0, 1, 2)", "are exchanged"),
            ("(1, 0), (1, 2/3), (1/2, 1), (0, 1)", "4 rows of 3 numbers"),
            ("(1, 0, 1), (1, 2/3, 1), (1/2, 1, 5/3), (0, 1, 2)", "3 of 4 rows"),
        ],
    ),
    "12-ahead-rational/half-turn": (
        ["(3, 4)", [3, 4], "(5/3 / (5/9), 20/9 / (5/9))"],
        [
            ("(5/3, 20/9)", "Divide by W, which"),
            ("(5/6, 10/9)", "the sum of the weights"),
            ((3, 2), "has a factor more"),
            ((3, 0), "left the middle point out"),
            ((-3, 4), "exchanged"),
            ((3, 5), "1 of 2 numbers"),
        ],
    ),
    "12-ahead-rational/arc": (
        ["3/5", F(3, 5), 0.6],
        [
            ("3/8", "not w"),
            ("3/2", "how high the curve rises"),
            ("5/3", "Upside down"),
            ("4/5", "the height over a leg"),
            ("3/4", "their length enters"),
            ("9/25", "w_1^2"),
            ("1/sqrt(2)", "a right angle"),
            (1, "Not this"),
        ],
    ),
    "12-ahead-rational/end-velocity": (
        [
            "n u/v * (b[n] - b[n-1])",
            "n (b_n - b_(n-1)) u/v",
            "n*u*b[n]/v - n*u*b[n-1]/v",
            r"\frac{n u}{v} (b_n - b_{n-1})",
        ],
        [
            ("n (b[n] - b[n-1])", "for equal weights"),
            ("n v/u * (b[n] - b[n-1])", "Upside down"),
            ("n u/v * (b[n-1] - b[n])", "The sign"),
            ("u/v * (b[n] - b[n-1])", "n is missing"),
            ("n u (b[n] - b[n-1])", "must change nothing"),
            ("n (v b[n] - u b[n-1])", "the velocity in space"),
            ("n (b[n] - u/v * b[n-1])", "a second term"),
            ("n u^2/v * (b[n] - b[n-1])", "your formula is"),
        ],
    ),
    "12-ahead-rational/line": (
        ["2t + (n-1) t^2", "t (2 + (n-1) t)", "(n(n-1) t^2 + 2 n t)/n"],
        [
            ("t (1 + n t)", "the square of the mean"),
            ("t", "for equal weights"),
            ("t + (n-1) t^2", "Your weights are"),
            ("2n t + n(n-1) t^2", "not i"),
            ("1 + n t", "This is W"),
            ("sum((i+1) i/n * B(i,n,t), i, 0, n)", "not without a sum"),
            ("2t + n t^2", "your formula is"),
        ],
    ),
    "12-ahead-rational/strongest": ([True, "true"], [("false: w = 1, t = 1/4", "Not so"), (False, "Not so")]),
    "12-ahead-rational/denominator": (
        [(False, "w = -1, t = 1/2"), "false: w = -1/2, t = 1/2", (False, "t = 1/3, w = -3/4")],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: w = -1/3, t = 1/2", "the statement holds"),
            ("false: w = -2, t = 1/2", "outside"),
        ],
    ),
    "12-ahead-rational/half-circle": (
        [
            HALF,
            ["((1-t)^2 - t^2)^2 + (2t(1-t))^2", "(1-2t)^2 + (2t-2t^2)^2", "(1-2t+2t^2)^2", "((1-t)^2 + t^2)^2"],
        ],
        [
            ("((1-t)^2 - t^2)^2 + (2t(1-t))^2\n= ((1-t)^2 + t^2)^2", "show why"),
            (HALF.replace("4t^2", "2t^2"), "Line 2 does not follow"),
            (HALF.replace("+ 2t^2", "+ 6t^2"), "Line 3 does not follow"),
            ("\n".join(HALF.splitlines()[:3]), "Go on until"),
            ("\n= ".join(HALF.split("\n= ")[::-1]), "begin with"),
        ],
    ),
    "12-ahead-rational/round": (
        [
            "(5, 1), (5, 4), (2, 4)",
            [(2, 4), (-1, 4), (-1, 1)],
            "(2 + 9/5, 1 + 12/5), (2 - 3/5, 1 + 21/5), (2 - 12/5, 1 + 9/5)",
        ],
        [
            ("(5, 1), (2, 4)", "three control points"),
            ("(1, 0), (1, 1), (0, 1)", "Are both on the circle"),
            ("(5, 1), (6, 5), (2, 4)", "is not"),
            ("(5, 1), (5, -2), (2, -2)", "the other way round"),
            ("(5, 1), (5, 1), (5, 1)", "not round at all"),
        ],
    ),
}
