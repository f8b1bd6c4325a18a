"""The formulas of a Bézier curve, each derived from the operator form.

Call a function for its result, its ``steps`` for the lines. n is an integer or a symbol, t and the other parameters any
expressions, ``points`` the ``IndexedBase`` of the control points. The names are those of ``bezteach.numeric``: run on
symbols, that module returns what is derived here.
"""

from functools import partial

from sympy import Integer, Sum, Symbol, binomial, combsimp, sympify

from .basis import B
from .derivation import Step, derived, named, p, rewrite
from .operator import apply, binomial_theorem, step, tidy
from .symbols import E, b, i, t, u


@derived
def curve(n, t, points=b):
    """The curve p(t) = g(t)^n b_0, its points weighted by the Bernstein basis. Source: deck, 1.1 and 2.1.

    >>> from bezteach.symbolic import n, t
    >>> curve(n, t)
    Sum(B(i, n, t)*b[i], (i, 0, n))
    >>> curve(2, t)
    t**2*b[2] + 2*t*(1 - t)*b[1] + (1 - t)**2*b[0]
    """
    yield Step(step(t) ** n * points[0], "n steps of de Casteljau's algorithm, from the first point", p(t))
    yield Step(apply(step(t) ** n, points), "binomial theorem, and E to the power i takes the first point to point i")


@derived
def de_casteljau(k, j, t, points=b):
    """The intermediate point b_j^k of level k, j of de Casteljau's triangle. Source: deck, 2.1.

    >>> from bezteach.symbolic import j, k, t
    >>> de_casteljau(k, j, t)
    Sum(B(i, k, t)*b[i + j], (i, 0, k))
    """
    yield Step(step(t) ** k * E**j * points[0], "k steps, begun at point j", named("b", j, k))
    yield Step(apply(step(t) ** k * E**j, points), "binomial theorem")


@derived
def segment(n, j, start, end, points=b):
    """The control point c_j of the part over [start, end]; splitting is [0, t] and [t, 1]. Source: deck, 2.3.

    The new curve runs over u in [0, 1]; the lines show that its control points are g(start)^(n-j) g(end)^j b_0.

    >>> from bezteach.symbolic import j, n, t
    >>> segment(n, j, 0, t)
    Sum(B(i, j, t)*b[i], (i, 0, j))
    >>> segment(2, 1, 0, t)
    t*b[1] + (1 - t)*b[0]
    """
    start, end, n, j = map(sympify, (start, end, n, j))
    position = (1 - u) * start + u * end
    whole, blend = step(position), (1 - u) * step(start) + u * step(end)
    line = whole**n * points[0]
    yield Step(line, "the curve at the parameter that u stands for", p(position))
    if whole != blend:
        line = rewrite(line, whole, blend)
        yield Step(line, "a step is linear in its parameter")
    place = Symbol("j", integer=True, nonnegative=True)
    yield Step(
        binomial_theorem((1 - u) * step(start), u * step(end), n, place) * points[0],
        "binomial theorem",
    )
    operator = step(start) ** (n - place) * step(end) ** place
    yield Step(Sum(B(place, n, u) * operator * points[0], (place, 0, n)), "a Bernstein basis function in u appears")
    operator = operator.subs(place, j)
    yield Step(operator * points[0], "what multiplies it is the new control point", named("c", j))
    yield Step(apply(operator, points), "expanded in E")


@derived
def elevate(n, j, r=1, points=b):
    """The control point c_j of the same curve written with degree n + r; r is an integer >= 0.

    Both b_{-1} and b_{n+1} come with the factor 0. Source: deck, 1.2; notes, 2.3.3.

    >>> from bezteach.symbolic import j, n
    >>> elevate(n, j)
    j*b[j - 1]/(n + 1) + (-j + n + 1)*b[j]/(n + 1)
    >>> elevate(1, 1)
    b[0]/2 + b[1]/2
    """
    if isinstance(r, bool) or not isinstance(r, (int, Integer)) or r < 0:
        raise ValueError(f"r is {r}: how often a curve is elevated is an integer >= 0")
    n, j = sympify(n), sympify(j)
    point = points.__getitem__
    yield Step(Sum(B(i, n, t) * point(i), (i, 0, n)), "the curve as it is given", p(t))
    for degree in range(r):
        yield from _elevate_once(n + degree, point)
        point = partial(_elevated, n + degree, point)
    yield Step(point(j), "the new control point", named("c", j))


def _elevate_once(n, point):
    basis = B(i, n, t)
    yield Step(Sum(((1 - t) * basis + t * basis) * point(i), (i, 0, n)), "one is (1 - t) + t")
    stay, move = _share((1 - t) * basis, B(i, n + 1, t)), _share(t * basis, B(i + 1, n + 1, t))
    yield Step(
        Sum((stay * B(i, n + 1, t) + move * B(i + 1, n + 1, t)) * point(i), (i, 0, n)),
        "each half is a multiple of one function of the next degree",
    )
    yield Step(
        Sum(_elevated(n, point, i) * B(i, n + 1, t), (i, 0, n + 1)),
        "i - 1 in place of i in the second half; the terms added at the ends are 0",
    )


def _elevated(n, point, j):
    """What multiplies B(j, n+1, t) when the halves of the function at j and of its left neighbour are gathered."""
    stay = _share((1 - t) * B(i, n, t), B(i, n + 1, t)).subs(i, j)
    move = _share(t * B(i, n, t), B(i + 1, n + 1, t)).subs(i, j - 1)
    return stay * point(j) + move * point(j - 1)


def _share(part, whole):
    """The rational number that a multiple of a basis function is of another one."""
    return tidy(combsimp((part / whole).rewrite(binomial)))
