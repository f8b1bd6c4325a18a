"""Equations of the course for every n, and all their one-edit mutants."""

from sympy import Derivative, Integer, Integral, Interval, Sum, Symbol, binomial, symbols

from bezteach.symbolic import B, E, b, i, j, k, n, r, step, t, u

a, c = symbols("a c", real=True)
m, l = (Symbol(name, integer=True, nonnegative=True) for name in "ml")  # noqa: E741
FROM_ONE = {n: (1, "oo")}


def given(ranges):
    from sympy import oo

    return {symbol: tuple(oo if end == "oo" else end for end in ends) for symbol, ends in ranges.items()}


CLAIMS = {
    "unity": (Sum(B(i, n, t), (i, 0, n)), Integer(1), {}),
    "linear precision": (Sum(i / n * B(i, n, t), (i, 0, n)), t, FROM_ONE),
    "linear precision from 1": (Sum(i / n * B(i, n, t), (i, 1, n)), t, FROM_ONE),
    "second moment": (Sum(i**2 / n**2 * B(i, n, t), (i, 0, n)), t**2 + t * (1 - t) / n, FROM_ONE),
    "variance": (Sum((i - n * t) ** 2 * B(i, n, t), (i, 0, n)), n * t * (1 - t), {}),
    "symmetry": (B(i, n, t), B(n - i, n, 1 - t), {i: (0, n)}),
    "recursion": (B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, t), FROM_ONE | {i: (0, n)}),
    "derivative": (Derivative(B(i, n, t), t), n * (B(i - 1, n - 1, t) - B(i, n - 1, t)), FROM_ONE | {i: (0, n)}),
    "second derivative": (
        Derivative(B(i, n, t), (t, 2)),
        n * (n - 1) * (B(i - 2, n - 2, t) - 2 * B(i - 1, n - 2, t) + B(i, n - 2, t)),
        {n: (2, "oo"), i: (0, n)},
    ),
    "elevation, first": ((1 - t) * B(i, n, t), (1 - i / (n + 1)) * B(i, n + 1, t), {i: (0, n)}),
    "elevation, second": (t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t), {i: (0, n)}),
    "elevation, third": (
        B(i, n, t),
        (1 - i / (n + 1)) * B(i, n + 1, t) + (i + 1) / (n + 1) * B(i + 1, n + 1, t),
        {i: (0, n)},
    ),
    "elevation by r": (
        B(i, n, t),
        Sum(binomial(n, i) * binomial(r, j - i) / binomial(n + r, j) * B(j, n + r, t), (j, i, i + r)),
        {i: (0, n)},
    ),
    "product": (
        B(i, n, t) * B(j, m, t),
        binomial(n, i) * binomial(m, j) / binomial(n + m, i + j) * B(i + j, n + m, t),
        {i: (0, n), j: (0, m)},
    ),
    "integral": (Integral(B(i, n, t), (t, 0, 1)), 1 / (n + 1), {i: (0, n)}),
    "gram": (
        Integral(B(i, n, t) * B(j, n, t), (t, 0, 1)),
        binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j) / (2 * n + 1),
        {i: (0, n), j: (0, n)},
    ),
    "to powers": (B(i, n, t), Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * t**j, (j, i, n)), {i: (0, n)}),
    "to powers, second form": (
        B(i, n, t),
        Sum((-1) ** (i + j) * binomial(n, i) * binomial(n - i, j - i) * t**j, (j, i, n)),
        {i: (0, n)},
    ),
    "from powers": (t**i, Sum(binomial(j, i) / binomial(n, i) * B(j, n, t), (j, i, n)), {i: (0, n)}),
    "subdivision": (B(i, n, c * u), Sum(B(i, j, c) * B(j, n, u), (j, 0, n)), {i: (0, n)}),
    "operator form": (Sum(B(i, n, t) * b[i], (i, 0, n)), step(t) ** n * b[0], {}),
    "de casteljau": (
        Sum(B(i, k, t) * b[i + j], (i, 0, k)),
        (1 - t) * Sum(B(i, k - 1, t) * b[i + j], (i, 0, k - 1)) + t * Sum(B(i, k - 1, t) * b[i + j + 1], (i, 0, k - 1)),
        {k: (1, "oo")},
    ),
    "left half": (
        Sum(B(j, n, u) * Sum(B(i, j, t) * b[i], (i, 0, j)), (j, 0, n)),
        Sum(B(i, n, t * u) * b[i], (i, 0, n)),
        {},
    ),
    "right half": (
        Sum(B(j, n, u) * Sum(B(i, n - j, t) * b[i + j], (i, 0, n - j)), (j, 0, n)),
        Sum(B(i, n, t + u - t * u) * b[i], (i, 0, n)),
        {},
    ),
    "segment": (
        Sum(B(j, n, u) * Sum(B(i, n - j, a) * Sum(B(l, j, c) * b[i + l], (l, 0, j)), (i, 0, n - j)), (j, 0, n)),
        Sum(B(i, n, (1 - u) * a + u * c) * b[i], (i, 0, n)),
        {},
    ),
    "hodograph": (
        Derivative(Sum(B(i, n, t) * b[i], (i, 0, n)), t),
        n * Sum(B(i, n - 1, t) * (b[i + 1] - b[i]), (i, 0, n - 1)),
        FROM_ONE,
    ),
    "elevated curve": (
        Sum(B(i, n, t) * b[i], (i, 0, n)),
        Sum(B(i, n + 1, t) * ((n + 1 - i) / (n + 1) * b[i] + i / (n + 1) * b[i - 1]), (i, 0, n + 1)),
        {},
    ),
    "differences": ((E - 1) ** r * b[i], Sum((-1) ** (r - k) * binomial(r, k) * b[i + k], (k, 0, r)), {}),
}


