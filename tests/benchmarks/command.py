"""The command: which jobs are run, in which order, and what is printed."""

import argparse
import re
import sys
from dataclasses import replace
from itertools import chain

from . import accuracy, bsplines, clock, evaluation, exact, growth, parts, report
from .measuring import RUNS, WrongAnswer, measured

SUBJECTS = {"evaluation": evaluation, "parts": parts, "bsplines": bsplines, "exact": exact, "clock": clock}


def parser():
    """The options."""
    found = argparse.ArgumentParser(prog="python tests/benchmarks", description=__doc__)
    found.add_argument("pattern", nargs="?", default="", help="a regular expression: only what has it in its name")
    found.add_argument("--runs", type=int, default=RUNS, help="medians are of so many runs, at least 7")
    found.add_argument("--json", metavar="FILE", help="write all numbers there, too; - instead of the table")
    found.add_argument("--plot", metavar="PNG", help="draw how the cost grows into this file")
    found.add_argument("--long", action="store_true", help="time the whole ledger and all tests as well")
    found.add_argument("--small", action="store_true", help="try the jobs at small sizes, where the bars mean nothing")
    return found


def main(arguments=None):
    """Run what is asked for; 0 if all bars hold, 1 if one is missed, 2 if our own answer was wrong."""
    options = parser().parse_args(arguments)
    if options.runs < 7 and not options.small:
        parser().error("--runs: a median of at least 7 is needed")
    said = sys.stderr if options.json == "-" else sys.stdout
    print(*report.head(), sep="\n", file=said, flush=True)
    wanted = re.compile(options.pattern).search
    wrong = []
    timed = list(noted(speed(options, wanted, wrong)))
    grown = list(grow(options, wanted))
    rounded = [row for row in accuracy.rows(options.small) if wanted(row.name)]
    costs = [*timed, *(growth.row(series, times) for series, times in grown)]
    rows = [*(replace(row, bar=None) if options.small else row for row in costs), *rounded]
    if options.plot and grown:
        growth.plotted(grown, options.plot)
    print("", *report.table(rows), sep="\n", file=said)
    if rounded:
        print("", *report.errors(rounded), sep="\n", file=said)
    print(*wrong, sep="\n", file=said)
    written(options.json, rows)
    return 2 if wrong else int(any(row.holds is False for row in rows))


def speed(options, wanted, wrong):
    """The rows of all jobs that are wanted, as they come; ``wrong`` is told of those where our own answer is wrong."""
    for job in chain.from_iterable(subject.jobs(options.small) for subject in SUBJECTS.values()):
        if wanted(job.name):
            try:
                yield measured(job, options.runs)
            except WrongAnswer as problem:
                wrong.append(problem)
    if options.long:
        yield from (clock.whole(name) for name in clock.long_commands() if wanted(name))


def grow(options, wanted):
    """The lines of growth that are wanted."""
    for series in growth.all_series():
        if wanted(f"growth of {series.name}"):
            yield series, growth.line(series, options.runs, options.small)


def noted(rows):
    """The rows; each is named on standard error when it is there, because all of them take a while."""
    for number, row in enumerate(rows, 1):
        print(f"\r{number:4} {row.name:60.60}", end="", file=sys.stderr, flush=True)
        yield row
    print(file=sys.stderr)


def written(file, rows):
    """The rows as JSON, to a file or to standard output."""
    if file == "-":
        print(report.as_json(rows))
    elif file:
        with open(file, "w", encoding="utf-8") as out:
            out.write(report.as_json(rows) + "\n")
