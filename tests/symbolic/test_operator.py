"""The shift operator, the step, and the Bernstein function as SymPy objects."""

from math import comb

import pytest
from sympy import Add, I, Matrix, Rational, S, Sum, binomial, diff, expand, eye, nan, pi, sin, symbols

from bezteach.symbolic import B, E, apply, b, basis_matrix, i, j, latex, n, power_matrix, step, t

m = symbols("m", integer=True, nonnegative=True)


def test_the_step_is_linear_interpolation_of_neighbours():
    assert expand(step(t) - ((1 - t) + t * E)) == 0
    assert apply(step(t)) == (1 - t) * b[0] + t * b[1]
    assert apply(E**3 * step(Rational(1, 3))) == Rational(2, 3) * b[3] + Rational(1, 3) * b[4]


def test_apply_on_numbers_of_the_slide():
    """The cubic (0,0) (1,3) (2,1) (3,3) at 1/3: three steps give (1, 5/3)."""
    points = [Matrix([0, 0]), Matrix([1, 3]), Matrix([2, 1]), Matrix([3, 3])]
    assert apply(step(Rational(1, 3)) ** 3, points) == Matrix([1, Rational(5, 3)])
    assert apply(E * step(Rational(1, 3)) ** 2, points) == Matrix([Rational(5, 3), Rational(19, 9)])


@pytest.mark.parametrize("degree", [0, 1, 2, 3, 25])
def test_apply_of_a_power_is_the_definition_of_a_curve(degree):
    expected = Add(*[comb(degree, k) * t**k * (1 - t) ** (degree - k) * b[k] for k in range(degree + 1)])
    assert expand(apply(step(t) ** degree)) == expand(expected)


def test_apply_of_a_symbolic_power_is_a_sum_of_basis_functions():
    assert apply(step(t) ** n) == Sum(B(i, n, t) * b[i], (i, 0, n))
    assert apply((E - 1) ** m).function == (-1) ** (m - i) * binomial(m, i) * b[i]
    assert apply(E**n) == b[n]
    assert apply(E**-1) == b[-1]
    assert apply(0) == 0


def test_apply_never_reuses_an_index_of_the_operator():
    """g^i has its own i: the new sum must take another letter."""
    summed = apply(step(t) ** i)
    assert summed.variables != [i]
    assert expand(summed.subs(i, 2).doit()) == expand(apply(step(t) ** 2))


@pytest.mark.parametrize("operator", [sin(E), 1 / (1 + E), (1 + E**2) ** n, E**I, (sin(E)) ** n])
def test_what_is_no_polynomial_in_e_is_refused(operator):
    with pytest.raises(ValueError, match=r"in E|power of E"):
        apply(operator)


@pytest.mark.parametrize("operator", [E**-1, E**2, E**n])
def test_a_point_that_is_not_there_is_refused(operator):
    with pytest.raises(ValueError, match="there is no control point b_.* among b_0 .. b_1"):
        apply(operator, [S(1), S(2)])


@pytest.mark.parametrize("degree", range(6))
def test_b_expands_to_its_definition(degree):
    for index in range(degree + 1):
        expected = comb(degree, index) * t**index * (1 - t) ** (degree - index)
        assert B(index, degree, t).doit() == expected
        assert B(index, degree, t).rewrite(binomial) == expected
        assert expand(diff(B(index, degree, t), t) - diff(expected, t)) == 0


def test_b_is_zero_outside_its_indices_and_undefined_below_degree_zero():
    assert B(-1, 3, t).doit() == 0
    assert B(4, 3, t).doit() == 0
    assert B(-1, n, t).doit() == 0
    assert B(0, -1, t).doit() is nan


def test_b_stays_symbolic_until_asked():
    assert B(i, n, t).args == (i, n, t)
    assert B(1, 3, t) != 3 * t * (1 - t) ** 2
    assert B(i, n, t).subs({i: 1, n: 3, t: Rational(1, 3)}).doit() == Rational(4, 9)
    assert abs(B(1, 3, pi / 10).evalf() - 3 * (pi / 10).evalf() * (1 - (pi / 10).evalf()) ** 2) < 1e-14


def test_latex_is_that_of_the_slides():
    assert latex(B(i, n, t)) == r"B_{i,n}(t)"
    assert latex(B(i, n, t / 2)) == r"B_{i,n}\left(\frac{t}{2}\right)"
    assert latex(B(i, n, t) ** 2) == r"B_{i,n}(t)^{2}"
    assert latex(step(t) ** n * b[0]) == r"\left[\left(1 - t\right) + t E\right]^{n} {b}_{0}"
    assert latex((E - 1) ** 2 * E**j) == r"\left[E - 1\right]^{2} E^{j}"
    assert latex(n - i + 1) == "n + 1 - i"
    assert latex(1 - 3 * t + 3 * t**2 - t**3) == "1 - 3 t + 3 t^{2} - t^{3}"


def test_the_cubic_matrices_of_the_slides():
    """Deck: [1 t t^2 t^3]; notes: [t^3 t^2 t 1]."""
    assert basis_matrix(3) == Matrix([[1, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]])
    assert basis_matrix(3, descending=True) == Matrix([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]])


@pytest.mark.parametrize("degree", [0, 1, 2, 3, 6, 12])
def test_matrices_change_the_basis_and_back(degree):
    powers = Matrix([[t**k for k in range(degree + 1)]])
    basis = Matrix([[comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)]])
    assert (powers * basis_matrix(degree)).applyfunc(expand) == basis.applyfunc(expand)
    assert (basis * power_matrix(degree)).applyfunc(expand) == powers
    assert basis_matrix(degree) * power_matrix(degree) == eye(degree + 1)
    assert (powers[:, ::-1] * basis_matrix(degree, descending=True)).applyfunc(expand) == basis.applyfunc(expand)
    assert (basis * power_matrix(degree, descending=True)).applyfunc(expand) == powers[:, ::-1]
