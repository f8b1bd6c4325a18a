"""Points, derivatives and curvature of one curve at many parameters."""

from functools import partial

import numpy as np

import bezteach as bz

from . import plain
from .job import Job, near
from .peers import present

PURE = 1000  # parameters that a peer is asked for which goes through them one by one in Python
LIMIT = "reading and writing"


def jobs(small=False):
    """All jobs on single curves; small ones, to try the harness, with few parameters."""
    most = 256 if small else 10**6
    counts = [m for m in (16, 256, 4096, 65536, 10**6) if m <= most]
    yield from (sampling(n, m) for n in (1, 3, 5, 10, 20, 50) for m in counts)
    for m, bars in (
        (10**4, {1: 0.6, 2: 0.6, 3: 0.6, 5: 1.0, 10: 1.0, 20: 1.0, 50: 0.6}),
        (10**5, {1: 0.5, 2: 0.5, 3: 0.5, 5: 0.8, 10: 0.8, 20: 0.6, 50: 0.6}),
        (10**6, {1: 0.5, 2: 0.5, 3: 0.5, 5: 0.8, 10: 0.8, 20: 0.6, 50: 0.6}),
    ):
        yield from (evaluating(n, min(m, most), bar) for n, bar in bars.items())
    yield from (evaluating(n, m, None) for n in (3, 10) for m in (1, PURE) if m <= most)
    yield from (uniform_limit(n, most) for n in (1, 3, 10))
    yield cubic_limit(most)
    yield from (differentiating(n, most) for n in (3, 5))
    yield bending(3, most)


def polygon(n, d=2):
    """Control points (n+1, d) without symmetries."""
    return np.random.default_rng(n).uniform(-1, 1, (n + 1, d))


def parameters(m):
    """So many parameters in [0, 1] in no order, with both ends."""
    t = np.random.default_rng(m).uniform(0, 1, m)
    t[0], t[-1] = 0, 1
    return t


def evaluating(n, m, bar):
    """The curve at arbitrary parameters."""
    points, t = polygon(n), parameters(m)
    return Job(
        f"evaluate n={n} m={m}",
        bar,
        lambda: bz.evaluate(points, t),
        contenders(points, t),
        right(points, t),
        against=("bezier",),
    )


def sampling(n, m):
    """The curve at uniform parameters, which the peers find ready."""
    points, t = polygon(n), np.linspace(0, 1, m)
    return Job(
        f"sample n={n} m={m}",
        0.5,
        lambda: bz.sample(points, m),
        contenders(points, t),
        right(points, t),
        against=("bezier",),
    )


def right(points, t):
    """The check of points of a curve."""
    at = plain.some(t.size)
    return near(plain.curve(points, t[at]), (t.size, points.shape[1]), at)


def contenders(points, t):
    """Peers that evaluate at an array; on few parameters also those that go through them in Python."""
    n = len(points) - 1
    column = t[:, None]
    ends = [0.0] * (n + 1) + [1.0] * (n + 1)
    makers = {
        "bezier": lambda bezier: curve_of(bezier, points, t),
        ("scipy", "BPoly"): lambda scipy: partial(scipy.BPoly(points[:, None], [0, 1]), t),
        ("scipy", "BSpline"): lambda scipy: partial(scipy.BSpline(ends, points, n), t),
        "splinepy": lambda splinepy: partial(splinepy.Bezier([n], points).evaluate, column),
        "splipy": lambda splipy: partial(splipy.Curve(splipy.BSplineBasis(n + 1, ends), points), t),
    }
    if n <= 20:  # beyond, its float powers of the binomials lose digits
        makers["matplotlib"] = lambda matplotlib: partial(matplotlib.BezierSegment(points), t)
    if t.size <= PURE:
        makers |= one_by_one(points, t)
    return present(makers)


def one_by_one(points, t):
    """Peers that take one parameter at a time, or a list that they go through in Python."""
    n, each = len(points) - 1, t.tolist()
    makers = {"splines": lambda splines: partial(splines.Bernstein([points]).evaluate, t)}
    if n > 1:
        makers["geomdl"] = lambda geomdl: from_geomdl(points, each)
    if n == 3:
        corners = [tuple(point) for point in points.tolist()]
        makers["fonttools"] = lambda tools: lambda: [tools.cubicPointAtT(*corners, value) for value in each]
        makers["kurbopy"] = lambda kurbopy: from_kurbopy(kurbopy, corners, each)
    return makers


def from_geomdl(points, each):
    """geomdl's curve of a list of parameters."""
    from geomdl import BSpline

    degree = len(points) - 1
    curve = BSpline.Curve()
    curve.degree, curve.ctrlpts = degree, points.tolist()
    curve.knotvector = [0.0] * (degree + 1) + [1.0] * (degree + 1)
    return lambda: curve.evaluate_list(each)


