"""What the statements of the ledger are written with: the curve, its operators, what stays as it is written, ranges.

Nothing here is proved or simplified: a claim is built from these forms, and the provers decide it.
"""

from sympy import Add, Derivative, Interval, Mul, Pow, Subs, Sum, factorial, oo

from bezteach.symbolic import B, E, b, i, n, r, step, t

WITHIN = {i: (0, n)}  # an index of the basis or of the control points
ORDER = {r: (0, n)}  # the order of a derivative, up to the degree
FROM_ONE, FROM_TWO = {n: (1, oo)}, {n: (2, oo)}  # the degree
UNIT = {t: Interval(0, 1)}  # the parameter

G = step(t)  # one step of de Casteljau's algorithm at t
DELTA = E - 1  # the forward difference: it takes each point to the way to the next
FALLING = factorial(n) / factorial(n - r)  # n (n - 1) ... (n - r + 1), what r derivatives put in front


def curve(degree=n, first=0, *, at=t, points=b, index=i):
    """The curve of this degree at a parameter; its first control point is b[first], so ``curve(k, j)`` is b_j^k.

    >>> curve()
    Sum(B(i, n, t)*b[i], (i, 0, n))
    >>> curve(2, 1, at=1 - t)
    Sum(B(i, 2, 1 - t)*b[i + 1], (i, 0, 2))
    """
    return Sum(B(index, degree, at) * points[index + first], (index, 0, degree))


def curve_of(points, at=t):
    """The curve of these control points at a parameter, term by term.

    >>> curve_of([b[0], 0, b[2]])
    B(0, 2, t)*b[0] + B(2, 2, t)*b[2]
    """
    return sum(B(place, len(points) - 1, at) * point for place, point in enumerate(points))


def derivative_at(at, function, order=1):
    """The derivative of this order in t at a value of t, as it is defined.

    >>> derivative_at(0, t**3, 2)
    Subs(Derivative(t**3, (t, 2)), t, 0)
    """
    return Subs(Derivative(function, (t, order)), t, at)


def quotient(above, below):
    """A fraction in which nothing is cancelled.

    >>> quotient(2 * t, t)
    (2*t)/t
    """
    return Mul(above, Pow(below, -1, evaluate=False), evaluate=False)


def difference(left, right):
    """A difference in which nothing is cancelled or multiplied out.

    >>> difference(t, t - 1)
    t - (t - 1)
    """
    return Add(left, Mul(-1, right, evaluate=False), evaluate=False)
