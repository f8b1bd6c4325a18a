"""The Bernstein functions of a degree to play with: their graphs, and their exact values at one t."""

from fractions import Fraction

import numpy as np

from ... import numeric
from ...display import number
from ..board import svg
from ..board.blocks import Block, html, name_of
from ..board.blocks import text as in_words
from ..board.marks import STYLES, Mark, Style
from .sliders import explorer, slider

DEGREES = tuple(range(7))
GRAPHS = (Style("first", 3), Style("second", 3, dash="12 7"), Style("ink", 3, dash="3 5"))
AXES, GUIDE = Style("ink", 1.6), Style("quiet", 1.6, dash="2 5")


def explore_basis(n=3, t=Fraction(1, 3)):
    """The Bernstein functions of a degree: sliders for degree and t, their graphs, their exact values and the sum.

    ``n`` from 0 to 6; ``t`` a multiple of 1/24 in [0, 1]. The sliders are ``.controls["n"]`` and ``.controls["t"]``.
    """
    controls = {"n": slider(n, "n, the degree", DEGREES), "t": slider(t, "t")}
    return explorer(controls, basis_view)


def basis_view(n, t):
    """What the explorer shows for degree n at t: {"svg", "html", "text"}."""
    values = numeric.bernstein(n, t)
    names = [name_of(i, letter="B") for i in range(n + 1)]
    rows = tuple((name, number(value)) for name, value in zip(names, values, strict=True))
    said = [Block(f"Degree {n} at t = {number(t)}", (*rows, ("sum", number(values.sum()))))]
    text = in_words(said)
    return {"svg": svg.picture(_marks(n, t, values, names), VIEW, text), "html": html(said), "text": text}


VIEW = (0, -0.12, 1, 1.06)


def _marks(n, t, values, names):
    peaks = [Fraction(i, n) if n else Fraction(1, 2) for i in range(n + 1)]
    tops = [(float(at), float(numeric.bernstein(n, at)[i])) for i, at in enumerate(peaks)]
    ticks = sorted({Fraction(0), Fraction(1), Fraction(t)})
    return [
        Mark("line", ((0, 1), (0, 0), (1, 0)), AXES),
        Mark("line", ((t, 0), (t, 1)), GUIDE),
        *[Mark("curve", _graph(row), GRAPHS[i % 3]) for i, row in enumerate(np.eye(n + 1))],
        Mark("dots", tuple((t, value) for value in values), STYLES["new"]),
        *[Mark("names", (top,), STYLES["new"], (name,)) for top, name in zip(tops, names, strict=True)],
        Mark("below", tuple((at, 0) for at in ticks), STYLES["new"], tuple(map(number, ticks))),
    ]


def _graph(coefficients):
    """The graph of a polynomial as a Bézier curve: by linear precision its control points stand at k/n."""
    heights = np.repeat(coefficients, 2) if len(coefficients) == 1 else coefficients
    return tuple(zip(np.linspace(0, 1, len(heights)).tolist(), heights.tolist(), strict=True))
