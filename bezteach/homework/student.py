"""A student's name, which chooses the numbers."""

LONGEST = 60  # letters


def student_of(name):
    """The name as it counts: capitals and spaces make no difference. ``ValueError`` for what is no name.

    >>> student_of("Ada  Lovelace ")
    'ada lovelace'
    """
    if type(name) is not str or not name.strip() or len(name) > LONGEST:
        raise ValueError(f'a name is a text of 1 to {LONGEST} letters, such as "Ada"')
    return " ".join(name.lower().split())
