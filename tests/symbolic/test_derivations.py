"""Every line of every derivation is true, and every result is the formula of the slides."""

import pytest
from sympy import Add, Indexed, IndexedBase, Rational, Sum, binomial, diff, expand, simplify, sqrt, symbols

from bezteach import symbolic
from bezteach.symbolic import E, b, j, k, n, t, u
from bezteach.symbolic.derivation import rewrite

a, c = symbols("a c", real=True)


def unrolled(expression):
    """Every sum written out, the outermost first, by nothing but substitution: an empty one is 0."""
    if isinstance(expression, Sum):
        *inner, (index, low, high) = expression.limits
        summand = Sum(expression.function, *inner) if inner else expression.function
        return Add(*[unrolled(summand.subs(index, value)) for value in range(low, high + 1)])
    return expression.func(*map(unrolled, expression.args)) if expression.has(Sum) else expression


def at_degree(line, values):
    """What a line says at a given degree, as a combination of b[0], b[1], ..."""
    terms = []
    for term in Add.make_args(expand(unrolled(line.subs(values)).doit())):
        scalar, power = term.as_coeff_exponent(E)
        points = scalar.atoms(Indexed)
        terms.append(scalar.subs({point: point.base[point.indices[0] + power] for point in points}))
    return expand(Add(*terms))


def bezier(degree, at, points=b):
    """The curve by its definition."""
    return Add(*[binomial(degree, i) * at**i * (1 - at) ** (degree - i) * points[i] for i in range(degree + 1)])


# name: (derivation for symbolic n, lowest degree it is for)
DERIVATIONS = {
    "curve": (symbolic.curve.steps(n, t), 0),
    "intermediate point": (symbolic.de_casteljau.steps(k, j, t), 0),
    "left half": (symbolic.segment.steps(n, j, 0, t), 0),
    "right half": (symbolic.segment.steps(n, j, t, 1), 0),
    "segment": (symbolic.segment.steps(n, j, a, c), 0),
    "segment backwards": (symbolic.segment.steps(n, j, Rational(3, 4), Rational(1, 4)), 0),
    "elevation": (symbolic.elevate.steps(n, j), 0),
    "elevation twice": (symbolic.elevate.steps(n, j, 2), 0),
    "derivative": (symbolic.derivative.steps(n, t), 1),
    "second derivative": (symbolic.derivative.steps(n, t, 2), 2),
    "derivative elsewhere": (symbolic.derivative.steps(n, a), 1),
    "hodograph": (symbolic.hodograph.steps(n, 1, j), 1),
    "third hodograph": (symbolic.hodograph.steps(n, 3, j), 3),
    "derivative at 0": (symbolic.end_derivative.steps(n, 2, 0), 2),
    "derivative at 1": (symbolic.end_derivative.steps(n, 3, 1), 3),
    "to powers": (symbolic.to_power.steps(n, k), 0),
    "from powers": (symbolic.from_power.steps(n, j), 0),
}


def chains(derivation):
    """The lines in groups of equal ones: a line with a left-hand side begins a new group."""
    groups = []
    for step in derivation:
        groups += [[]] if step.left is not None else []
        groups[-1].append(step.expression)
    return groups


@pytest.mark.parametrize(
    ("name", "degree"), [(name, degree) for name, (_, lowest) in DERIVATIONS.items() for degree in range(lowest, 5)]
)
def test_each_line_equals_the_one_before(name, degree):
    derivation, lowest = DERIVATIONS[name]
    for index in range(degree - lowest + 1):
        for lines in chains(derivation):
            first, *others = (at_degree(line, {n: degree, j: index, k: index}) for line in lines)
            assert others == [first] * len(others)


@pytest.mark.parametrize("degree", range(7))
def test_results_are_the_curve_again(degree):
    """The new control points, put into the definition of a curve, give what they are said to give."""

    def curve_of(control_points, at, m=degree):
        return expand(bezier(m, at).subs({b[i]: control_points(i) for i in range(m + 1)}, simultaneous=True))

    p = bezier(degree, t)
    assert curve_of(lambda i: symbolic.segment(degree, i, a, c), u) == expand(p.subs(t, (1 - u) * a + u * c))
    assert curve_of(lambda i: symbolic.elevate(degree, i, 2), t, degree + 2) == expand(p)
    assert expand(symbolic.curve(degree, t)) == expand(p)
    for r in range(degree + 2):
        derivative = diff(p, t, r) if r else p
        assert expand(symbolic.derivative(degree, t, r) - derivative) == 0
        assert curve_of(lambda i, r=r: symbolic.hodograph(degree, r, i), t, max(degree - r, 0)) == expand(derivative)
        for end in (0, 1):
            assert expand(symbolic.end_derivative(degree, r, end) - derivative.subs(t, end)) == 0
    powers = [symbolic.to_power(degree, i) for i in range(degree + 1)]
    assert expand(sum(power * t**i for i, power in enumerate(powers))) == expand(p)
    a_k = IndexedBase("a")
    assert curve_of(lambda i: symbolic.from_power(degree, i), t) == expand(
        sum(a_k[i] * t**i for i in range(degree + 1))
    )


