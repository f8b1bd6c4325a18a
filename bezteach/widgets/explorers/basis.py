"""The Bernstein functions of a degree to play with: their graphs, and their exact values at one t."""

from fractions import Fraction

import numpy as np

from .. import numeric
from ..display import number
from ..palette import FIRST, INK, QUIET, SECOND
from . import picture
from .explorers import SUBSCRIPTS, explorer, table

DEGREES = range(7)
_DASHES = ("", "12 7", "3 5")


def explore_basis(n=3, t=Fraction(1, 3)):
    """The Bernstein functions of a degree: sliders for degree and t, their graphs, their exact values and the sum.

    ``n`` from 0 to 6; ``t`` a multiple of 1/24 in [0, 1]. The sliders are ``.controls["n"]`` and ``.controls["t"]``.
    """
    return explorer({"n": (n, "n, the degree", DEGREES), "t": (t, "t")}, basis_view)


def basis_view(n, t):
    """What the explorer shows for degree n at t: {"svg", "html", "text"}."""
    values = numeric.bernstein(n, t)
    names = [f"B{str(i).translate(SUBSCRIPTS)}" for i in range(n + 1)]
    peaks = [Fraction(i, n) if n else Fraction(1, 2) for i in range(n + 1)]
    ticks = sorted({Fraction(0), Fraction(1), Fraction(t)})
    layers = [
        picture.polygon([(0, 1), (0, 0), (1, 0)], INK, marker=""),
        picture.polygon([(t, 0), (t, 1)], QUIET, dash="2 5", marker=""),
        *[
            picture.curve(_graph(row), (FIRST, SECOND)[i % 2], dash=_DASHES[i % 3], width=3)
            for i, row in enumerate(np.eye(n + 1))
        ],
        picture.dots([(t, value) for value in values], INK),
        picture.words([(at, numeric.bernstein(n, at)[i]) for i, at in enumerate(peaks)], names, -16),
        picture.words([(at, 0) for at in ticks], list(map(number, ticks)), 20),
    ]
    rows = [(name, number(value)) for name, value in zip(names, values, strict=True)]
    total = number(values.sum())
    text = f"n = {n}, t = {number(t)}: {', '.join(f'{name} = {value}' for name, value in rows)}; sum {total}"
    html = table(f"Degree {n} at t = {number(t)}", [*rows, ("<b>sum</b>", f"<b>{total}</b>")])
    return {"svg": picture.picture([(0, 0), (1, 1)], layers, text), "html": html, "text": text}


def _graph(coefficients):
    """The graph of a polynomial as a Bézier curve: by linear precision its control points stand at k/n."""
    heights = np.repeat(coefficients, 2) if len(coefficients) == 1 else coefficients
    return np.column_stack([np.linspace(0, 1, len(heights)), heights])
