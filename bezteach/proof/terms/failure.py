"""What a method says of a statement that it cannot prove."""


class Failure(Exception):
    """The statement is beyond this method; it says nothing of its truth."""
