"""The lessons' pictures: data in, a matplotlib ``Figure`` out, whose label is its alternative text.

Every picture reads on a projector and in greyscale: what a colour tells, a dash or a marker tells too. Points are rows
of two numbers, exact or not. ``show`` puts a figure into a notebook as PNG and SVG, the same bytes from run to run.
"""

from .crossing import boxes, crossing, signs
from .curves import halving, loci, lower_curves, segment, split, triangle
from .derivatives import hodograph
from .elevation import elevated, lowered, raised, two_ways
from .errors import error_growth
from .fitting import clock, fitted, nudged, two_bases
from .functions import areas, bases, basis, decay, graph, graphs, stacked
from .joins import curvatures, reach
from .rational import nurbs, projection, pulled, quarter
from .scene import drawn
from .shape import beads, heights, moved
from .space import space
from .spline_functions import recursion, spline_basis
from .splines import inserted, knot_vectors, spans, ways
from .style import show

__all__ = [
    "areas",
    "bases",
    "basis",
    "beads",
    "boxes",
    "clock",
    "crossing",
    "curvatures",
    "decay",
    "drawn",
    "elevated",
    "error_growth",
    "fitted",
    "graph",
    "graphs",
    "halving",
    "heights",
    "hodograph",
    "inserted",
    "knot_vectors",
    "loci",
    "lower_curves",
    "lowered",
    "moved",
    "nudged",
    "nurbs",
    "projection",
    "pulled",
    "quarter",
    "raised",
    "reach",
    "recursion",
    "segment",
    "show",
    "space",
    "spans",
    "spline_basis",
    "signs",
    "split",
    "stacked",
    "triangle",
    "two_bases",
    "two_ways",
    "ways",
]
