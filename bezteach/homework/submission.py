"""The answers in a student's notebook, read from its syntax tree: nothing that a student wrote is ever run."""

import ast
import json
import operator
from fractions import Fraction
from typing import NamedTuple

LARGEST = 64_000_000  # bytes of a notebook
LONGEST = 50_000  # characters of a cell
CALLS = ("start", "check")
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}
DIGITS = 40


class NotRead(ValueError):
    """Why a notebook, or an answer in it, cannot be read; one line."""


class Submission(NamedTuple):
    """The name of ``start``, or None, and for each id of ``check`` its answer, or the ``NotRead`` in its place."""

    student: str | None
    answers: dict


def submission(content):
    """The ``Submission`` that the bytes of a notebook hold; ``NotRead`` if they are no notebook.

    >>> cell = {"cell_type": "code", "source": ['start("Ada")\\n', 'check("08-splitting/local", 1/3)']}
    >>> submission(json.dumps({"nbformat": 4, "cells": [cell]}).encode())
    Submission(student='Ada', answers={'08-splitting/local': Fraction(1, 3)})
    """
    names, answers, unread = [], {}, 0
    for source in _sources(content):
        try:
            calls = list(_calls(source))
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            unread += 1
            continue
        for name, arguments in calls:
            if name == "start":
                names.append(_name(arguments))
            else:
                id, answer = _checked(arguments)
                answers[id] = NotRead("this question is answered twice: keep one of them") if id in answers else answer
    if unread and not answers:
        raise NotRead(f"{unread} of its cells are no Python, and no answer is in the others")
    if len({*names}) > 1:
        raise NotRead("start is called with different names: keep one of them")
    return Submission(names[0] if names else None, answers)


def _sources(content):
    """The texts of the code cells."""
    if not content.strip():
        raise NotRead("the file is empty")
    if len(content) > LARGEST:
        raise NotRead(f"the file has {len(content) / 1e6:.0f} MB: {LARGEST / 1e6:.0f} are read; clear its outputs")
    try:
        book = json.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as problem:
        raise NotRead(f"byte {problem.start + 1} is no UTF-8: the file is no notebook, or damaged") from None
    except json.JSONDecodeError as problem:
        raise NotRead(f"line {problem.lineno} is no JSON: the file is no notebook, or damaged") from None
    except (RecursionError, ValueError):
        raise NotRead("its JSON is nested or long beyond measure") from None
    if not isinstance(book, dict) or book.get("nbformat") != 4 or not isinstance(book.get("cells"), list):
        raise NotRead("it is no notebook of format 4: save it with JupyterLab")
    for cell in book["cells"]:
        if isinstance(cell, dict) and cell.get("cell_type") == "code":
            source = cell.get("source", "")
            parts = source if isinstance(source, list) else [source]
            if all(isinstance(part, str) for part in parts) and sum(map(len, parts)) <= LONGEST:
                yield "".join(parts)


def _calls(source):
    """(name, positional and named arguments) of each call of start or check that stands alone in a line."""
    lines = [line if not line.lstrip().startswith(("%", "!")) else "" for line in source.split("\n")]
    for statement in ast.parse("\n".join(lines)).body:
        call = statement.value if isinstance(statement, ast.Expr) else None
        if isinstance(call, ast.Call):
            name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", None)
            if name in CALLS:
                yield name, call.args + [keyword.value for keyword in call.keywords]


def _name(arguments):
    """The name that start is given; None stands for the book's numbers."""
    name = literal(arguments[0]) if arguments else None
    if name is not None and type(name) is not str:
        raise NotRead("the name given to start is no text")
    return name


def _checked(arguments):
    id = arguments[0].value if arguments and isinstance(arguments[0], ast.Constant) else None
    if not isinstance(id, str):
        return None, NotRead("a check without the id of a question")
    if len(arguments) != 2:
        return id, ... if len(arguments) == 1 else NotRead("a check has the id and one answer")
    try:
        return id, literal(arguments[1])
    except (NotRead, RecursionError) as problem:
        return id, NotRead(str(problem) if isinstance(problem, NotRead) else "the answer is nested beyond measure")


def literal(node):
    """The value of a syntax tree that is written out: numbers, texts, lists, fractions; quotients stay exact.

    >>> literal(ast.parse("[(0, 1/3), (Fraction(-2, 3), 2*3 - 0.5)]", mode="eval").body)
    [(0, Fraction(1, 3)), (Fraction(-2, 3), 5.5)]
    >>> literal(ast.parse("f(1)", mode="eval").body)
    Traceback (most recent call last):
    bezteach.homework.submission.NotRead: "f(1)" cannot be read without running it: write the answer out
    """
    if isinstance(node, ast.Constant) and type(node.value) in (int, float, str, bool, type(None), type(...)):
        return _short(node.value)
    if isinstance(node, ast.Tuple | ast.List):
        return (tuple if isinstance(node, ast.Tuple) else list)(map(literal, node.elts))
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
        value = _number(node.operand)
        return -value if isinstance(node.op, ast.USub) else value
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        return _computed(type(node.op), _number(node.left), _number(node.right))
    if isinstance(node, ast.Call) and getattr(node.func, "id", None) in ("Fraction", "F") and not node.keywords:
        return _fraction([_number(argument) for argument in node.args])
    raise NotRead(f'"{ast.unparse(node)[:60]}" cannot be read without running it: write the answer out')


def _number(node):
    value = literal(node)
    if type(value) not in (int, float, Fraction):
        raise NotRead(f'"{ast.unparse(node)[:60]}" is no number')
    return value


def _computed(kind, one, other):
    if kind is ast.Div:
        if other == 0:
            raise NotRead("a division by zero")
        return one / other if float in (type(one), type(other)) else Fraction(one) / Fraction(other)
    return _short(OPERATORS[kind](one, other))


def _fraction(parts):
    if len(parts) not in (1, 2) or any(type(part) not in (int, Fraction) for part in parts):
        raise NotRead("a Fraction has one or two whole numbers")
    if len(parts) == 2 and parts[1] == 0:
        raise NotRead("a division by zero")
    return Fraction(*parts)


def _short(value):
    if type(value) in (int, Fraction) and max(abs(value.numerator), value.denominator) >= 10**DIGITS:
        raise NotRead(f"a number has more than {DIGITS} digits")
    return value
