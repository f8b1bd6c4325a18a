"""The ledger: one claim for every statement of the four sources, with its proof, and what the sources print wrongly.

``claims/`` holds the mathematics, a module a subject, written with the ``forms``; ``sources/`` reads each source in its
own order and names the claim that stands at each place. ``judge`` gives the verdict on a claim, ``show`` displays it
with its steps, ``errata`` lists the slips.
"""

from difflib import get_close_matches
from fnmatch import fnmatch
from functools import cache

from . import errata as _errata
from .claims import CLAIMS as _ALL
from .judging import Judged, judged
from .show import errata_shown, erratum_shown, shown
from .show import proof as _proof
from .sources import READINGS

CLAIMS = {claim.id: claim for claim in _ALL}

__all__ = [
    "CLAIMS",
    "READINGS",
    "Judged",
    "errata",
    "judge",
    "matching",
    "places",
    "proof",
    "show",
    "show_errata",
    "show_slip",
    "slip",
]


def judge(id):
    """The verdict on the claim with this id; ``ValueError`` names the nearest ones if there is none.

    >>> judge("basis/unity").status
    'PROVED'
    """
    if id not in CLAIMS:
        near = ", ".join(get_close_matches(str(id), CLAIMS)) or "bezteach.ledger.CLAIMS has them all"
        raise ValueError(f"there is no claim {id!r}: {near}")
    return _judged(id)


@cache  # arguments refer to the same few claims again and again
def _judged(id):
    return judged(CLAIMS[id], lambda other: other in CLAIMS and _judged(other).settled)


def show(id, *, steps=True):
    """A claim with its places in the sources, its verdict and the steps of its proof, to look at in a notebook.

    Without ``steps`` only what it says, where, and its verdict.

    >>> show("basis/symmetry", steps=False)
    basis/symmetry: the i-th from the left is the mirror image of the i-th from the right
      deck, 1.2, basis property 3, symmetry
      games, properties, symmetry
      notes, 2.3.1, symmetry
      B(i, n, t) = B(-i + n, n, 1 - t)   for 0 <= i <= n
    PROVED (ratio of terms)
    """
    return shown(judge(id), places(id), steps)


def proof(id):
    """The lines of a claim's proof with their reasons, a ``symbolic.Derivation``, for ``widgets.walk``.

    >>> proof("basis/symmetry")[-1]
    = 0    (it is 0 for all values)
    """
    return _proof(judge(id))


def slip(source, id, place=None):
    """The slip in what a source prints at a claim, the first of several or that in this place.

    >>> slip("deck", "basis/recursion/proof").kind
    'refuted'
    >>> slip("transcript", "bspline/corner", "multiple knots, corners").kind
    'refuted'

    ``ValueError`` if it prints it rightly, and, with a place, names those where it does not.
    """
    found = {row.place: row.slip for row in READINGS[source] if row.claim == id and row.slip}
    if not found:
        raise ValueError(f"{source} has no slip at {id!r}")
    if place not in (None, *found):
        raise ValueError(f"{source} has no slip at {id!r} in {place!r}: there is {'; '.join(found)}")
    return next(iter(found.values())) if place is None else found[place]


def errata():
    """The slips of the sources, in their order, each with its counterexample or reason: ``Erratum`` tuples."""
    return list(_errata.errata(READINGS, CLAIMS))


def show_errata(source, kind):
    """The slips of one source, "refuted" or "amended" ones, to look at in a notebook."""
    return errata_shown(slip for slip in _errata.errata({source: READINGS[source]}, CLAIMS) if slip.slip.kind == kind)


def show_slip(source, id, place=None):
    """What a source prints wrongly at a claim, and why it will not do, to look at; ``ValueError`` as in ``slip``.

    >>> show_slip("games", "joins/g1")
    games, joins, G1  [refuted]
      printed  G1: the three points are on one line
      fails    P_{n-1} = (1, 0), P_n = Q_0 = (0, 0), Q_1 = (1, 0) are on one line, and the tangent turns round: \
P_n must lie strictly between the two others
    """
    wrong = slip(source, id, place)
    rows = [row for row in READINGS[source] if row.slip is wrong]
    return erratum_shown(next(_errata.errata({source: rows}, CLAIMS)))


def places(id):
    """[(source, place)] of a claim, in the sources' order.

    >>> places("basis/unity")[0][0]
    'deck'
    """
    return [(source, row.place) for source, rows in READINGS.items() for row in rows if row.claim == id]


def matching(pattern=None, source=None):
    """The ids of claims in the sources' order, those that no source states at the end.

    ``pattern`` is a part of an id or has wildcards, ``source`` is a source's short name.

    >>> matching("basis/un*")[0]
    'basis/unity'
    """
    rows = [row.claim for name, rows in READINGS.items() if source in (None, name) for row in rows]
    ids = dict.fromkeys(rows + ([] if source else list(CLAIMS)))
    return [id for id in ids if pattern is None or pattern in id or fnmatch(id, pattern)]
