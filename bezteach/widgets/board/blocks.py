"""What is said beside a picture: titled rows of text, as HTML and in words."""

from decimal import Context, Decimal
from fractions import Fraction
from html import escape
from math import isqrt
from typing import NamedTuple

import numpy as np

from ...display import number, point

WIDTH = 6  # cells in a row of a list, at most
LINE = 64  # characters in it, with the gaps: so many stand beside the picture in a window of 1300 pixels
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class Block(NamedTuple):
    """Rows of cells under a title, all of them text."""

    title: str
    rows: tuple


def html(said):
    """Blocks as HTML.

    >>> html([Block("Box", (("x < 1", "y"),))])
    '<b>Box</b><table><tr><td>x &lt; 1</td><td>y</td></tr></table>'
    """
    return "".join(f"<b>{escape(title)}</b><table>{''.join(map(_row, rows))}</table>" for title, rows in said)


def _row(cells):
    return f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>"


def text(said):
    """Blocks in one line of words.

    >>> text([Block("Box", (("x", "[0, 1]"), ("y", "[2, 3]")))])
    'Box: x [0, 1], y [2, 3]'
    """
    return "; ".join(f"{title}: {', '.join(' '.join(row) for row in rows)}" for title, rows in said)


def cells(texts):
    """A list as rows that are not too long."""
    width = max(1, min(WIDTH, LINE // (2 + max(map(len, texts)))))
    return tuple(tuple(texts[i : i + width]) for i in range(0, len(texts), width))


def listed(points):
    """Points as rows that are not too long."""
    return cells([point(p) for p in points])


def exact_array(points):
    """Points as an array of exact numbers."""
    return np.array(points, dtype=object)


def name_of(i, level=0, letter="b"):
    """The name of a control point, or of one of a level of de Casteljau's.

    >>> name_of(12), name_of(0, 2)
    ('b₁₂', 'b₀²')
    """
    return letter + str(i).translate(SUBSCRIPTS) + (power(level) if level else "")


def power(exponent):
    """A whole number as it is written over the line."""
    return str(exponent).translate(SUPERSCRIPTS)


def root_of(square, sign=""):
    """The root of an exact number: exact if it is rational, else three digits, marked as such."""
    square = Fraction(square)
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if root * root == square:
        return number(-root if sign else root)
    exact = Context(prec=30)  # decimals, because a float ends at 1e308
    three = Context(prec=3).plus(exact.sqrt(exact.divide(Decimal(square.numerator), Decimal(square.denominator))))
    return f"about {sign}{three:{'f' if -5 <= three.adjusted() < 7 else 'e'}}"


def times(count):
    """How often."""
    return "once" if count == 1 else f"{count} times"
