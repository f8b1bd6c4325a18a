"""Seconds to spend, passed down to everything that loops: no signals, no threads, so it works in a notebook too."""

from time import perf_counter

from .errors import OutOfTime


class Budget:
    """So many seconds from now on. ``spend`` is called once a turn of every loop, and raises OutOfTime at the end.

    >>> Budget(3600).spend()
    >>> Budget(0).spend()
    Traceback (most recent call last):
    ...
    bezteach.proof.errors.OutOfTime
    """

    def __init__(self, seconds):
        if isinstance(seconds, bool) or not isinstance(seconds, int | float) or seconds != seconds:
            raise ValueError(f"the budget is {seconds!r}: a number of seconds is needed")
        self.begin = perf_counter()
        self.end = self.begin + seconds

    @property
    def spent(self):
        return perf_counter() - self.begin

    def part(self, share):
        """A budget of its own: a share of the seconds that are left."""
        return Budget(max(0.0, share * (self.end - perf_counter())))

    def spend(self):
        if perf_counter() >= self.end:
            raise OutOfTime