def test_symbolic_degree_gives_the_slides_formulas():
    """The deck's end conditions, for every n."""
    assert symbolic.end_derivative(n, 0, 0) == b[0]
    assert symbolic.end_derivative(n, 0, 1) == b[n]
    assert symbolic.end_derivative(n, 1, 0) == n * (b[1] - b[0])
    assert symbolic.end_derivative(n, 1, 1) == n * (b[n] - b[n - 1])
    assert symbolic.end_derivative(n, 2, 0) == n * (n - 1) * (b[2] - 2 * b[1] + b[0])
    assert symbolic.end_derivative(n, 2, 1) == n * (n - 1) * (b[n] - 2 * b[n - 1] + b[n - 2])
    assert symbolic.elevate(n, 0) == b[0]
    assert symbolic.elevate(n, n + 1) == b[n]
    assert symbolic.de_casteljau(k, j, t).function == symbolic.B(symbolic.i, k, t) * b[symbolic.i + j]


def parametric_curvature(x, y):
    x1, y1, x2, y2 = diff(x, t), diff(y, t), diff(x, t, 2), diff(y, t, 2)
    return (x1 * y2 - y1 * x2) / sqrt(x1**2 + y1**2) ** 3


@pytest.mark.parametrize("end", [0, 1])
@pytest.mark.parametrize("degree", range(1, 6))
def test_end_curvature_is_that_of_the_parametrised_curve(degree, end):
    x, y = IndexedBase("x"), IndexedBase("y")
    numbers = {x[i]: Rational(i * i + 1, i + 2) for i in range(degree + 1)} | {
        y[i]: (-2) ** i for i in range(degree + 1)
    }
    curve = [bezier(degree, t, c).subs(numbers) for c in (x, y)]
    expected = parametric_curvature(*curve).subs(t, end)
    assert (degree == 1) == (expected == 0)
    for formula in (symbolic.end_curvature(degree, end), symbolic.end_curvature(n, end).subs(n, degree)):
        assert simplify(formula.subs(numbers) - expected) == 0
    assert simplify(symbolic.curvature(degree, t).subs(numbers).subs(t, end) - expected) == 0


@pytest.mark.parametrize("end", [0, 1])
def test_curvature_in_space_is_unsigned(end):
    """A plane arc that turns right, put into space."""
    x, y, z = map(IndexedBase, "xyz")
    numbers = {x[0]: 0, y[0]: 0, x[1]: 1, y[1]: 0, x[2]: 2, y[2]: -1, z[0]: 5, z[1]: 5, z[2]: 5}
    plane, space = (symbolic.end_curvature(2, end, dimension).subs(numbers) for dimension in (2, 3))
    assert plane < 0
    assert simplify(space + plane) == 0


def test_a_derivation_cannot_be_rewritten_into_a_falsehood():
    with pytest.raises(ValueError, match="is not equal to"):
        rewrite(symbolic.step(t) ** n, symbolic.step(t), 1 + t * E)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: symbolic.end_derivative(n, 1, 2), "at is 2: a curve ends at 0 and at 1"),
        (lambda: symbolic.end_derivative(n, -1, 0), "r is -1: "),
        (lambda: symbolic.hodograph(3, k, 0), "r is k: "),
        (lambda: symbolic.derivative(3, t, True), "r is True: "),
        (lambda: symbolic.elevate(3, 0, -1), "r is -1: "),
        (lambda: symbolic.curvature(3, t, 4), "dimension is 4: "),
        (lambda: symbolic.basis_matrix(-1), "degree -1: "),
        (lambda: symbolic.power_matrix(n), "degree n: "),
        (lambda: symbolic.basis_matrix(True), "degree True: "),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_a_notebook_shows_aligned_lines_with_reasons():
    steps = symbolic.segment.steps(n, j, 0, t)
    shown = steps._repr_latex_()
    assert shown.startswith("$$\\begin{aligned}")
    assert shown.count("&&") == len(steps) == 6
    assert r"\left[\left(1 - t\right) + t E\right]^{j} {b}_{0}" in shown
    assert repr(steps).splitlines()[-1] == "= Sum(B(i, j, t)*b[i], (i, 0, j))    (expanded in E)"
    assert steps[-1]._repr_latex_() == r"$\displaystyle = \sum_{i=0}^{j} B_{i,j}(t) {b}_{i}$"


def test_a_derivation_may_end_in_a_matrix():
    steps = symbolic.basis_matrix.steps(2)
    assert repr(steps).splitlines()[-1].startswith("M = Matrix([[1, 0, 0], [-2, 2, 0], [1, -2, 1]])    (row k holds")
    assert r"M &= \left[\begin{matrix}1 & 0 & 0\\-2" in steps._repr_latex_()
