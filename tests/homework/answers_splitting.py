"""By hand, for the book's numbers: right answers in several forms, then wrong ones and some of what is said to each."""

from fractions import Fraction as F

BOOK = {
    "08-splitting/point": (
        ["(1, 5/3)", (1, F(5, 3)), [1, 5 / 3]],
        [((2, 2), "t and 1 - t"), ((F(4, 3), F(7, 3)), "first level"), ("(2/3, 13/9)", "second level")],
    ),
    "08-splitting/left": (
        ["(0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3)", [(0, 0), (F(1, 3), 1), ("2/3", "13/9"), (1, F(5, 3))]],
        [
            ("(1, 5/3), (2/3, 13/9), (1/3, 1), (0, 0)", "order is reversed"),
            ("(1, 5/3), (5/3, 19/9), (7/3, 5/3), (3, 3)", "the other half"),
            ("(0, 0), (2/3, 2), (4/3, 16/9), (2, 2)", "t and 1 - t"),
            ("(1/3, 1), (4/3, 7/3), (7/3, 5/3)", "one level of the triangle"),
            ("(0, 0), (1/3, 1), (2/3, 1), (1, 5/3)", "3 of 4 rows"),
        ],
    ),
    "08-splitting/right": (
        ["(1, 5/3), (5/3, 19/9), (7/3, 5/3), (3, 3)", [(1, F(5, 3)), ("5/3", F(19, 9)), (7 / 3, "5/3"), [3, 3]]],
        [
            ("(3, 3), (7/3, 5/3), (5/3, 19/9), (1, 5/3)", "order is reversed"),
            ("(0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3)", "the other half"),
        ],
    ),
    "08-splitting/local": (
        ["1/3", F(1, 3), 1 / 3],
        [
            (F(1, 4), "a itself"),
            (F(2, 3), "behind a"),
            (F(1, 2), "length of the part"),
            (0.1875, "Multiplied"),
            (F(3, 4), "Not this"),
        ],
    ),
    "08-splitting/part": (
        [
            "(-9/2, 27/8), (-3/2, 39/8), (3/2, 39/8), (9/2, 27/8)",
            [(-4.5, 3.375), (-1.5, 4.875), (1.5, 4.875), (4.5, 3.375)],
        ],
        [
            ("(9/2, 27/8), (3/2, 39/8), (-3/2, 39/8), (-9/2, 27/8)", "order is reversed"),
            ("(-9, 0), (-9/2, 9/2), (0, 45/8), (9/2, 27/8)", "in front of b"),
            ("(-9/2, 27/8), (0, 45/8), (9/2, 9/2), (9, 0)", "behind a"),
            ("(-45/8, 351/128), (-9/4, 621/128), (9/8, 81/16), (9/2, 27/8)", "parameter of its own"),
        ],
    ),
    "08-splitting/formula": (
        ["(1-t)^2 b_0 + 2t(1-t) b_1 + t^2 b_2", "(1-t)((1-t) b0 + t b1) + t((1-t) b1 + t b2)"],
        [
            ("t^2 b_0 + 2t(1-t) b_1 + (1-t)^2 b_2", "exchanged"),
            ("(1-t)^2 b_0 + t(1-t) b_1 + t^2 b_2", "must sum to 1"),
            ("(1-t) b_1 + t b_2", "first level"),
            ("b_0", "your formula is b_0"),
        ],
    ),
    "08-splitting/front-weight": (
        [(False, "n = 1, t = 1/2"), "false: n = 2, t = 1"],
        [(True, "a place where it fails"), (False, "Now a counterexample"), ("false: n = 0, t = 1", "outside")],
    ),
    "08-splitting/last-weight": ([True, "true"], [("false: n = 1, t = 1", "Not so")]),
    "08-splitting/unity": (
        [
            "sum(B(i,n,t), i, 0, n)\n= sum(C(n,i) t^i (1-t)^(n-i), i, 0, n)\n= ((1-t) + t)^n\n= 1",
            ["sum(B(i,n,t), i, 0, n)", "sum(B(n-i,n,t), i, 0, n)", "1"],
        ],
        [
            ("sum(B(i,n,t), i, 0, n)\n= 1", "show why"),
            ("sum(B(i,n,t), i, 0, n)\n= sum(B(i,n,t), i, 1, n)\n= 1", "Line 2 does not follow"),
            ("1\n= sum(B(i,n,t), i, 0, n)", "begin with"),
        ],
    ),
}
