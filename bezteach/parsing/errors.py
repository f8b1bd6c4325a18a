"""The one exception that reading a formula raises, and one that never leaves the reader."""


class InvalidAnswer(ValueError):
    """What is wrong with a text, in one line; ``position`` is the character, counted from 1, where it goes wrong.

    >>> raise InvalidAnswer("a bracket is missing", 3)
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: character 3: a bracket is missing
    """

    def __init__(self, message, position=None):
        super().__init__(message if position is None else f"character {position}: {message}")
        self.position = position


class BelowZero(Exception):
    """A sum over the letter ``name`` may begin below 0: the text is read again, and nothing is assumed of its sign."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name
