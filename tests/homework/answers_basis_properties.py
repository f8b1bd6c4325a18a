"""By hand, for the book's numbers: right answers in several forms, then wrong ones and a piece of what each is told."""

from fractions import Fraction as F

RATIO = """(n-i) t B(i,n,t)
= (n-i) C(n,i) t^(i+1) (1-t)^(n-i)
= (i+1) C(n,i+1) t^(i+1) (1-t)^(n-i)
= (i+1) (1-t) C(n,i+1) t^(i+1) (1-t)^(n-i-1)
= (i+1) (1-t) B(i+1,n,t)"""
BOOK = {
    "03-basis-properties/down": (
        ["2/9", F(2, 9), 2 / 9, "2/4 * 24/81 + 3/4 * 8/81"],
        [
            ("22/81", "factors are exchanged"),
            ("32/81", "added the two values"),
            ("16/81", "the mean of two values"),
            ("34/81", "one index too low"),
            ("8/27", "the lower one of the two degrees"),
            ("1/9", "Not this"),
        ],
    ),
    "03-basis-properties/part": (
        ["(9/64, 3/8, 3/4, 0)", [F(9, 64), F(3, 8), 0.75, 0]],
        [
            ("(0, 0, 1/16, 9/64)", "the part before 1/4"),
            ("(0, 3/4, 3/8, 9/64)", "order is reversed"),
            ("(27/64, 3/8, 1/4, 0)", "from 3/4 on"),
            ("(9/64, 3/8, 27/64, 0)", "Coefficients are no values"),
            ((0, 0, 1, 0), "the coefficients on [0, 1]"),
            ("(9/64, 1/4, 3/4, 0)", "3 of 4 numbers"),
        ],
    ),
    "03-basis-properties/area": (
        ["1/10", F(1, 10), 0.1],
        [
            ("1/12", "no product"),
            ("1/6", "under one function"),
            ("3/5", "multiplied by an area"),
            ("3/25", "share the area 1"),
            (1, "The third one"),
            ("1/2", "Not this"),
        ],
    ),
    "03-basis-properties/slope": (
        ["10 t^2 (1-t) (3-5t)", "-10 t^2 (1-t) (5t-3)", "50 t^2 (1-t) (3/5 - t)"],
        [
            ("2 t^2 (1-t) (3-5t)", "The factor before it is missing"),
            ("10 t^2 (1-t) (5t-3)", "The sign"),
            ("25 t^2 (1-t)^2 (2-3t)", "your formula is"),
            ("5 (B(2,5,t) - B(3,5,t))", "has a degree less"),
            ("5 (B(2,4,t) + B(3,4,t))", "a sign is missing"),
            ("-60 t^2 (1-t)", "derivatives of the two powers"),
            ("5 B(2,4,t) - 5 B(3,4,t)", "not a product"),
            ("30 t^2 - 80 t^3 + 50 t^4", "not a product"),
        ],
    ),
    "03-basis-properties/crossing": (
        ["(i+1)/(n+1)", "1 - (n-i)/(n+1)", r"\frac{1+i}{1+n}"],
        [
            ("i/n", "the peak of the first one"),
            ("(i+1)/n", "the peak of the second one"),
            ("(i + 1/2)/n", "midway"),
            ("1 - (i+1)/(n+1)", "which one of the two"),
            ("(i+1)/(n+2)", "Try n = 1"),
            ("1/2", "your formula is"),
        ],
    ),
    "03-basis-properties/falling": (
        ["C(n-j,k)/C(n,k)", "C(n-k,j)/C(n,j)"],
        [
            ("C(j,k)/C(n,k)", "Which end is 1"),
            ("C(n-j,k)", "for j = 0"),
            ("(n-j)/n", "right for k = 1"),
            ("1 - C(j,k)/C(n,k)", "for 1 - t^k"),
            ("C(n-j,k)/C(n,j)", "for k = 0"),
            ("C(n-j,k)/C(n-j,j)", "your formula"),
        ],
    ),
    "03-basis-properties/neighbours": (
        [True, "true"],
        [("false: n = 2, i = 1, t = 1/2", "Not so"), (False, "Not so")],
    ),
    "03-basis-properties/half-area": (
        [(False, "n = 1, i = 0"), "false: n = 2, i = 2"],
        [
            (True, "a place where it fails"),
            (False, "Now a counterexample"),
            ("false: n = 2, i = 1", "the statement holds"),
            ("false: n = 2, i = 3", "outside"),
        ],
    ),
    "03-basis-properties/ratio": (
        [
            RATIO,
            ["(n-i) t B(i,n,t)", *(line[2:] for line in RATIO.splitlines()[1:3]), "(i+1) (1-t) B(i+1,n,t)"],
        ],
        [
            ("(n-i) t B(i,n,t)\n= (i+1) (1-t) B(i+1,n,t)", "at least 2"),
            (RATIO.replace("(i+1) C(n,i+1)", "(n-i) C(n,i+1)"), "Line 3 does not follow"),
            (RATIO.replace("C(n,i) t^(i+1)", "C(n,i) t^i"), "Line 2 does not follow"),
            ("\n".join(RATIO.splitlines()[:3]), "Go on until"),
            ("\n= ".join(RATIO.split("\n= ")[::-1]), "begin with"),
        ],
    ),
    "03-basis-properties/dip": (
        [
            "(0, 1), (1/3, -1/4), (2/3, 1), (1, 2)",
            [(0, 1), (F(1, 3), 1), (F(2, 3), F(-1, 10)), (1, 2)],
        ],
        [
            ("(0, 1), (1/3, -1/4), (1, 2)", "four control points"),
            ("(0, 1), (1, -1/4), (2, 1), (3, 2)", "above 0, 1/3, 2/3, 1"),
            ("(0, 2), (1/3, -1/4), (2/3, 1), (1, 1)", "has another value"),
            ("(0, 1), (1/3, 0), (2/3, 1), (1, 2)", "No height is negative"),
            ("(0, 1), (1/3, -3), (2/3, 1), (1, 2)", "somewhere on [0, 1]"),
        ],
    ),
}
