"""Questions that a lesson asks before it answers: what is asked, how an answer is read and judged, what is said to it.

Pure data and functions; ``widgets.ask`` puts a question on the screen. The right answers are computed, never stored,
and feedback names the mistake without telling the answer.
"""

from . import (
    basis,
    bspline_tasks,
    bsplines,
    casteljau,
    curve,
    definitions,
    derivatives,
    elevation,
    joining,
    operator,
    rational,
    splitting,
    start,
    why,
)
from .asking import Choice, Entry, Goal, judge, read

LESSONS = (
    start,
    why,
    definitions,
    basis,
    curve,
    casteljau,
    operator,
    derivatives,
    splitting,
    elevation,
    joining,
    bsplines,
    bspline_tasks,
    rational,
)
QUESTIONS = {name: question for lesson in LESSONS for name, question in lesson.QUESTIONS.items()}
GOALS = {name: goal for lesson in LESSONS for name, goal in getattr(lesson, "GOALS", {}).items()}

__all__ = ["GOALS", "QUESTIONS", "Choice", "Entry", "Goal", "judge", "read"]
