"""The homework, a set for each lesson: its data, the book's or drawn for a student, and its questions."""

from random import Random

from . import (
    b_splines,
    basis_properties,
    curve_properties,
    de_casteljau,
    definitions,
    derivatives,
    elevation,
    joining,
    operator,
    rational,
    splitting,
    why_bernstein,
)

SETS = {
    "01-why-bernstein": why_bernstein.SET,
    "02-definitions": definitions.SET,
    "03-basis-properties": basis_properties.SET,
    "04-curve-properties": curve_properties.SET,
    "05-de-casteljau": de_casteljau.SET,
    "06-operator": operator.SET,
    "07-derivatives": derivatives.SET,
    "08-splitting": splitting.SET,
    "09-degree-elevation": elevation.SET,
    "10-joining": joining.SET,
    "11-b-splines": b_splines.SET,
    "12-ahead-rational": rational.SET,
}
MOST_DRAWS = 1000
QUESTIONS = {f"{name}/{short}": (name, one) for name, part in SETS.items() for short, one in part.questions.items()}


def data_of(name, student=None):
    """The data of a set (a dictionary): the book's, or those of this student, which are the same every time.

    Data that cannot tell the right answers and the known mistakes from one another are drawn again. ``ValueError`` if
    that happens again and again: then the set is wrong.
    """
    part = SETS[name]
    if student is None:
        return part.book
    chance = Random(f"{name}:{student}")
    for _ in range(MOST_DRAWS):
        data = part.draw(chance)
        if all(question.apart(data) for question in part.questions.values()):
            return data
    raise ValueError(f"{name} draws no data that tell the answers apart")
