"""Where the lessons show what the sources show: each worked example and each topic of a picture, with lesson and cell.

The pictures are lost in the sources' texts; what they were of is listed here, with the call that a lesson draws it by.
"""

import json
from typing import NamedTuple

from .display import Page, escaped
from .examples import EXAMPLES
from .setup.workspace import lessons_source

LESSONS = lessons_source()
MOST = 3  # cells named in the table for one thing


class Picture(NamedTuple):
    """What a source draws; ``lesson`` by the start of its name, and ``code`` that a cell of it holds."""

    source: str
    place: str
    about: str
    lesson: str
    code: str


class Shown(NamedTuple):
    """Something of a source, and the (lesson, In number) of the cells that show it."""

    source: str
    place: str
    about: str
    cells: tuple


PICTURES = (
    Picture("deck", "1.1", "relative vectors, head to tail", "02", 'display.points(vectors, "a")'),
    Picture("deck", "1.1", "Bézier's own basis", "02", "figures.graphs(sums)"),
    Picture("deck", "1.1", "the cubic Bernstein basis", "02", "figures.basis(3)"),
    Picture("deck", "1.2", "end points and end tangents", "04", "widgets.explore_tangents("),
    Picture("deck", "1.2", "a line through curve and polygon", "04", "widgets.explore_crossings("),
    Picture("deck", "1.2", "a concave polygon with a convex curve", "04", "widgets.explore_quartic("),
    Picture("deck", "1.2", "a straight segment as a curve", "04", "figures.beads("),
    Picture("deck", "1.2", "a control point moved", "04", "figures.moved("),
    Picture("deck", "2.1", "three tangents", "05", "widgets.explore_tangents("),
    Picture("deck", "2.1", "the triangle of intermediate points", "05", "display.triangle("),
    Picture("deck", "2.1", "the construction at t = 1/3, step by step", "05", "figures.triangle("),
    Picture("deck", "2.1", "a curve as a blend of two lower ones", "05", "figures.lower_curves("),
    Picture("deck", "2.1", "the paths of the intermediate points", "06", "figures.loci("),
    Picture("deck", "2.2", "the hodograph", "07", "figures.hodograph("),
    Picture("deck", "2.2", "curvature at the ends", "07", "widgets.explore_curvature("),
    Picture("deck", "2.3", "a cubic split at t = 1/3", "08", "figures.split("),
    Picture("deck", "2.3", "the part of a cubic over [1/4, 3/4]", "08", "figures.segment("),
    Picture("deck", "2.3", "polygons of ever shorter pieces", "08", "figures.halving("),
    Picture("games", "fitting", "samples and a curve fitted to them", "01", "figures.fitted("),
    Picture("games", "power basis", "a parabola with its coefficients as points", "01", "figures.two_bases("),
    Picture("games", "two kinds of modelling", "one function, moved in both bases", "01", "widgets.explore_powers("),
    Picture("games", "Bernstein basis", "the bases of the degrees 0 to 4", "02", "figures.bases("),
    Picture("games", "another example", "a quadratic, with dots at equal steps of t", "01", "figures.clock("),
    Picture("games", "Bézier curves", "a cubic and its control polygon", "04", "widgets.Board("),
    Picture("games", "Bézier curves", "a more complicated curve", "04", "figures.moved("),
    Picture("games", "curves in space", "a curve in space", "02", "figures.space("),
    Picture("games", "elevation", "the same curve with one point more", "09", "figures.elevated("),
    Picture("games", "de Casteljau", "repeated convex combinations", "05", "widgets.explore_casteljau("),
    Picture("games", "de Casteljau", "a point, and both parts of the curve", "08", "widgets.explore_split("),
    Picture("games", "joins", "C0, G1 and C1", "10", 'show=("polygon", "pieces")'),
    Picture("games", "joins", "similar triangles at a C2 join", "10", 'GOALS["joining/close-the-frame"]'),
    Picture("games", "splines", "interpolating cubics from chords", "10", "widgets.explore_spline("),
    Picture("notes", "2.1", "where an explicit or implicit form fails", "01", 'ledger.show("implicit/slope")'),
    Picture("notes", "2.2.1", "an example of de Casteljau's algorithm", "05", "figures.triangle("),
    Picture("notes", "2.2.1", "the algorithm as pseudo-code, and its cost", "05", "rounding.multiplications("),
    Picture("notes", "2.3", "the basis of a curve", "02", "figures.basis(3)"),
    Picture("notes", "2.3.3", "degree elevation", "09", "widgets.explore_elevation("),
    Picture("notes", "2.3.4", "subdivision", "08", "figures.split("),
    Picture("notes", "2.3.5", "curve range: box and hull", "08", "figures.boxes("),
    Picture("transcript", "Bernstein basis", "the bases of low degree", "02", "figures.bases("),
    Picture("transcript", "joining Bézier curves", "two cubics that meet", "10", "widgets.explore_join("),
    Picture("transcript", "joining Bézier curves", "control points beside a data point", "10", "joins.catmull_rom("),
    Picture("transcript", "B-splines", "one point moved: global and local", "11", '"one Bézier curve", "B-spline"'),
    Picture("transcript", "B-spline basis functions", "the recursion from degree 0 on", "11", "figures.recursion("),
    Picture("transcript", "B-spline basis functions", "functions with their supports", "11", "figures.spline_basis("),
    Picture("transcript", "B-spline curves", "hulls of p + 1 points", "11", "figures.spans("),
    Picture("transcript", "B-spline curves", "a knot inserted", "11", "figures.inserted("),
    Picture("transcript", "knot vectors", "uniform, clamped, non-uniform", "11", "figures.knot_vectors("),
    Picture("transcript", "multiple knots", "a sharp corner", "11", 'GOALS["bsplines/corner"]'),
)


def shown():
    """A ``Shown`` for each example and each picture, in the order of the sources; without cells where there is a gap.

    >>> [one.cells[0][0] for one in shown() if one.about.startswith("a cubic split at t = 1/3: ")]
    ['02']
    """
    cells = list(_cells())
    found = [
        Shown(one.source, one.place, one.about, _holding(cells, f'EXAMPLES["{one.id}"]')) for one in EXAMPLES.values()
    ]
    found += [Shown(one.source, one.place, one.about, _holding(cells, one.code, one.lesson)) for one in PICTURES]
    order = list(dict.fromkeys(one.source for one in found))
    return sorted(found, key=lambda one: order.index(one.source))


def table():
    """What the sources show, and where the lessons do, as a table to look at."""
    text, rows = [], ["| source | place | example or picture | lesson: In [ ] |", "|---|---|---|---|"]
    for one in shown():
        where = ", ".join(f"{lesson}: {number}" for lesson, number in one.cells[:MOST])
        text.append(f"{one.source}, {one.place}: {one.about} ({where})")
        rows.append(f"| {one.source} | {escaped(one.place)} | {escaped(one.about)} | {where} |")
    return Page("\n".join(text), "\n".join(rows))


def stored():
    """(lesson, cell, its text) of every cell of the numbered lessons, read as JSON: nbformat takes a second to load."""
    for path in sorted(LESSONS.glob("[0-9][0-9]-*.ipynb")):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            yield path.stem[:2], cell, "".join(cell["source"])


def _cells():
    """(lesson, In number, source) of every code cell that was run."""
    for lesson, cell, source in stored():
        if cell.get("execution_count"):
            yield lesson, cell["execution_count"], source


def _holding(cells, code, lesson=""):
    return tuple((name, number) for name, number, source in cells if code in source and name.startswith(lesson))
