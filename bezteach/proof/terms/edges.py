"""Forms that may be negative where it matters: the caller looks at these few cases apart, which are the edges."""

from contextlib import contextmanager

from sympy import expand

from .linear import least
from .terms import Failure


class Edge(Exception):
    """The form may be negative, and it matters where it is; ``vanishing`` if the product it is found in is 0 there."""

    def __init__(self, form, vanishing):
        super().__init__(f"{form} may be negative")
        self.form, self.vanishing = form, vanishing


def need(form, conditions, vanishing=False):
    """Go on where a form is >= 0: return if it always is, raise ``Failure`` if it never is, else ``Edge``."""
    if least(form, conditions) >= 0:
        return
    if never(form, conditions):
        raise Failure(f"{form} is negative")
    raise Edge(expand(form), vanishing)


def never(form, conditions):
    """Whether the conditions make a form negative.

    >>> from bezteach.symbolic import i, n
    >>> never(i - n - 1, [n - i]), never(i - n, [n - i])
    (True, False)
    """
    return least(-form - 1, conditions) >= 0


@contextmanager
def one_of(count):
    """Around each of so many terms of a sum: where one of several is 0, the sum need not be."""
    try:
        yield
    except Edge as edge:
        raise Edge(edge.form, edge.vanishing and count == 1) from None
