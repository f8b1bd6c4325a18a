"""Answers that nobody should give: objects that explode when they are touched, and texts made to break a reader."""

import array
import collections
import decimal
import enum
import fractions
import io
import sys
import types

import numpy as np
import sympy


class Touched(BaseException):
    """An answer's own code has run."""


def explode(*args, **kwargs):
    raise Touched


BASES = (object, int, float, str, list, tuple, fractions.Fraction)
KEPT = {"__new__", "__init__", "__class__", "__init_subclass__", "__subclasshook__", "__class_getitem__", "__slots__"}
KEPT |= {"__doc__", "__module__", "__dict__", "__weakref__", "__abstractmethods__", "__setattr__", "__hash__"}
DUNDERS = {name for base in BASES for name in dir(base) if name.startswith("__")} - KEPT | {"__array__", "__call__"}


def bomb(base, name="Bomb", **more):
    return type(name, (base,), dict.fromkeys(DUNDERS, explode) | more)


class Meta(type):
    """A class of classes that answers for everything itself."""

    def __instancecheck__(cls, other):
        raise Touched

    def __subclasscheck__(cls, other):
        raise Touched

    @property
    def __name__(cls):
        raise Touched


class Named(metaclass=Meta):
    @property
    def __class__(self):
        raise Touched


def built(kind, *args):
    """An object of a class of bombs, made without running any of its methods."""
    return kind.__base__.__new__(kind, *args)


def loop(of):
    one = of()
    one.append(one)
    return one


def deep(levels):
    one = []
    for _ in range(levels):
        one = [one]
    return one


def forged(numerator, denominator):
    """A Fraction whose parts are no numbers."""
    one = object.__new__(fractions.Fraction)
    if numerator is not None:
        one._numerator, one._denominator = numerator, denominator
    return one


class Colour(enum.Enum):
    RED = 1


class Whole(enum.IntEnum):
    ONE = 1


Pair = collections.namedtuple("Pair", "x y")

OBJECTS = {
    "a set": {1, 2},
    "a frozenset": frozenset([1]),
    "a dict": {"t": 1},
    "bytes": b"1/3",
    "a bytearray": bytearray(b"1"),
    "a memoryview": memoryview(b"1"),
    "a range": range(3),
    "a generator": (i for i in range(3)),
    "an endless generator": iter(int, 1),
    "a map": map(explode, [1]),
    "a zip": zip([1], [2], strict=True),
    "an iterator": iter([1, 2]),
    "a slice": slice(1, 2),
    "a function": explode,
    "a builtin": eval,
    "a type": int,
    "a module": sys,
    "an exception": ValueError("1"),
    "a complex number": 1 + 0j,
    "a Decimal": decimal.Decimal("0.5"),
    "a file": io.StringIO("1"),
    "a namespace": types.SimpleNamespace(x=1),
    "an enum": Colour.RED,
    "a whole enum": Whole.ONE,
    "NotImplemented": NotImplemented,
    "a deque": collections.deque([1, 2]),
    "a Counter": collections.Counter([1]),
    "an array": array.array("d", [1.0]),
    "a named tuple": Pair(1, 2),
    "numpy: an array": np.array([1, 2]),
    "numpy: floats": np.array([[0.5, 1.0]]),
    "numpy: objects": np.array([explode], dtype=object),
    "numpy: no axis": np.array(1.0),
    "numpy: empty": np.array([]),
    "numpy: records": np.zeros(2, dtype=[("x", "f8"), ("y", "i4")]),
    "numpy: text": np.array(["1"]),
    "numpy: dates": np.array(["2020-01-01"], dtype="datetime64[D]"),
    "numpy: masked": np.ma.masked_array([1, 2], [True, False]),
    "numpy: a float": np.float64(0.5),
    "numpy: a whole number": np.int64(3),
    "numpy: a bool": np.bool_(True),
    "sympy: a number": sympy.Rational(1, 3),
    "sympy: a symbol": sympy.Symbol("t"),
    "sympy: a matrix": sympy.Matrix([[1, 2]]),
    "sympy: nan": sympy.nan,
    "sympy: a class": sympy.Function,
    "a bomb": built(bomb(object)),
    "a bomb of an int": built(bomb(int), 1),
    "a bomb of a float": built(bomb(float), 0.5),
    "a bomb of a text": built(bomb(str), "1/3"),
    "a bomb of a list": built(bomb(list)),
    "a bomb of a tuple": built(bomb(tuple), (1, 2)),
    "a bomb of a fraction": object.__new__(bomb(fractions.Fraction)),
    "a class of bombs": bomb(object),
    "a class with a class of its own": Named,
    "an object without a class": object.__new__(Named),
    "a name with an escape": built(bomb(object, "\x1b[31mred")),
    "a name of a thousand letters": built(bomb(object, "A" * 1000)),
    "a name in other letters": built(bomb(object, "тип")),
    "a list of bombs": [built(bomb(object))],
    "a point of bombs": (0, built(bomb(float), 0.5)),
    "a list in itself": loop(list),
    "a list a hundred deep": deep(100),
    "a list three deep": [[[1]]],
    "an empty list": [],
    "a list of empty lists": [[], []],
    "a hundred numbers": list(range(100)),
    "sixty times sixty": [[0] * 60] * 60,
    "a million numbers": [0] * 10**6,
    "ragged": [(0, 0), (1,)],
    "a point among numbers": [0, (1, 1)],
    "a text among points": [(0, 0), "a"],
    "a fraction of nothing": forged(None, None),
    "a fraction of texts": forged("1", "3"),
    "a fraction of bombs": forged(built(bomb(int), 1), built(bomb(int), 3)),
    "a fraction by zero": forged(1, 0),
    "a fraction by less": forged(1, -3),
    "a fraction of floats": forged(1.0, 3.0),
    "a long number": 10**4000,
    "a long number below 0": -(10**40),
    "a long fraction": fractions.Fraction(1, 10**50),
    "nan": float("nan"),
    "inf": float("inf"),
    "less than -inf": float("-inf"),
    "True": True,
    "False and more": (False, 1),
    "True with a text": (True, "t = 1"),
    "a truth in a list": [True],
    "three truths": (True, True, True),
    "None in a point": (None, 1),
}

