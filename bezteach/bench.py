"""What anyone states, as text: one statement is proved or refuted, several lines are judged as a derivation."""

import re

from .parsing import InvalidAnswer, parse, parse_given
from .proof import check_derivation, prove

EXAMPLE = "t*B(i,n,t) = (i+1)/(n+1)*B(i+1,n+1,t)"


def judge(text, given=""):
    """The ``Verdict`` on the one line of a text, or the ``Judgement`` of its lines, each equal to the one before.

    ``given`` has the ranges, such as "n >= 1, 0 <= t <= 1". A line of a derivation may begin with its equals sign. What
    cannot be read is an ``InvalidAnswer`` that names the line and the character.

    >>> judge("sum(B(i,n,t), i, 0, n) = 1").status
    'PROVED'
    >>> judge('''u B(i,n,u)
    ... = (i+1)/n * B(i+1,n+1,u)
    ... = (i+1)/(n+1) * B(i+1,n+1,u)''', "n >= 1, 0 <= i <= n").first_wrong
    2
    >>> judge("sum(B(i,n,t), i, 0, n)")
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: this is no statement: write an equation or inequality, such as \
t*B(i,n,t) = (i+1)/(n+1)*B(i+1,n+1,t)
    """
    ranges = parse_given(given) if given.strip() else None
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
    if len(lines) < 2:
        return prove(_statement(text.strip()), given=ranges)
    return check_derivation([_line(number, line) for number, line in lines], given=ranges)


def _statement(text):
    statement = parse(text)
    if isinstance(statement, tuple) and any(getattr(part, "is_Relational", False) for part in statement):
        raise InvalidAnswer("these are several statements: have each judged alone")
    if not getattr(statement, "is_Relational", False):
        raise InvalidAnswer(f"this is no statement: write an equation or inequality, such as {EXAMPLE}")
    return statement


def _line(number, line):
    """The expression in a line; the equals sign in front becomes a space, so that places stay as they are."""
    if sign := re.match(r"\s*==?", line):
        line = " " * sign.end() + line[sign.end() :]
    try:
        expression = parse(line)
    except InvalidAnswer as error:
        raise InvalidAnswer(f"line {number}, {error}") from None
    if isinstance(expression, tuple) or expression.is_Relational:
        raise InvalidAnswer(f"line {number} is no formula: in a derivation each line is one, equal to the one before")
    return expression
