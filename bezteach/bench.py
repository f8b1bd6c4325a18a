"""What anyone states, as text: one statement is proved or refuted, several lines are judged as a derivation."""

import re

from .parsing import InvalidAnswer, parse, parse_given, without_sign
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
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
    if len(lines) < 2:
        integers = without_sign(text.strip())
        return prove(_statement(text.strip()), given=_ranges(given, integers))
    formulas = [(number, _without_equals_sign(line)) for number, line in lines]
    integers = frozenset().union(*(_in_line(number, without_sign, line) for number, line in formulas))
    return check_derivation(
        [_formula(number, line, integers) for number, line in formulas], given=_ranges(given, integers)
    )


def _ranges(given, integers):
    return parse_given(given, integers) if given.strip() else None


def _statement(text):
    statement = parse(text)
    if isinstance(statement, tuple) and any(getattr(part, "is_Relational", False) for part in statement):
        raise InvalidAnswer("these are several statements: have each judged alone")
    if not getattr(statement, "is_Relational", False):
        raise InvalidAnswer(f"this is no statement: write an equation or inequality, such as {EXAMPLE}")
    return statement


def _without_equals_sign(line):
    """A line with the equals sign in front made a space, so that places stay as they are."""
    sign = re.match(r"\s*==?", line)
    return " " * sign.end() + line[sign.end() :] if sign else line


def _in_line(number, read, *arguments):
    try:
        return read(*arguments)
    except InvalidAnswer as error:
        raise InvalidAnswer(f"line {number}, {error}") from None


def _formula(number, line, integers):
    expression = _in_line(number, parse, line, integers)
    if isinstance(expression, tuple) or expression.is_Relational:
        raise InvalidAnswer(f"line {number} is no formula: in a derivation each line is one, equal to the one before")
    return expression