TEXTS = [
    "__import__('os').system('true')",
    "().__class__.__bases__[0].__subclasses__()",
    "lambda x: x",
    "[x for x in (1, 2)]",
    "open('/etc/passwd').read()",
    "exec('1')",
    "print(1)",
    "t.subs(t, 1)",
    "t.__class__",
    "t; t",
    "t if t else n",
    "import os",
    "f'{t}'",
    "{t}{n}",
    "'t'",
    '"t"',
    "`t`",
    "\\input{x}",
    "\\def\\x{\\x\\x}\\x",
    "\\write18{ls}",
    "9^9^9^9",
    "t^(9^9)",
    "((((t^200)^200)^200)^200)",
    "200!!!!",
    "99999!",
    "(10^30)!",
    "C(10^9, 10^8)",
    "B(10^9, 10^9, t)",
    "sum(i, i, 0, 10^40)",
    "sum(sum(sum(sum(i, i, 0, n), j, 0, n), k, 0, n), l, 0, n)",
    "integral(integral(integral(t, t, 0, 1), t, 0, 1), t, 0, 1)",
    "diff(t, t, 10^9)",
    "sqrt(" * 50 + "t" + ")" * 50,
    "(" * 300,
    ")" * 300,
    "(" * 300 + "t" + ")" * 300,
    "[" * 60 + "]" * 60,
    "-" * 1000 + "1",
    "+".join(["t"] * 1000),
    "1" * 2000,
    "1" * 5000,
    "0." + "1" * 100,
    "1/0",
    "0/0",
    "t/0",
    "0^0/0",
    "sqrt(-1)",
    "nan",
    "inf",
    "oo",
    "I",
    "1e400",
    "1e-400",
    "0x10",
    "1_000",
    "½",
    "１／３",
    "т",  # noqa: RUF001
    "t\u200b",
    "\u202et",
    "t\x00",
    "\ud800",
    "𝑡²",
    "😀",
    "\n",
    "\t",
    " ",
    "...",
    "…",
    ",",
    ",,",
    "()",
    "(,)",
    "(1,)",
    "(1,2",
    "1)",
    "=",
    "t =",
    "t = = t",
    "t = n = i",
    "t < n",
    "t != n",
    "t == t",
    "true:",
    "false: t",
    "false: t = t",
    "false: t = 1, t = 2",
    "false: t = 1/0",
    "false: t > 1",
    "false: n = 10^39",
    "true: t = 1",
    "b",
    "b[b[b[0]]]",
    "b_",
    "b[-1]",
    "b[10^9]",
    "E^E",
    "E^(10^9)",
    "g(g(t))",
    "B(t)",
    "B(i, n)",
    "B()",
    "sum()",
    "x" * 2001,
    "%s%s%n",
    "${jndi:ldap://x}",
    "<script>alert(1)</script>",
    "'; DROP TABLE students; --",
    "\\frac{1}{0}",
    "\\frac{1}",
    "\\sum_{i=0}",
    "\\begin{x}",
    "$$$$",
    "#",
    "t # a remark",
    "&&",
]