def mutants(expr):
    """Every expression that one edit makes: a number or an index moved by one, a sign turned, 1 - t for t."""
    seen = {expr}
    for mutant in _edited(expr):
        if mutant not in seen:
            seen.add(mutant)
            yield mutant


def some_mutants(lhs, rhs, name, every):
    """(left, right), one of both edited: every so many of all, the same each time, from another start for each name."""
    pairs = [(left, rhs) for left in mutants(lhs)] + [(lhs, right) for right in mutants(rhs)]
    return pairs[len(name) % every :: every]


def _edited(expr):
    if expr.is_Integer:
        yield from (expr + 1, expr - 1, -expr)
    elif expr.is_Symbol and expr != E:
        yield from (expr + 1, expr - 1) if expr.is_integer else (1 - expr, -expr)
    elif expr.args and not isinstance(expr, type(b[0])):
        for place, part in enumerate(expr.args):
            if place or not isinstance(expr, (Derivative, Interval)):
                yield from _with(expr, place, _edited_part(expr, part, place))
            else:
                yield from _with(expr, place, _edited(part))
        if expr.is_Add:
            for place, part in enumerate(expr.args):
                yield expr.func(*expr.args[:place], -part, *expr.args[place + 1 :])
    elif expr.args:
        for shifted in (expr.indices[0] + 1, expr.indices[0] - 1):
            yield expr.base[shifted]


def _edited_part(expr, part, place):
    if isinstance(expr, (Sum, Integral)) and place:
        index, low, high = part
        if isinstance(expr, Sum):
            yield from ((index, low + step, high) for step in (1, -1))
            yield from ((index, low, high + step) for step in (1, -1))
    elif not isinstance(expr, Derivative):
        yield from _edited(part)


def _with(expr, place, parts):
    for part in parts:
        try:
            yield expr.func(*expr.args[:place], part, *expr.args[place + 1 :])
        except (ValueError, TypeError, ZeroDivisionError):
            continue
