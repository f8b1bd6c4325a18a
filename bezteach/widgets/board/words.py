"""What a board says beside its picture, in exact numbers: for each layer shown some titled rows."""

from html import escape
from typing import NamedTuple

from ... import numeric
from ...display import number, point


class Block(NamedTuple):
    """Rows of cells under a title, all of them text."""

    title: str
    rows: tuple


def blocks(state):
    """The blocks of the layers shown, in their order; the control points come first."""
    said = [Block("Control points", (tuple(map(point, state.points)),))]
    for name in state.show:
        said += SAID[name](state) if name in SAID else []
    return said


def html(said):
    """Blocks as HTML."""
    return "".join(f"<b>{escape(title)}</b><table>{''.join(map(_row, rows))}</table>" for title, rows in said)


def _row(cells):
    return f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in cells)}</tr>"


def text(said):
    """Blocks in one line of words."""
    return "; ".join(f"{title}: {', '.join(' '.join(row) for row in rows)}" for title, rows in said)


def _levels(state):
    levels = numeric.de_casteljau(state.points, state.t)
    last = len(levels) - 1 if state.level is None else state.level
    size = len(levels[0])
    rows = tuple(tuple(point(levels[k][row - k]) for k in range(min(row, last) + 1)) for row in range(size))
    return [Block(f"De Casteljau's triangle at t = {number(state.t)}", rows)]


SAID = {"levels": _levels}
