"""The quartic whose middle point moves: its curve may be convex though its polygon is not."""

from fractions import Fraction
from itertools import pairwise

from sympy import Add, Derivative, Interval, Le, Mul, Rational, symbols
from sympy.abc import t as variable

from bezteach.symbolic import t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import curve_of
from ..signs import along_curve, roots_inside, sign_changes

omega, x = symbols("omega x", real=True)


def heights(middle):
    """The heights of the control points."""
    return [0, Fraction(1, 4), middle, Fraction(1, 4), 0]


HEIGHTS = curve_of(heights(omega), x)
HEIGHT = (1 - x) ** 3 * x + 6 * omega * (1 - x) ** 2 * x**2 + (1 - x) * x**3
MIDDLE = Mul(2, 1 - 4 * omega, 1 - x, x, evaluate=False)
SIXTH = Add((2 * omega - 1) * (1 - x) ** 2, MIDDLE, (2 * omega - 1) * x**2, evaluate=False)
SECOND = Mul(6, SIXTH, evaluate=False)
PARTED = (2 * omega - 1) * (1 - 2 * x) ** 2 - 4 * omega * x * (1 - x)


def second_derivative(middle):
    """y'' of the quartic as a polynomial in t, for a value of omega."""
    return along_curve(heights(middle)).diff().diff()


def inflections(middle):
    return sum(power % 2 for power in roots_inside(second_derivative(middle), 0, 1))


def no_inflection_between():
    return all(inflections(Fraction(place, 24)) == 0 for place in range(13))


def at_the_bounds():
    """y'' is -6 (1 - 2 t)^2 for omega = 0 and -12 t (1 - t) for omega = 1/2."""
    low, high = second_derivative(0), second_derivative(Fraction(1, 2))
    return (low + 6 * (1 - 2 * variable) ** 2).is_zero and (high + 12 * variable * (1 - variable)).is_zero


def two_inflections_beyond():
    below = [Fraction(-5), Fraction(-1), Fraction(-1, 1000)]
    return all(inflections(middle) == 2 for middle in [*below, *(Fraction(1, 2) - middle for middle in below)])


def polygon_passes(middle, height):
    return sign_changes([value - height for value in heights(middle)])


def bends(middle):
    """How much more is gained in height along an edge than along the one before."""
    gained = [high - low for low, high in pairwise(heights(middle))]
    return [later - before for before, later in pairwise(gained)]


def bounds_of_the_polygon():
    quarter, half = Fraction(1, 4), Fraction(1, 2)
    return (
        bends(quarter) == [-quarter, 0, -quarter]
        and bends(half) == [0, -half, 0]
        and polygon_passes(Fraction(1, 8), Fraction(3, 16)) == 4
        and polygon_passes(0, Fraction(1, 8)) == 4
    )


