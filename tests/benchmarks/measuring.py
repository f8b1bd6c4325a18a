"""Checking answers and timing what gave them: interleaved, the median of several runs."""

import gc
from itertools import chain
from math import ceil
from statistics import median

from .job import Row

RUNS = 9  # medians are of so many, at least 7
SHORT = 0.004  # seconds that one run lasts at least, of repeated calls if one call is quicker
HOPELESS = 5  # a peer that takes so many times as long as the quickest is timed once


class WrongAnswer(Exception):
    """Our answer is not right, so its time means nothing."""


def measured(job, runs=RUNS):
    """The ``Row`` of a job. Every answer is looked at before any is timed; ``WrongAnswer`` if ours is not right."""
    if not right(job, "ours", job.ours):
        raise WrongAnswer(f"{job.name}: our own answer is wrong")
    peers = {name: run for name, run in job.peers.items() if right(job, name, run)}
    times = timed({"ours": job.ours, **peers}, runs, job.clock)
    return Row(
        job.name,
        times.pop("ours"),
        times,
        against=job.against,
        bar=job.bar,
        absolute=job.absolute,
        refused=tuple(name for name in job.peers if name not in peers),
    )


def right(job, name, run):
    """Whether a contender's answer is right; one that raises has none."""
    try:
        return bool(job.check(job.seen.get(name, lambda answer: answer)(run())))
    except Exception:
        if name == "ours":
            raise
        return False


def timed(contenders, runs, clock):
    """Median seconds of a call of each; they take turns, in turn backwards, so that drift and order favour nobody."""
    first = {name: seconds(run, 1, clock) for name, run in contenders.items()}
    counts = {name: max(1, ceil(SHORT / max(once, 1e-7))) for name, once in first.items()}
    quickest = min(first.values())
    serious = [name for name in contenders if first[name] <= HOPELESS * max(quickest, SHORT) or name == "ours"]
    found = {name: [] for name in serious}
    turns = chain.from_iterable(serious if turn % 2 else reversed(serious) for turn in range(runs))
    collecting = gc.isenabled()
    gc.disable()
    try:
        for name in turns:
            found[name].append(seconds(contenders[name], counts[name], clock))
    finally:
        if collecting:
            gc.enable()
    return first | {name: median(those) for name, those in found.items() if those}


def seconds(run, count, clock):
    """Seconds of a call, on average over so many."""
    began = clock()
    for _ in range(count):
        run()
    return (clock() - began) / count
