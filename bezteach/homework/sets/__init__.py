"""The homework, a set for each lesson: its data, the book's or drawn for a student, and its questions."""

from random import Random

from . import curve_properties, definitions, derivatives, elevation, splitting

SETS = {
    "02-definitions": definitions.SET,
    "04-curve-properties": curve_properties.SET,
    "07-derivatives": derivatives.SET,
    "08-splitting": splitting.SET,
    "09-degree-elevation": elevation.SET,
}
QUESTIONS = {f"{name}/{short}": (name, one) for name, part in SETS.items() for short, one in part.questions.items()}


def data_of(name, student=None):
    """The data of a set (a dictionary): the book's, or those of this student, which are the same every time.

    Data that cannot tell a right answer from a known mistake are drawn again.
    """
    part = SETS[name]
    if student is None:
        return part.book
    chance = Random(f"{name}:{student}")
    while True:
        data = part.draw(chance)
        if all(question.apart(data) for question in part.questions.values()):
            return data
