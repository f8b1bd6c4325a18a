"""How the cost grows: a line in logarithms for each size that may grow, and the exponent that it shows at its end."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import comb
from time import process_time

import numpy as np

import bezteach as bz

from . import bsplines, exact
from .evaluation import parameters, polygon
from .job import Row
from .measuring import timed


@dataclass(frozen=True)
class Series:
    """One cost against one size; no exponent above the bar is expected."""

    name: str
    size: str
    sizes: Sequence[int]
    bar: float
    make: Callable


def all_series():
    """What may grow: degrees, parameters, curves, spans, and the degree of a proof."""
    t, places, batch = parameters(10**4), parameters(10**5), np.random.default_rng(0).uniform(-1, 1, (10**5, 4, 2))
    return (
        Series("evaluate, 10^4 t", "degree", (8, 16, 32, 64, 128, 256), 1.2, lambda n: run(bz.evaluate, polygon(n), t)),
        Series(
            "evaluate_accurate, 10^4 t",
            "degree",
            (8, 16, 32, 64, 128),
            1.2,
            lambda n: run(bz.evaluate_accurate, polygon(n), t),
        ),
        Series("elevate", "degree", (8, 16, 32, 64, 128, 256), 2.2, lambda n: run(bz.elevate, polygon(n))),
        Series("split", "degree", (4, 8, 16, 32, 64), 3.2, lambda n: run(bz.split, polygon(n), 0.5)),
        exactly("exact triangle", bz.de_casteljau),
        exactly("exact point", bz.evaluate),
        Series(
            "evaluate, n = 10",
            "parameters",
            (10**3, 10**4, 10**5, 10**6),
            1.15,
            lambda m: run(bz.evaluate, polygon(10), parameters(m)),
        ),
        Series("sample, n = 10", "parameters", (10**4, 10**5, 10**6), 1.15, lambda m: run(bz.sample, polygon(10), m)),
        Series(
            "sample of cubics, m = 32",
            "curves",
            (10**3, 10**4, 10**5),
            1.3,  # from 10^4 curves on the numbers do not fit into the cache
            lambda count: run(bz.sample, batch[:count], 32),
        ),
        Series(
            "split of cubics", "curves", (10**3, 10**4, 10**5), 1.15, lambda count: run(bz.split, batch[:count], 0.5)
        ),
        Series(
            "B-spline, 10^5 t",
            "spans",
            (10, 100, 10**3, 10**4),
            0.3,
            lambda count: run(spline_at, *bsplines.curve(count + 3), places),
        ),
        Series(
            "to_bezier",
            "spans",
            (10**2, 10**3, 10**4),
            1.15,
            lambda count: run(bz.bspline.to_bezier, *bsplines.curve(count + 3)),
        ),
        Series("roots to 2^-20", "degree", (4, 8, 16, 32), 3.2, lambda n: run(bz.roots, chebyshev(n))),
        Series("proof of unity as a sum", "degree of the proof", (4, 8, 16, 32), 3.2, unity),
        Series("proof of unity, written out", "degree of the proof", (4, 8, 16, 32), 3.2, written_out),
    )


def exactly(name, function):
    """A function of exact control points and one exact parameter, by degree."""
    return Series(name, "degree", (5, 10, 20, 40), 3.2, lambda n: run(function, np.array(exact.polygon(n)), exact.T))


def run(function, *arguments):
    """A call without arguments."""
    return lambda: function(*arguments)


def spline_at(points, knots, shares):
    """A B-spline at parameters given as shares of its domain."""
    return bz.bspline.evaluate(points, knots, knots[0] + (knots[-1] - knots[0]) * shares)


def chebyshev(n):
    """Heights that change their sign from one to the next, which has n roots in [0, 1]: Chebyshev's polynomial."""
    return [Fraction((-1) ** (n - i) * comb(2 * n, 2 * i), comb(n, i)) for i in range(n + 1)]


def unity(n):
    """The basis of a degree sums to 1."""
    return run(proved, f"sum(B(i,{n},t), i, 0, {n}) = 1")


def written_out(n):
    """The same with every term of the sum written out, so that the text and the proof grow with the degree."""
    return run(proved, " + ".join(f"B({i},{n},t)" for i in range(n + 1)) + " = 1")


def proved(text):
    """Judge a statement, which must be found true."""
    verdict = bz.bench.judge(text)
    assert verdict.status == "PROVED", (text, verdict.status)


def line(series, runs=7, small=False):
    """Seconds by size."""
    sizes = series.sizes[:2] if small else series.sizes
    return {size: timed({"ours": series.make(size)}, runs, process_time)["ours"] for size in sizes}


def exponent(times):
    """The slope of the logarithms over the last three sizes, where what does not grow counts least."""
    sizes, seconds = (np.log(list(values)[-3:]) for values in (times, times.values()))
    return float(np.polyfit(sizes, seconds, 1)[0])


def row(series, times):
    """The exponent, with its bar."""
    name = f"growth of {series.name} with the {series.size}"
    return Row(name, exponent(times), {}, (), series.bar, True, "exponent")


def plotted(lines, path):
    """The lines, [(series, times)], as a PNG: a panel for each kind of size."""
    from matplotlib.figure import Figure

    kinds = list(dict.fromkeys(series.size for series, _ in lines))
    figure = Figure(figsize=(15, 6.5 * -(-len(kinds) // 3)), layout="constrained")
    panels = figure.subplots(-(-len(kinds) // 3), 3, squeeze=False).ravel()
    for axes in panels[len(kinds) :]:
        axes.remove()
    for axes, kind in zip(panels, kinds, strict=False):
        for marker, (series, times) in zip("osD^v<>ph", (pair for pair in lines if pair[0].size == kind), strict=False):
            label = f"{series.name}: {exponent(times):.2f}"
            axes.loglog(list(times), [1000 * seconds for seconds in times.values()], marker=marker, label=label)
        axes.set(xlabel=kind, ylabel="milliseconds")
        axes.grid(True, which="major", alpha=0.3)
        axes.legend(loc="lower left", bbox_to_anchor=(0, 1), frameon=False)  # above, where it covers nothing
    figure.savefig(path, dpi=110)
