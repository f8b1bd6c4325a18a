"""The one exception that reading a formula raises."""


class InvalidAnswer(ValueError):
    """What is wrong with a text, in one line; ``position`` is the character, counted from 1, where it goes wrong.

    >>> raise InvalidAnswer("a bracket is missing", 3)
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: character 3: a bracket is missing
    """

    def __init__(self, message, position=None):
        super().__init__(message if position is None else f"character {position}: {message}")
        self.position = position
