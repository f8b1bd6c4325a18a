"""Between the Bernstein basis and the power basis 1, t, ..., t^n: both matrices, and the coefficients of a curve.

As in ``curve``: call a function for its result, its ``steps`` for the lines.
"""

import math

from sympy import Add, IndexedBase, Integer, Matrix, Mul, Pow, Sum, Symbol, binomial, combsimp, sympify

from .basis import B
from .derivation import Step, derived, named, p, rewrite
from .operator import apply, binomial_theorem, step
from .symbols import E, b, i, j, k, t

COEFFICIENTS = IndexedBase("a")


@derived
def basis_matrix(n, *, descending=False):
    """The matrix M, (n+1) x (n+1), with [1 t ... t^n] M = [B_{0,n} ... B_{n,n}].

    ``descending`` turns the rows round, for the row [t^n ... t 1] that the notes use. n is an integer >= 0, else
    ``ValueError``. Source: deck, 1.1; games, "basis"; notes, 2.4.

    >>> basis_matrix(2)
    Matrix([
    [ 1,  0, 0],
    [-2,  2, 0],
    [ 1, -2, 1]])
    """
    n = _degree(n)
    yield from _curve_in_powers(n)
    rows, differences = [], [1]
    for power in range(n + 1):
        rows.append([math.comb(n, power) * c for c in differences] + [0] * (n - power))
        differences = [right - left for left, right in zip([*differences, 0], [0, *differences], strict=True)]
    why = "row k holds what stands before t to the power k: C(n, k) times the coefficients of (E - 1) to the power k"
    yield Step(Matrix(rows), why, Symbol("M"))
    if descending:
        yield Step(Matrix(rows[::-1]), "the highest power of t first", Symbol("M_desc"))


@derived
def power_matrix(n, *, descending=False):
    """The inverse of ``basis_matrix``: the matrix W with [B_{0,n} ... B_{n,n}] W = [1 t ... t^n].

    ``descending`` turns the columns round, for the row [t^n ... t 1]. n is an integer >= 0, else ``ValueError``.
    Source: deck, 1.2, property 10.

    >>> power_matrix(2)
    Matrix([
    [1,   0, 0],
    [1, 1/2, 0],
    [1,   1, 1]])
    """
    n = _degree(n)
    yield from _power_in_basis(n)
    rows = [[share(row, power, n) if power <= row else 0 for power in range(n + 1)] for row in range(n + 1)]
    yield Step(Matrix(rows), "column k: what multiplies each basis function", Symbol("W"))
    if descending:
        yield Step(Matrix([row[::-1] for row in rows]), "the highest power of t first", Symbol("W_desc"))


@derived
def to_power(n, power, points=b):
    """The coefficient a_k of t^k, k = ``power``, of the curve: C(n,k) (E - 1)^k b_0. Source: deck, 1.2, property 10.

    >>> from bezteach.symbolic import n
    >>> to_power(n, 1)
    n*(-b[0] + b[1])
    """
    n, power = sympify(n), sympify(power)
    yield from _curve_in_powers(n)
    operator = binomial(n, power) * (E - 1) ** power
    yield Step(operator * points[0], "what multiplies the power of t", named("a", power))
    yield Step(apply(operator, points), "expanded in E")


@derived
def from_power(n, index, coefficients=COEFFICIENTS):
    """The control point b_j, j = ``index``, of the curve with the coefficients a_k of t^k.

    Source: deck, 1.2, property 10.

    >>> from_power(2, 1)
    a[0] + a[1]/2
    """
    n, index = sympify(n), sympify(index)
    yield Step(Sum(coefficients[k] * t**k, (k, 0, n)), "the curve in powers", p(t))
    *_, (in_basis, *_) = _power_in_basis(n)
    yield Step(Sum(coefficients[k] * in_basis, (k, 0, n)), "each power in the Bernstein basis")
    point = Sum(share(j, k, n) * coefficients[k], (k, 0, j))
    yield Step(Sum(B(j, n, t) * point, (j, 0, n)), "the same terms, summed over k first: k is at most j")
    point = point.subs(j, index)
    yield Step(point, "what multiplies a basis function is its control point", named("b", index))
    if index.is_Integer:
        yield Step(point.doit(), "written out")


def share(j, k, n):
    """The coefficient of B(j, n, t) in t^k.

    >>> from sympy.abc import j, k, n
    >>> share(j, k, n)
    binomial(j, k)/binomial(n, k)
    """
    return binomial(j, k) / binomial(n, k)


def _curve_in_powers(n):
    """The lines that write the curve in powers of t."""
    whole, parted = step(t), 1 + t * (E - 1)
    yield Step(whole**n * b[0], "the curve in its operator form", p(t))
    yield Step(rewrite(whole**n, whole, parted) * b[0], "the step, ordered by powers of t")
    yield Step(binomial_theorem(Integer(1), t * (E - 1), n, k) * b[0], "binomial theorem")


def _power_in_basis(n):
    """The lines that write t^k in the Bernstein basis of degree n, for every k from 0 to n."""
    one = Add(1 - t, t, evaluate=False)
    yield Step(Mul(t**k, Pow(one, n - k, evaluate=False), evaluate=False), "times a power of one", t**k)
    expanded = binomial_theorem(1 - t, t, n - k, i)
    shifted = Sum(t**k * expanded.function, *expanded.limits).change_index(i, i + k, j).powsimp()
    yield Step(shifted, "binomial theorem; j = i + k")
    ratio = shifted.function / B(j, n, t).rewrite(binomial)
    if combsimp(ratio / share(j, k, n)) != 1:
        raise ArithmeticError(f"{ratio} is not {share(j, k, n)}")
    yield Step(Sum(share(j, k, n) * B(j, n, t), (j, k, n)), "each term is a multiple of a basis function")


def _degree(n):
    if isinstance(n, bool) or not isinstance(n, (int, Integer)) or n < 0:
        raise ValueError(f"degree {n}: a matrix needs an integer degree >= 0")
    return int(n)