CLAIMS = [
    claim(
        "quartic/x",
        "the abscissas 0, 1/4, 1/2, 3/4, 1 give x = t",
        (curve_of([Rational(place, 4) for place in range(5)]), t),
        twins=[(curve_of([*(Rational(place, 4) for place in range(4)), 0]), t)],
    ),
    claim(
        "quartic/y",
        "the height of the quartic over x",
        (HEIGHTS, HEIGHT),
        twins=[
            (HEIGHTS, (1 - x) ** 3 * x + 6 * omega * (1 - x**2) * x**2 + (1 - x) * x**3),
            (HEIGHTS, (1 - x) ** 3 * x + 4 * omega * (1 - x) ** 2 * x**2 + (1 - x) * x**3),
        ],
    ),
    claim(
        "quartic/second-derivative",
        "the second derivative of the height of the quartic",
        (Derivative(HEIGHT, (x, 2)), SECOND),
        twins=[
            (Derivative(HEIGHT, (x, 2)), SIXTH),
            (Derivative(HEIGHT, (x, 2)), SECOND - 3 * MIDDLE),
            (Derivative((1 - x) ** 3 * x + 6 * omega * (1 - x**2) * x**2 + (1 - x) * x**3, (x, 2)), SECOND),
        ],
    ),
    argued(
        "quartic/convex",
        "for 0 <= omega <= 1/2 the quartic is convex",
        Known("The curve is the graph of its height over x,", "quartic/x"),
        Known("and y'' is known.", "quartic/second-derivative"),
        Shown(
            "For 0 <= omega <= 1/2 and 0 <= x <= 1, y'' <= 0,",
            Le(SECOND, 0, evaluate=False),
            {omega: Interval(0, Rational(1, 2)), x: Interval(0, 1)},
        ),
        Shown(
            "as y''/6 is the sum of two terms that are not positive.",
            eq(SIXTH, PARTED),
        ),
        "y''/6 is 2 omega - 1 at x = 0 and -omega at x = 1/2, which are never both 0: y'' is 0 at single points only, "
        "and y' falls strictly. So on a line y = m x + c, y - m x - c has a derivative with one root at most, and by "
        "Rolle's theorem no more than two roots; a line that is upright meets the graph once at most. The curve is "
        "convex.",
        Computed("At omega = 0, y'' = -6 (1 - 2 x)^2; at omega = 1/2, y'' = -12 x (1 - x).", at_the_bounds),
        Computed(
            "Instances by Sturm's sequences: y'' changes its sign for none of omega = 0, 1/24, ..., 1/2.",
            no_inflection_between,
        ),
    ),
    argued(
        "quartic/inflections",
        "for omega < 0 and for omega > 1/2 the quartic has exactly two inflections, and is not convex",
        Known("y'' is known,", "quartic/second-derivative"),
        Shown("and a sixth of it can be written so:", eq(SIXTH, PARTED)),
        Shown("2 omega - 1 at x = 0,", eq(SIXTH.subs(x, 0), 2 * omega - 1)),
        Shown("2 omega - 1 at x = 1,", eq(SIXTH.subs(x, 1), 2 * omega - 1)),
        Shown("-omega at x = 1/2.", eq(SIXTH.subs(x, Rational(1, 2)), -omega)),
        "For omega < 0, 2 omega - 1 < 0 < -omega; for omega > 1/2, 2 omega - 1 > 0 > -omega. So y'' changes its sign "
        "between 0 and 1/2, and again between 1/2 and 1; as its degree in x is at most 2, it has no other root, and "
        "both are simple. An inflection is a point where y'' changes its sign: there are two.",
        "Let z be one. Less its tangent at z, y is (x - z)^3 g(x) with g(z) not 0. The line through this point whose "
        "slope is larger by a small e with the sign of g(z) meets the curve at z and where (x - z)^2 g(x) = e, near z "
        "once on each side: three times. So the curve is not convex.",
        Computed(
            "Instances by Sturm's sequences: two changes of sign of y'' for omega = -5, -1, -1/1000 and for 501/1000, "
            "3/2, 11/2.",
            two_inflections_beyond,
        ),
    ),
    argued(
        "curve/convexity/converse",
        "the quartic for 0 <= omega < 1/4 is convex though its polygon is not; for no other omega",
        Known("The quartic is convex for 0 <= omega <= 1/2", "quartic/convex"),
        Known("and for no other omega.", "quartic/inflections"),
        "Its polygon is the graph of a function with the heights 0, 1/4, omega, 1/4, 0 at equal steps. From edge to "
        "edge the height gained changes by omega - 1/2, 1/2 - 2 omega, omega - 1/2.",
        "For 1/4 <= omega <= 1/2 all three are <= 0: the slope never rises, and no line but those of the edges passes "
        "the polygon more than twice. It is convex.",
        "For 0 <= omega < 1/4 the line at the height (omega + 1/4)/2 lies above b_0, b_2 and b_4 and below b_1 and "
        "b_3: it passes the polygon four times. The polygon is not convex, but the curve is.",
        "So the converse of the theorem is false; omega = 0 belongs to the examples, omega = 1/4 does not: there b_1, "
        "b_2, b_3 are in line.",
        Computed(
            "The changes are -1/4, 0, -1/4 at omega = 1/4 and 0, -1/2, 0 at omega = 1/2; for omega = 1/8 the line "
            "y = 3/16 passes four times, for omega = 0 the line y = 1/8.",
            bounds_of_the_polygon,
        ),
    ),
]
