"""Rounding errors (``numeric.rounding``) against the degree."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from ..numeric.rounding import UNIT, power_of_ten
from ..palette import FIRST, INK, QUIET, SECOND
from .style import STYLE

LOOKS = {
    "power basis, Horner": (SECOND, "--", "s"),
    "Bernstein sum": (INK, ":", "^"),
    "de Casteljau": (FIRST, "-", "o"),
    "Woźny and Chudy": (QUIET, "-.", "D"),
}


@mpl.rc_context(STYLE)
def error_growth(degrees, errors):
    """Errors, as ``numeric.rounding`` measures them, against the degree; an error of 0 lies on the floor."""
    figure = Figure(figsize=(7.6, 5.2), layout="constrained")
    axes = figure.subplots()
    for name, sizes in errors.items():
        colour, dash, marker = LOOKS[name]
        drawn = np.maximum(sizes, UNIT / 8)
        axes.semilogy(
            degrees, drawn, color=colour, linestyle=dash, marker=marker, markersize=6, markevery=(4, 5), label=name
        )
    axes.axhline(1, color=QUIET, linewidth=1)
    axes.annotate("as large as the points", (degrees[0], 1), xytext=(0, 5), textcoords="offset points", fontsize=12)
    axes.set(xlabel="degree", ylabel="largest error / largest |b|")
    figure.legend(loc="outside upper center", ncols=2)
    told = "; ".join(f"{name} {power_of_ten(sizes[-1])}" for name, sizes in errors.items())
    figure.set_label(
        f"The largest rounding error of {len(errors)} ways to evaluate, against the degree, on a logarithmic scale. "
        f"At degree {degrees[-1]} it is at most: {told}, in units of the largest control height."
    )
    return figure
