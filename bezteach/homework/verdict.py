"""What is said to an answer."""

from typing import NamedTuple

CORRECT, PARTLY, WRONG = "CORRECT", "PARTLY", "WRONG"
INVALID, UNATTEMPTED, OPEN = "INVALID", "UNATTEMPTED", "OPEN"


class Verdict(NamedTuple):
    """A status and what to say.

    CORRECT; PARTLY: some parts are right, and which; WRONG; INVALID: no answer of the kind that is asked for, and what
    is wrong with it, where; UNATTEMPTED: still blank; OPEN: it could not be decided, and where both sides agree.
    """

    status: str
    feedback: str = ""
