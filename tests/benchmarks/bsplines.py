"""B-splines: points, and their Bézier points."""

from functools import partial

import numpy as np

import bezteach as bz

from . import plain
from .job import Job, near
from .peers import present

SCIPY = ("scipy PPoly", "scipy BSpline")


def jobs(small=False):
    """All jobs on cubic B-splines; small ones with few points and parameters."""
    many, most = (40, 200) if small else (10**4, 10**6)
    for count, bars in ((10, (0.5, 0.8)), (many, (2.2, 0.4))):
        yield evaluating(count, most, bars[0], in_order=True)
        yield evaluating(count, most, bars[1], in_order=False)
    yield to_bezier(many)
    yield one_basis(10)


def curve(count):
    """(control points, clamped knots at uneven distances) of a plane cubic."""
    numbers = np.random.default_rng(count)
    inner = np.cumsum(numbers.uniform(0.5, 1.5, count - 2))
    return numbers.uniform(-1, 1, (count, 2)), np.concatenate([[inner[0]] * 3, inner, [inner[-1]] * 3])


def evaluating(count, m, bar, in_order):
    """Points of the curve at parameters in order or in none."""
    points, knots = curve(count)
    t = np.random.default_rng(m).uniform(knots[0], knots[-1], m)
    t[:2] = knots[0], knots[-1]
    if in_order:
        t.sort()
    at = plain.some(m)
    peers = present(
        {
            ("scipy", "BSpline"): lambda scipy: partial(scipy.BSpline(knots, points, 3), t),
            ("scipy", "PPoly"): lambda scipy: partial(powers(scipy, knots, points), t),
            "splinepy": lambda splinepy: partial(splinepy.BSpline([3], [knots], points).evaluate, t[:, None]),
            "splipy": lambda splipy: partial(splipy.Curve(splipy.BSplineBasis(4, knots), points), t),
        }
    )
    check = near(plain.spline(points, knots, 3, t[at]), (m, 2), at)
    order = "sorted" if in_order else "random"
    name = f"B-spline p=3 points={count} m={m} {order}"
    return Job(name, bar, lambda: bz.bspline.evaluate(points, knots, t), peers, check, against=SCIPY)


def to_bezier(count):
    """Bézier points of all spans; `to_bezier` gives them as (spans, 4, 2)."""
    points, knots = curve(count)
    spans, local = count - 3, np.linspace(0, 1, 4)
    at = plain.some(spans)[::10]
    breaks = knots[3:-3]
    places = (breaks[at, None] + (breaks[at + 1] - breaks[at])[:, None] * local).ravel()
    expected = plain.spline(points, knots, 3, places).reshape(at.size, 4, 2)

    def check(answer):
        """Four points on each of some pieces decide a cubic."""
        pieces = np.asarray(answer, dtype=float)
        if pieces.shape != (spans, 4, 2) or not np.isfinite(pieces).all():
            return False
        found = [plain.curve(piece, local) for piece in pieces[at]]
        return bool(abs(found - expected).max() < 1e-11)

    peers = present(
        {
            "scipy": lambda scipy: lambda: in_bernstein(scipy, knots, points),
            "splinepy": lambda splinepy: lambda: splinepy.BSpline([3], [knots], points).extract.beziers(),
        }
    )
    seen = {
        "ours": lambda answer: answer[0],
        "splinepy": lambda pieces: [piece.control_points for piece in pieces],
    }
    name = f"to_bezier of {count} points"
    return Job(name, 0.5, lambda: bz.bspline.to_bezier(points, knots), peers, check, against=("scipy",), seen=seen)


def powers(scipy, knots, points):
    """SciPy's powers on each span, of one coordinate after the other, because it converts no more at once."""
    each = [scipy.PPoly.from_spline((knots, column, 3)) for column in points.T.copy()]
    return scipy.PPoly(np.stack([one.c for one in each], axis=-1), each[0].x)


def in_bernstein(scipy, knots, points):
    """SciPy's way: powers on each span, which are then written in the Bernstein basis; spans of no length fall away."""
    whole = powers(scipy, knots, points)
    inner = scipy.PPoly(whole.c[:, 3:-3], whole.x[3:-3])
    return scipy.BPoly.from_power_basis(inner).c.swapaxes(0, 1)


def one_basis(count):
    """All basis functions at 1000 parameters: a picture's; no bar."""
    points, knots = curve(count)
    t = np.linspace(knots[0], knots[-1], 1000)
    expected = plain.spline(np.eye(count), knots, 3, t)
    peers = present(
        {
            ("scipy", "BSpline"): lambda scipy: partial(scipy.BSpline(knots, np.eye(count), 3), t),
            ("scipy", "design matrix"): lambda scipy: lambda: scipy.BSpline.design_matrix(t, knots, 3).toarray(),
        }
    )
    check = near(expected, (t.size, count))
    return Job(f"basis p=3 points={count} m=1000", None, lambda: bz.bspline.basis(knots, 3, t), peers, check)
