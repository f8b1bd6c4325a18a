"""Questions that a lesson asks before it answers: what is asked, how an answer is read and judged, what is said to it.

Pure data and functions; ``widgets.ask`` puts a question on the screen. The right answers are computed, never stored,
and feedback names the mistake without telling the answer.
"""

from . import basis, splitting
from .asking import Choice, Entry, Goal, judge, read

QUESTIONS = basis.QUESTIONS | splitting.QUESTIONS
GOALS = splitting.GOALS

__all__ = ["GOALS", "QUESTIONS", "Choice", "Entry", "Goal", "judge", "read"]
