"""The lessons' pictures: data in, a matplotlib ``Figure`` out, whose label is its alternative text.

Every picture reads on a projector and in greyscale: what a colour tells, a dash or a marker tells too. Points are rows
of two numbers, exact or not. ``show`` puts a figure into a notebook as PNG and SVG, the same bytes from run to run.
"""

from .curves import halving, loci, lower_curves, segment, split, triangle
from .derivatives import hodograph
from .errors import error_growth
from .functions import areas, basis, decay, graph, graphs, stacked
from .scene import drawn
from .style import show

__all__ = [
    "areas",
    "basis",
    "decay",
    "drawn",
    "error_growth",
    "graph",
    "graphs",
    "halving",
    "hodograph",
    "loci",
    "lower_curves",
    "segment",
    "show",
    "split",
    "stacked",
    "triangle",
]
