"""Exact numbers, points and triangles as a reader sees them: LaTeX in a notebook, plain text elsewhere."""

import re
from fractions import Fraction
from html import escape
from urllib.parse import quote

import numpy as np


class Exact:
    """Something exact to look at: it prints as ``text``, a notebook typesets ``latex``."""

    def __init__(self, text, latex):
        self.text, self.latex = text, latex

    def __repr__(self):
        return self.text

    def _repr_latex_(self):
        return f"$\\displaystyle {self.latex}$"


class Page:
    """Prose with formulas to look at: it prints as ``text``, a notebook sets ``markdown``."""

    def __init__(self, text, markdown):
        self.text, self.markdown = text, markdown

    def __repr__(self):
        return self.text

    def _repr_markdown_(self):
        return self.markdown


def image(svg, words):
    """An SVG's text with its alternative text as ``text/html``.

    As ``image/svg+xml`` a picture has no words for those who cannot see it: JupyterLab and nbconvert write none, and
    nobody sees it in a notebook that is not trusted.

    >>> image("<svg/>", "a cubic")
    '<img alt="a cubic" src="data:image/svg+xml,%3Csvg/%3E">'
    """
    source = quote(svg, safe=" !()*,-./:;=@_~$+?")
    return f'<img alt="{escape(words)}" src="data:image/svg+xml,{source}">'


def escaped(words):
    """Words as they stand in Markdown: nothing in them is a mark-up or a formula.

    >>> print(escaped("b_0 * [t] < $1"))
    b\\_0 \\* \\[t\\] &lt; \\$1
    """
    return re.sub(r"([\\`*_{}\[\]#$|~])", r"\\\1", words).replace("<", "&lt;").replace(">", "&gt;")


def number(value):
    """An exact number as text.

    >>> number(Fraction(13, 9)), number(3), number(Fraction(-4, 2))
    ('13/9', '3', '-2')
    """
    return str(value)


def number_latex(value):
    """
    >>> print(number_latex(Fraction(-13, 9)), number_latex(3))
    -\\tfrac{13}{9} 3
    """
    value = Fraction(value)
    if value.denominator == 1:
        return str(value.numerator)
    return rf"{'-' if value < 0 else ''}\tfrac{{{abs(value.numerator)}}}{{{value.denominator}}}"


def point(p):
    """A point, shape (d,), as text; a coordinate alone, without parentheses.

    >>> point((1, Fraction(5, 3)))
    '(1, 5/3)'
    """
    return f"({', '.join(map(number, p))})" if np.ndim(p) else number(p)


def point_latex(p):
    if not np.ndim(p):
        return number_latex(p)
    return r"\left(" + r",\,".join(map(number_latex, p)) + r"\right)"


def points(control_points, name="b"):
    """Control points, shape (n+1, d), one beside the other.

    >>> points([(0, 0), (Fraction(1, 3), 1)], "c")
    c_0 = (0, 0)   c_1 = (1/3, 1)
    """
    text = "   ".join(f"{name}_{i} = {point(p)}" for i, p in enumerate(control_points))
    latex = r" \qquad ".join(rf"{name}_{{{i}}} = {point_latex(p)}" for i, p in enumerate(control_points))
    return Exact(text, latex)


def triangle(levels, upto=None):
    """De Casteljau's triangle, a column a level, as the deck prints it; ``upto`` hides the levels after that one.

    The first points of the levels, the left half's control points, are boxed; the last ones, the right half's,
    underlined.

    >>> from bezteach import de_casteljau
    >>> triangle(de_casteljau([0, 3, 1], Fraction(1, 3)))
    0
    3  1
    1  7/3  13/9
    """
    shown = levels[: len(levels) if upto is None else upto + 1]
    size = len(levels[0])
    rows = [[level[row - k] if row >= k else None for k, level in enumerate(shown)] for row in range(size)]
    text = "\n".join("  ".join(point(p) for p in row if p is not None) for row in rows)
    columns = [[_marked(p, row == k, row == size - 1) for k, p in enumerate(cells)] for row, cells in enumerate(rows)]
    body = r" \\[1ex] ".join(" & ".join(cells) for cells in columns)
    return Exact(text, rf"\begin{{array}}{{{'c' * len(shown)}}} {body} \end{{array}}")


def _marked(p, first, last):
    if p is None:
        return ""
    latex = point_latex(p)
    latex = rf"\underline{{{latex}}}" if last else latex
    return rf"\boxed{{{latex}}}" if first else latex


def formula(expression, name=None):
    """A SymPy expression as the course writes it; ``name``, an expression too, stands on the left of an equals sign.

    >>> from bezteach.symbolic import n, step, t
    >>> formula(step(t) ** n)
    (E*t - t + 1)**n
    """
    from .symbolic import latex

    if name is None:
        return Exact(str(expression), latex(expression))
    return Exact(f"{name} = {expression}", f"{latex(name)} = {latex(expression)}")


def lines(expressions):
    """The lines of a chain of equalities, numbered and without their reasons, for a reader to judge.

    >>> from bezteach.symbolic import t
    >>> lines([(1 - t) ** 2, 1 - t**2])
    1.   (1 - t)**2
    2. = 1 - t**2
    """
    from .symbolic import latex

    rows = [(number, " " if number == 1 else "=", line) for number, line in enumerate(expressions, 1)]
    text = "\n".join(f"{number}. {sign} {line}" for number, sign, line in rows)
    body = r" \\[1ex] ".join(rf"{number}. & \quad {sign} {latex(line)}" for number, sign, line in rows)
    return Exact(text, rf"\begin{{aligned}} {body} \end{{aligned}}")
