"""The worked examples of the algorithm and of splitting: a cubic cut at 1/3, and a part of another one."""

from sympy import Mul, Rational, sympify

from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, u

from ..claim import Computed, argued, claim
from ..forms import quotient
from ..planar import levels
from .examples import weighted

CUT, PART = EXAMPLES["deck/split"], EXAMPLES["deck/segment"]
THIRD, QUARTER = Rational(1, 3), Rational(1, 4)


def cubic(points, parameter):
    """A point of the cubic with these control points."""
    return weighted([B(place, 3, parameter) for place in range(4)], sympify(points))


def written(points):
    """Points in words."""
    return ", ".join(f"({', '.join(map(str, point))})" for point in points)


def triangle(id, title, points, t, printed):
    """The argument that a printed triangle is that of the points at t: every level from the one before."""
    found = levels(points, t)
    steps = [
        Computed(
            f"Level {k}, with {1 - t} and {t} from each two neighbours of level {k - 1}: {written(printed[k])}.",
            lambda k=k: tuple(found[k]) == printed[k],
        )
        for k in range(1, len(printed))
    ]
    return argued(id, title, f"Level 0 holds the control points: {written(points)}.", *steps)


POINTS, PART_POINTS = CUT.given["points"], PART.given["points"]
FRONT, BACK = CUT.answer["left"], CUT.answer["right"]
TO_THREE_QUARTERS, MIDDLE = PART.answer["front"], PART.answer["part"]

CLAIMS = [
    triangle(
        "examples/split/triangle",
        "the cubic with the points (0, 0), (1, 3), (2, 1), (3, 3) at 1/3: all levels of the triangle",
        POINTS,
        CUT.given["t"],
        CUT.answer["triangle"],
    ),
    claim(
        "examples/split/point",
        "the cubic with the points (0, 0), (1, 3), (2, 1), (3, 3) is at (1, 5/3) for t = 1/3",
        (cubic(POINTS, THIRD), weighted([1], sympify([CUT.answer["point"]]))),
        twins=[(cubic(POINTS, 1 - THIRD), weighted([1], sympify([CUT.answer["point"]])))],
    ),
    claim(
        "examples/split/front",
        "its front, cut at 1/3: the first points of all levels",
        (cubic(POINTS, u / 3), cubic(FRONT, u)),
        twins=[(cubic(POINTS, u / 3), cubic(FRONT[::-1], u)), (cubic(POINTS, u / 3), cubic(BACK, u))],
    ),
    claim(
        "examples/split/back",
        "its back, cut at 1/3: the last points of all levels, the last level first",
        (cubic(POINTS, (1 + 2 * u) / 3), cubic(BACK, u)),
        twins=[(cubic(POINTS, (1 + 2 * u) / 3), cubic(BACK[::-1], u))],
    ),
    triangle(
        "examples/part/first-triangle",
        "the cubic with the points (-9, 0), (-3, 6), (3, 6), (9, 0) at 3/4: all levels of the triangle",
        PART_POINTS,
        PART.given["end"],
        PART.answer["first_triangle"],
    ),
    claim(
        "examples/part/front",
        "its front up to 3/4",
        (cubic(PART_POINTS, 3 * u / 4), cubic(TO_THREE_QUARTERS, u)),
        twins=[(cubic(PART_POINTS, u / 4), cubic(TO_THREE_QUARTERS, u))],
    ),
    claim(
        "examples/part/parameter",
        "1/4 of the whole is 1/3 of the front up to 3/4",
        (quotient(QUARTER, 1 - QUARTER), THIRD),
        twins=[(Mul(QUARTER, 1 - QUARTER, evaluate=False), THIRD)],
    ),
    triangle(
        "examples/part/second-triangle",
        "that front at 1/3: all levels of the triangle",
        TO_THREE_QUARTERS,
        PART.answer["local_parameter"],
        PART.answer["second_triangle"],
    ),
    claim(
        "examples/part/middle",
        "the part of the cubic from 1/4 to 3/4",
        (cubic(PART_POINTS, (1 + 2 * u) / 4), cubic(MIDDLE, u)),
        twins=[(cubic(PART_POINTS, (1 + 2 * u) / 4), cubic(MIDDLE[::-1], u))],
    ),
]
