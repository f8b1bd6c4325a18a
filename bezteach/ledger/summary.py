"""The ledger's counts for the README: ``python -m bezteach.ledger.summary`` judges everything and writes them there."""

import sys
from collections import Counter
from pathlib import Path

from .report import counts

BEGIN, END = "<!-- ledger: written by python -m bezteach.ledger.summary -->\n", "<!-- end of ledger -->\n"


def summary(results, readings, slips):
    """The counts as Markdown: claims by status, false neighbours, and for each source its statements and slips."""
    kinds = Counter((slip.source, slip.slip.kind) for slip in slips)
    rows = [
        f"| {source} | {len(rows)} | {kinds[source, 'refuted']} | {kinds[source, 'amended']} |\n"
        for source, rows in readings.items()
    ]
    return (
        ". ".join(counts(results)) + ".\n\n"
        "| source | statements | misprints refuted | loose ones amended |\n|---|---|---|---|\n" + "".join(rows)
    )


def written_into(readme, text):
    """The README with the text in its place; ``ValueError`` if the marks of the place are not there."""
    before, mark, rest = readme.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not mark or not end:
        raise ValueError("the README has lost the marks between which the ledger's counts stand")
    return before + BEGIN + text + END + after


def main():
    from bezteach.ledger import READINGS, errata, judge, matching

    path = Path(__file__).parents[2] / "README.md"
    text = summary([judge(id) for id in matching()], READINGS, errata())
    path.write_text(written_into(path.read_text(encoding="utf-8"), text), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
