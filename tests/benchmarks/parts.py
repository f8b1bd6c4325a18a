"""Parts of curves, elevation and batches."""

from functools import cache, partial

import numpy as np

import bezteach as bz

from . import plain
from .evaluation import cubic_of, curve_for, polygon
from .job import Job, near
from .peers import present


def jobs(small=False):
    """All jobs on batches, parts and elevation; small ones with few curves."""
    count = 100 if small else 10**5
    yield sampling(count, 32)
    yield splitting(count)
    yield from (elevating(n, r, 0.8 if r < 10 else 0.3) for n in (3, 10, 20) for r in (1, 10, 20))
    yield from (one_split(n) for n in (3, 10))
    yield one_segment(3)


@cache
def batch(count):
    """So many plane cubics (count, 4, 2)."""
    return np.random.default_rng(0).uniform(-1, 1, (count, 4, 2))


def sampling(count, m):
    """Many cubics, each at the same uniform parameters."""
    curves, t = batch(count), np.linspace(0, 1, m)
    side_by_side = np.ascontiguousarray(curves.swapaxes(0, 1))
    peers = present(
        {
            ("scipy", "BSpline"): lambda scipy: partial(scipy.BSpline([0.0] * 4 + [1.0] * 4, side_by_side, 3), t),
            ("scipy", "BPoly"): lambda scipy: partial(scipy.BPoly(side_by_side[:, None], [0, 1]), t),
        }
    )
    at = plain.some(count)[::10]
    expected = [plain.curve(curve, t) for curve in curves[at]]
    name = f"{count} cubics x {m}"
    seen = {peer: lambda values: values.swapaxes(0, 1) for peer in peers}
    return Job(name, 0.75, lambda: bz.sample(curves, m), peers, near(expected, (count, m, 2), at), seen=seen)


def halves(points, t=0.5):
    """Both halves (2, n+1, d) by de Casteljau's triangle in long doubles."""
    levels = [np.asarray(points, dtype=np.longdouble)]
    while len(levels[-1]) > 1:
        levels.append((1 - t) * levels[-1][:-1] + t * levels[-1][1:])
    return np.array([[level[0] for level in levels], [level[-1] for level in levels[::-1]]])


def splitting(count):
    """Many cubics, each split in the middle."""
    curves, at = batch(count), plain.some(count)
    expected = [halves(curve) for curve in curves[at]]
    peers = present({"kurbopy": lambda kurbopy: cubics_of(kurbopy, curves), "fonttools": lambda t: cut(t, curves)})
    seen = {"ours": lambda pair: np.stack(pair, axis=1), "kurbopy": from_kurbopy}
    check = near(expected, (count, 2, 4, 2), at)
    name = f"split of {count} cubics"
    return Job(name, 0.15, lambda: bz.split(curves, 0.5), peers, check, against=("kurbopy",), seen=seen)


def cubics_of(kurbopy, curves):
    """kurbopy's cubics, ready, and a call that halves them one by one."""
    cubics = [cubic_of(kurbopy, curve) for curve in curves.tolist()]
    return lambda: [cubic.subdivide() for cubic in cubics]


def from_kurbopy(pairs):
    """The halves as an array."""
    return [[[(point.x, point.y) for point in (half.p0, half.p1, half.p2, half.p3)] for half in pair] for pair in pairs]


def cut(tools, curves):
    """fontTools's halves, one curve after the other."""
    corners = [[tuple(point) for point in curve] for curve in curves.tolist()]
    return lambda: [tools.splitCubicAtT(*curve, 0.5) for curve in corners]


def elevating(n, r, bar):
    """One curve raised by r degrees."""
    points, t = polygon(n), np.linspace(0, 1, n + r + 3)

    def check(answer):
        raised = np.asarray(answer, dtype=float)
        same = raised.shape == (n + r + 1, 2) and np.isfinite(raised).all()
        return bool(same and abs(plain.curve(raised, t) - plain.curve(points, t)).max() < 1e-11)

    peers = present(
        {
            "bezier": lambda bezier: raised_by_bezier(bezier, points, r),
            "splinepy": lambda splinepy: raised_by_splinepy(splinepy, points, r),
            "splipy": lambda splipy: raised_by_splipy(splipy, points, r),
        }
    )
    return Job(f"elevate n={n} r={r}", bar, lambda: bz.elevate(points, r), peers, check, against=("bezier",))


def raised_by_bezier(bezier, points, r):
    """`bezier` raises by one degree at a time."""
    curve = curve_for(bezier, points)

    def run():
        raised = curve
        for _ in range(r):
            raised = raised.elevate()
        return raised.nodes.T

    return run


def raised_by_splinepy(splinepy, points, r):
    """splinepy raises in place, so it is given a curve of its own in each call."""

    def run():
        raised = splinepy.Bezier([len(points) - 1], points)
        raised.elevate_degrees([0] * r)
        return raised.control_points

    return run


def raised_by_splipy(splipy, points, r):
    """splipy raises in place, too, and fits the curve anew."""
    n = len(points) - 1

    def run():
        raised = splipy.Curve(splipy.BSplineBasis(n + 1, [0.0] * (n + 1) + [1.0] * (n + 1)), points)
        return raised.raise_order(r).controlpoints

    return run


def one_split(n):
    """A single curve split at 1/2; no bar, because a call of NumPy costs as much as the whole in compiled code."""
    points = polygon(n)
    makers = {"bezier": lambda bezier: subdivided(bezier, points)}
    if n == 3:
        makers["kurbopy"] = lambda kurbopy: cubics_of(kurbopy, points[None])
        makers["fonttools"] = lambda tools: cut(tools, points[None])
    seen = {
        "bezier": lambda pair: [half.nodes.T for half in pair],
        "kurbopy": lambda pairs: from_kurbopy(pairs)[0],
        "fonttools": lambda pairs: pairs[0],
    }
    check = near(halves(points), (2, n + 1, 2))
    return Job(f"one split n={n}", None, lambda: bz.split(points, 0.5), present(makers), check, seen=seen)


def subdivided(bezier, points):
    """`bezier`'s halves."""
    return curve_for(bezier, points).subdivide


def one_segment(n, a=0.25, b=0.75):
    """The part of a single curve over [a, b]; no bar, for the same reason."""
    points, t = polygon(n), np.linspace(0, 1, n + 3)
    expected = plain.curve(points, a + (b - a) * t)

    def check(answer):
        return abs(plain.curve(np.asarray(answer, dtype=float), t) - expected).max() < 1e-12

    makers = {
        "bezier": lambda bezier: partial(curve_for(bezier, points).specialize, a, b),
        "kurbopy": lambda kurbopy: partial(cubic_of(kurbopy, points.tolist()).subsegment, (a, b)),
    }
    seen = {
        "bezier": lambda part: part.nodes.T,
        "kurbopy": lambda part: [(point.x, point.y) for point in (part.p0, part.p1, part.p2, part.p3)],
    }
    return Job(f"one segment n={n}", None, lambda: bz.segment(points, a, b), present(makers), check, seen=seen)
