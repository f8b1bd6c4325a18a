"""What can go wrong with a statement, each with its own name, because each leads to another verdict."""


class InvalidStatement(ValueError):
    """Not a statement: the message says what is wrong, and where."""


class Undefined(ArithmeticError):
    """The expression has no value at this point, such as 1/t at 0, or a basis function of degree -1."""


class Unsupported(ArithmeticError):
    """There may be a value, but the evaluator cannot name it exactly, or it is too large. Decides nothing."""


class OutOfTime(Exception):
    """The budget is spent."""


class ReplayFailed(Exception):
    """A proof that does not hold when it is checked again: the message names the first step that fails."""
