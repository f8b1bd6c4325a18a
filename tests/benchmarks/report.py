"""The report: which peers are there and which are not, the table of rows, and the table of errors."""

import json
import os
import platform

import numpy as np

from . import peers

TIMES = ((1, "s"), (1e-3, "ms"), (1e-6, "µs"))
WORDS = {True: "holds", False: "MISSED", None: ""}


def head(found=None, missing=None):
    """Lines about the machine and the peers."""
    found, missing = peers.found if found is None else found, peers.missing if missing is None else missing
    here = ", ".join(f"{name} {number}" for name, number in peers.versions(found).items())
    lines = [
        f"Python {platform.python_version()}, NumPy {np.__version__}, {os.cpu_count()} cores; peers: {here or 'none'}"
    ]
    return lines + [f"NOT INSTALLED, so not compared: {name} ({why})" for name, why in missing.items()]


def quantity(value, unit="s"):
    """A number with its unit, in three digits."""
    if value is None:
        return ""
    if unit != "s":
        return f"{value:.3g} {unit}"
    factor, name = next((pair for pair in TIMES if value >= pair[0]), TIMES[-1])
    return f"{value / factor:.3g} {name}"


def line(row):
    """The cells of a row."""
    best = f"{quantity(row.others[row.best], row.unit)} {row.best}" if row.best else ""
    bar = "" if row.bar is None else quantity(row.bar, row.unit) if row.absolute else f"{row.bar:g}"
    return [row.name, quantity(row.ours, row.unit), best, ratio(row), bar, verdict(row)]


def ratio(row):
    """The ratio in two digits, with the peer's name where that is not the best one."""
    if row.ratio is None or row.absolute:
        return ""
    return f"{row.ratio:.2f}" + (f" of {row.rival}" if row.rival != row.best else "")


def verdict(row):
    """Whether the bar holds, or why that is not known, in a word."""
    if row.bar is not None and row.holds is None:
        return f"? {' or '.join(row.against) or 'a peer'} is not there"
    return WORDS[row.holds]


HEADINGS = ["job", "ours", "best peer", "ratio", "bar", ""]


def aligned(cells):
    """Rows of cells as lines with columns."""
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in cells]


def table(rows):
    """The rows as lines, and how many bars hold."""
    lines = aligned([HEADINGS, *map(line, rows)])
    judged = [row for row in rows if row.holds is not None]
    refused = [f"refused, the answer is wrong: {name} at {row.name}" for row in rows for name in row.refused]
    return [*lines, *refused, "", f"{sum(row.holds for row in judged)} of {len(judged)} bars hold"]


def errors(rows):
    """The errors in a table of their own: a line for each way, a column for each degree."""
    found = {}
    for row in rows:
        way, degree = row.name.removeprefix("error of ").rsplit(", ", 1)
        found.setdefault(f"ours: {way}", {})[degree] = row.ours
        for name, value in row.others.items():
            found.setdefault(name, {})[degree] = value
    degrees = list(dict.fromkeys(degree for of in found.values() for degree in of))
    body = [[way, *(f"{of[d]:.3g}" if d in of else "" for d in degrees)] for way, of in found.items()]
    return aligned([["largest error in u max|b|", *degrees], *body])


def as_json(rows):
    """The same for programs."""
    record = {
        "python": platform.python_version(),
        "numpy": np.__version__,
        "peers": peers.versions(peers.found),
        "missing": peers.missing,
        "rows": [row.record() for row in rows],
    }
    return json.dumps(record, indent=1)
