"""The letters of the course, with what is assumed of each, so that a lesson can import them ready to use."""

from sympy import IndexedBase, Symbol, symbols

i, j, k, n, r = symbols("i j k n r", integer=True, nonnegative=True)
t, u = symbols("t u", real=True)
b = IndexedBase("b")
E = Symbol("E")
