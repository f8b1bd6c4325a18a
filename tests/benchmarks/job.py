"""What is measured: a job with its competitors and its bar, and the row that comes of it."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from time import process_time

import numpy as np


@dataclass(frozen=True)
class Job:
    """One thing that ours and the peers do, and the bar for the ratio of our time to theirs.

    ``check(answer)`` tells whether an answer is right; ``seen`` makes arrays of the answers of those peers that return
    something else. The bar is against the best peer or, with ``against``, against the best of those; None is no bar.
    An absolute bar is for our seconds.
    """

    name: str
    bar: float | None
    ours: Callable
    peers: Mapping[str, Callable]
    check: Callable
    against: tuple[str, ...] = ()
    seen: Mapping[str, Callable] = field(default_factory=dict)
    absolute: bool = False
    clock: Callable = process_time


@dataclass(frozen=True)
class Row:
    """One line of the table: what was measured of ours and of each peer, in seconds or in the unit that is named.

    The bar is for the ratio of ours to the best of ``against``; an absolute one is for ours. Peers with wrong answers
    are refused.
    """

    name: str
    ours: float
    others: Mapping[str, float] = field(default_factory=dict)
    against: tuple[str, ...] = ()
    bar: float | None = None
    absolute: bool = False
    unit: str = "s"
    refused: tuple[str, ...] = ()

    @property
    def best(self):
        """The name of the best peer, or None."""
        return min(self.others, key=self.others.get, default=None)

    @property
    def rival(self):
        """The name of the best of those peers that the bar is against, or None."""
        named = [name for name in self.against or self.others if name in self.others]
        return min(named, key=self.others.get, default=None)

    @property
    def ratio(self):
        """Ours to the rival's, or None."""
        return self.ours / self.others[self.rival] if self.rival and self.others[self.rival] else None

    @property
    def holds(self):
        """Whether the bar holds; None without a bar, and where the peer that it is against is missing."""
        value = self.ours if self.absolute else self.ratio
        return None if self.bar is None or value is None else bool(value <= self.bar)

    def record(self):
        """As a dictionary for JSON."""
        derived = {name: getattr(self, name) for name in ("best", "rival", "ratio", "holds")}
        return asdict(self) | derived


def near(expected, shape, places=slice(None), tolerance=1e-11):
    """A check: of this shape, all finite, and at the places (rows) within the tolerance of what is expected.

    The tolerance is relative to the largest of the expected numbers, or to 1.
    """
    right = np.asarray(expected, dtype=float)
    allowed = tolerance * max(1, abs(right).max())

    def check(answer):
        values = np.asarray(answer, dtype=float)
        return values.shape == shape and bool(
            np.isfinite(values).all() and abs(values[places] - right).max() <= allowed
        )

    return check


def same(expected):
    """A check: equal number for number."""
    return lambda answer: np.array_equal(np.asarray(answer, dtype=object), np.asarray(expected, dtype=object))
