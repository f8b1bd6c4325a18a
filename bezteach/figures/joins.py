"""Pictures of curves in several cubics: their curvature along the way, and what one moved data point moves."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import point
from ..numeric.joins import catmull_rom, natural
from ..palette import FIRST, INK, QUIET, SECOND
from .parts import curve, word
from .style import SAMPLES, STYLE

RULES = {"one-sixth rule": catmull_rom, "natural spline": natural}
LOOKS = ((FIRST, "-"), (SECOND, "--"), (INK, ":"))
STILL = 1e-9  # of the size of the data: a piece that moved less did not move


@mpl.rc_context(STYLE)
def curvatures(curves):
    """The signed curvature along each of {name: cubics, shape (m, 4, 2)}, piece k over [k, k + 1]."""
    figure = Figure(figsize=(7.6, 4.4), layout="constrained")
    axes = figure.subplots()
    t = np.linspace(0, 1, SAMPLES)
    jumps = {}
    for (name, cubics), (colour, dash) in zip(curves.items(), LOOKS, strict=False):
        values = [numeric.curvature(np.asarray(cubic, dtype=float), t) for cubic in cubics]
        for k, piece in enumerate(values):
            axes.plot(k + t, piece, dash, color=colour, label=None if k else name)
        jumps[name] = max(abs(right[0] - left[-1]) for left, right in zip(values, values[1:], strict=False))
    axes.axhline(0, color=QUIET, linewidth=1)
    axes.set(xlabel="piece", ylabel="curvature", xticks=range(len(values) + 1))
    figure.legend(loc="outside upper center", ncols=len(curves))
    told = "; ".join(f"{name}: the largest jump is {jump:.2g}" for name, jump in jumps.items())
    figure.set_label(f"Signed curvature along {len(values)} cubics, a piece after the other. {told}.")
    return figure


@mpl.rc_context(STYLE)
def reach(data, place, to):
    """Splines by both rules before and after a data point is moved; the pieces that move with it are drawn thick."""
    figure = Figure(figsize=(10.4, 3.4), layout="constrained")
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    after = [to if i == place else there for i, there in enumerate(data)]
    told = [_spread(axes, name, data, after) for axes, name in zip(panels, RULES, strict=True)]
    x, y = np.asarray([*data, to], dtype=float).T
    for axes in panels:
        axes.plot(x[:-1], y[:-1], "o", color=QUIET, markerfacecolor="white", markersize=7)
        axes.plot(x[-1], y[-1], "s", color=INK, markersize=9)
        axes.annotate("", (x[-1], y[-1]), (x[place], y[place]), arrowprops={"arrowstyle": "->", "color": INK})
        word(axes, (x[-1], y[-1]), f"$D_{{{place}}}$", np.array([1.0, 0.4]))
        axes.set(aspect="equal")
        axes.margins(0.12)
        axes.locator_params(axis="x", nbins=5)
    count = len(data) - 1
    figure.set_label(
        f"D_{place} of {count + 1} data points is moved from {point(data[place])} to {point(to)}. Of {count} pieces "
        f"{' and '.join(f'{pieces} move by the {name}' for pieces, name in zip(told, RULES, strict=True))}."
    )
    return figure


def _spread(axes, name, data, after):
    """Draw the splines before and after; how many pieces moved."""
    before, now = (np.asarray(RULES[name](points), dtype=float) for points in (data, after))
    size = np.abs(before).max()
    changed = [np.abs(new - old).max() > STILL * size for old, new in zip(before, now, strict=True)]
    for old, new, is_changed in zip(before, now, changed, strict=True):
        curve(axes, old, QUIET, dash=":", width=2)
        curve(axes, new, FIRST if is_changed else INK, width=4.5 if is_changed else 1.6)
    axes.set_title(f"{name}: {sum(changed)} of {len(changed)} pieces move")
    return sum(changed)
