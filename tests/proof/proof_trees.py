"""A second opinion: random trees, built as SymPy expressions for the engine, and written out by hand beside it."""

from hypothesis import strategies as st
from sympy import (
    Add,
    Derivative,
    Indexed,
    Integral,
    Mul,
    Pow,
    Product,
    Rational,
    S,
    Sum,
    binomial,
    diff,
    expand,
    integrate,
)

from bezteach.symbolic import B, b, i, n, t, u


def by_hand(node, at):
    """The value of a tree, with SymPy's own numbers, polynomials, ``diff`` and ``integrate`` on explicit terms."""
    kind, *parts = node
    if kind in ("symbol", "number"):
        return at.get(parts[0], parts[0]) if kind == "symbol" else parts[0]
    if kind == "point":
        return b[by_hand(parts[0], at)]
    if kind in ("sum", "product"):
        index, low, high, body = parts
        terms = [by_hand(body, {**at, index: S(k)}) for k in range(low, by_hand(high, at) + 1)]
        return Add(*terms) if kind == "sum" else Mul(*terms)
    if kind == "derivative":
        return expand(diff(expand(by_hand(parts[1], {**at, parts[0]: parts[0]})), parts[0])).subs(
            parts[0], at[parts[0]]
        )
    if kind == "integral":
        return integrate(expand(by_hand(parts[1], {**at, parts[0]: parts[0]})), (parts[0], 0, by_hand(parts[2], at)))
    values = [by_hand(part, at) for part in parts]
    if kind == "basis":
        index, degree, place = values
        inside = 0 <= index <= degree
        return binomial(degree, index) * place**index * (1 - place) ** (degree - index) if inside else S.Zero
    return {"add": Add, "mul": Mul, "power": Pow, "binomial": binomial}[kind](*values)


def built(node):
    """The same tree as one unevaluated SymPy expression."""
    kind, *parts = node
    if kind in ("symbol", "number"):
        return parts[0]
    if kind == "point":
        return Indexed(b, built(parts[0]))
    if kind in ("sum", "product"):
        index, low, high, body = parts
        return (Sum if kind == "sum" else Product)(built(body), (index, low, built(high)))
    if kind == "derivative":
        return Derivative(built(parts[1]), parts[0])
    if kind == "integral":
        return Integral(built(parts[1]), (parts[0], 0, built(parts[2])))
    make = {"add": Add, "mul": Mul, "power": Pow, "binomial": binomial, "basis": B}[kind]
    return make(*map(built, parts), evaluate=False) if make is not B else make(*map(built, parts))


WHOLE = st.sampled_from([("symbol", i), ("symbol", n), ("number", S(0)), ("number", S(2))]).flatmap(
    lambda node: st.sampled_from([node, ("add", node, ("number", S(-1))), ("add", node, ("symbol", i))])
)
DEGREES = st.sampled_from([("symbol", n), ("add", ("symbol", n), ("symbol", i)), ("number", S(2))])
REALS = st.sampled_from([("symbol", t), ("symbol", u), ("number", Rational(1, 3)), ("symbol", i)])
LEAVES = REALS | WHOLE | st.builds(lambda index: ("point", index), WHOLE)


def _grown(inner):
    return st.one_of(
        st.builds(lambda p, q: ("add", p, q), inner, inner),
        st.builds(lambda p, q: ("mul", p, q), inner, inner),
        st.builds(lambda p, q: ("power", p, ("number", S(q))), inner, st.integers(0, 3)),
        st.builds(lambda d, k: ("binomial", d, k), DEGREES, WHOLE),
        st.builds(lambda k, d, p: ("basis", k, d, p), WHOLE, DEGREES, REALS),
        st.builds(lambda low, high, body: ("sum", i, low, high, body), st.integers(-1, 2), WHOLE, inner),
        st.builds(lambda low, high, body: ("product", i, low, high, body), st.integers(1, 2), WHOLE, inner),
        st.builds(lambda name, body: ("derivative", name, body), st.sampled_from([t, u]), inner),
        st.builds(lambda name, body, high: ("integral", name, body, high), st.sampled_from([t, u]), inner, REALS),
    )


TREES = st.recursive(LEAVES, _grown, max_leaves=8)