def from_kurbopy(kurbopy, corners, each):
    """kurbopy's cubic, a parameter at a time."""
    cubic = cubic_of(kurbopy, corners)

    def run():
        found = map(cubic.eval, each)
        return [(point.x, point.y) for point in found]

    return run


def cubic_of(kurbopy, corners):
    """kurbopy's cubic."""
    return kurbopy.CubicBez(*(kurbopy.Point(*corner) for corner in corners))


def curve_for(bezier, points):
    """`bezier`'s curve."""
    return bezier.Curve(np.asfortranarray(points.T), len(points) - 1, copy=False, verify=False)


def curve_of(bezier, points, t):
    """`bezier`'s whole call; it lays coordinates in rows."""
    curve = curve_for(bezier, points)
    return lambda: curve.evaluate_multi(t).T


def uniform_limit(n, m):
    """A large sample against the least that any way must do: write all the numbers, and read as many as t."""
    points, t = polygon(n), np.linspace(0, 1, m)
    return limited(f"sample n={n} m={m} to the limit", 5, lambda: bz.sample(points, m), points, t)


def cubic_limit(m):
    """Arbitrary parameters against the same."""
    points, t = polygon(3), parameters(m)
    return limited(f"evaluate n=3 m={m} to the limit", 8, lambda: bz.evaluate(points, t), points, t)


def limited(name, bar, ours, points, t):
    """A job against reading t and writing 2m numbers into fresh memory, which is not asked for a right answer."""
    check = right(points, t)
    return Job(
        name,
        bar,
        ours,
        {LIMIT: lambda: read_and_write(t)},
        lambda answer: answer is None or check(answer),
        seen={LIMIT: lambda answer: None},
    )


def read_and_write(t):
    """Fresh memory for two numbers a parameter, each written once from t."""
    written = np.empty((2, t.size))
    np.copyto(written, t)
    return written


def differentiating(n, m):
    """The first derivative at arbitrary parameters, against the curve of the differences."""
    points, t, at = polygon(n), parameters(m), plain.some(m)
    edges = plain.differences(points).astype(float)
    ends = [0.0] * (n + 1) + [1.0] * (n + 1)
    peers = present(
        {
            "bezier": lambda bezier: hodograph_of(bezier, points, t),
            ("scipy", "BPoly"): lambda scipy: partial(scipy.BPoly(points[:, None], [0, 1]).derivative(), t),
            ("scipy", "BSpline"): lambda scipy: partial(scipy.BSpline(ends, points, n), t, 1),
            "splinepy": lambda splinepy: partial(splinepy.Bezier([n], points).derivative, t[:, None], [1]),
            "splipy": lambda splipy: partial(splipy.Curve(splipy.BSplineBasis(n + 1, ends), points).derivative, t),
        }
    )
    check = near(plain.curve(edges, t[at]), (m, 2), at)
    return Job(f"derivative n={n} m={m}", 0.75, lambda: bz.derivative(points, t), peers, check, against=("bezier",))


def hodograph_of(bezier, points, t, r=1):
    """The r-th derivative with `bezier`: its curve of the differences, computed in each call."""

    def run():
        edges = points
        for _ in range(r):
            edges = (len(edges) - 1) * np.diff(edges, axis=0)
        return curve_of(bezier, edges, t)()

    return run


def bending(n, m):
    """Signed curvature at arbitrary parameters."""
    points, t, at = polygon(n), parameters(m), plain.some(m)
    ends = [0.0] * (n + 1) + [1.0] * (n + 1)
    peers = present(
        {
            "bezier": lambda bezier: quotient(hodograph_of(bezier, points, t), hodograph_of(bezier, points, t, 2)),
            "splipy": lambda splipy: partial(splipy.Curve(splipy.BSplineBasis(n + 1, ends), points).curvature, t),
        }
    )
    expected = plain.curvature(points, t[at])
    signed, unsigned = (near(values, (m,), at, tolerance=1e-9) for values in (expected, abs(expected)))
    return Job(
        f"curvature n={n} m={m}",
        0.5,
        lambda: bz.curvature(points, t),
        peers,
        lambda answer: signed(answer) or unsigned(answer),  # splipy's has no sign
        against=("bezier",),
    )


def quotient(first, second):
    """Curvature from two ways to derivatives, by the formula."""

    def run():
        (x1, y1), (x2, y2) = first().T, second().T
        return (x1 * y2 - y1 * x2) / (x1 * x1 + y1 * y1) ** 1.5

    return run
