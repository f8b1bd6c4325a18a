"""Do the cases of a proof cover the whole range? Decided from the inequalities alone, not from how they were found."""

from sympy import expand

from ..errors import ReplayFailed
from ..terms.linear import impossible, is_whole_form, least


def check_covered(conditions, parts):
    """``ReplayFailed`` unless each integer point where the conditions are >= 0 lies in one of the parts.

    >>> from bezteach.proof.certificate import Part
    >>> from bezteach.symbolic import i, n
    >>> check_covered([i, n - i], [Part(((i, n),)), Part((), (n - i - 1,))])
    >>> check_covered([i, n - i], [Part((), (n - i - 1,))])
    Traceback (most recent call last):
    ...
    bezteach.proof.errors.ReplayFailed: no case covers the points where i >= 0, -i + n >= 0, i - n >= 0
    """
    rows = sorted(map(forms_of, parts), key=len)
    found = _uncovered(list(conditions), rows)
    if found is not None:
        raise ReplayFailed("no case covers the points where " + ", ".join(f"{form} >= 0" for form in found))


def forms_of(part):
    """The forms that are >= 0 exactly where a point lies in the part; a value is two of them."""
    forms = list(part.where)
    for symbol, at in part.values:
        forms += [expand(symbol - at), expand(at - symbol)]
    for form in forms:
        if not is_whole_form(form):
            raise ReplayFailed(f"the case {form} >= 0 is no linear form of integers")
    return forms


def _uncovered(conditions, cases):
    """Conditions of a region that no case covers, or None.

    An integer form is >= 0 or <= -1: what the first case leaves out is cut along its forms, one after the other.
    """
    if impossible(conditions):
        return None
    if not cases:
        return conditions
    first, *others = cases
    held = conditions
    for form in first:
        if least(form, held) >= 0:
            continue
        found = _uncovered([*held, expand(-form - 1)], others)
        if found is not None:
            return found
        held = [*held, form]
    return None
