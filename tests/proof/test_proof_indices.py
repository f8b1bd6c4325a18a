"""What SymPy assumes of an index holds in its sum: it goes by the assumption, whatever stands there."""

import pytest
from sympy import (
    Abs,
    Add,
    Derivative,
    Ge,
    Integral,
    Interval,
    Le,
    Mul,
    Pow,
    Product,
    Rational,
    S,
    Subs,
    Sum,
    Symbol,
    binomial,
    floor,
    oo,
)

from bezteach import bench
from bezteach.proof import prove, statement
from bezteach.proof.derivations import check_derivation
from bezteach.symbolic import B, i, j, k, n, t, u

COUNTED, HALVED = Symbol("s"), Symbol("m")  # whole numbers by their use
POSITIVE = Symbol("q", integer=True, positive=True)
DELAY = Mul(*[i - place for place in range(9)])  # 0 in all that the refuter sees
SQUARE, TO_14 = DELAY**2, Mul(*[i - place for place in range(15)])
TELESCOPED = (-1) ** (k + 1) * binomial(2 * n - k - 1, n)
FROM_BELOW = (1 + DELAY) * TELESCOPED * binomial(n + 1, k + 1) * (n - k) / (n + 1) - DELAY * TELESCOPED * binomial(
    n, k + 1
)


@pytest.mark.parametrize(
    ("claim", "given"),
    [
        pytest.param((Sum(FROM_BELOW, (k, -1, n - 1)), 1 + DELAY), {}, id="a first case of telescoping"),
        pytest.param(
            (Sum(FROM_BELOW.subs(k, POSITIVE - 1), (POSITIVE, 0, n)), 1 + DELAY), {}, id="an index declared positive"
        ),
        pytest.param(
            (Ge(TO_14**2 * Sum((n - 5) ** (k + 1), (k, -1, i)) * (n - 6) + 2 * binomial(n, 6), 0, evaluate=False),),
            {n: (5, oo)},
            id="an edge of an inequality",
        ),
        pytest.param(
            (
                Le(
                    SQUARE * Sum(binomial(HALVED, k + 1) * t ** (k + 1), (k, -1, HALVED - 1)) * (1 - t) ** HALVED,
                    SQUARE * Sum(0, (k, -1, HALVED - 1)),
                    evaluate=False,
                ),
            ),
            {HALVED: (1, oo), t: Interval(-1, 1)},
            id="a peak",
        ),
        pytest.param(
            (Sum(1, (k, 0, 2 * COUNTED)), 2 * COUNTED + 1 + TO_14 * (1 + (-1) ** (2 * COUNTED))),
            {COUNTED: (Rational(1, 2), oo)},
            id="induction from 1/2",
        ),
        pytest.param(
            (Sum(1, (k, 0, 2 * COUNTED)), 2 * COUNTED + 1 + TO_14 * ((-1) ** HALVED - (-1) ** (2 * COUNTED))),
            {COUNTED: (HALVED / 2, oo)},
            id="induction from m/2",
        ),
        pytest.param(
            (
                Sum(binomial(2 * COUNTED, k) ** 2, (k, 0, 2 * COUNTED)),
                binomial(4 * COUNTED, 2 * COUNTED) * (1 + TO_14 * (1 + (-1) ** (2 * COUNTED))),
            ),
            {COUNTED: (Rational(1, 2), oo)},
            id="telescoping from 1/2",
        ),
    ],
)
def test_what_is_false_far_away_is_not_proved(claim, given):
    assert prove(*claim, given=given).status in ("CHECKED", "UNDECIDED")


def test_a_derivation_does_not_start_between_whole_numbers():
    lines = [Sum(1, (k, 0, 2 * COUNTED)), 2 * COUNTED + 1 + TO_14 * (1 + (-1) ** (2 * COUNTED))]
    judged = check_derivation(lines, given={COUNTED: (Rational(1, 2), oo)})
    assert "PROVED" not in {judged.lines[1].step.status, judged.lines[1].whole.status}


def test_an_index_of_a_derivation_has_only_the_signs_of_its_limits():
    judged = check_derivation([Sum(FROM_BELOW, (k, -1, n - 1)), 1 + DELAY], budget=60)
    assert judged.status in ("CHECKED", "UNDECIDED")


def test_an_inner_index_goes_by_what_is_left_of_the_outer_one():
    inner = Sum((n - 5) ** (j + 1), (j, k, i))  # a factor, so that SymPy does not make one sum of two
    claim = Ge(SQUARE * Sum((k + 2) * inner, (k, -1, -1)) * (n - 6) + 2 * binomial(n, 6), 0, evaluate=False)
    assert prove(claim, given={n: (5, oo)}).status in ("CHECKED", "UNDECIDED")  # false at n = 5, i = 9


FAR = "(n+1)/(n-100) - n/(n-100) - 1/(n-100)"  # 0, but at n = 100


@pytest.mark.parametrize(
    "text",
    [
        f"sum(k, k, 0, n + {FAR}) = n(n+1)/2",
        f"sum(k, k, 0, n + {FAR}) >= 0",
        f"b[n + {FAR}] = b[n]",
        f"sum(B(i,n,t) b_i, i, {FAR}, n) = sum(B(i,n,t) b_i, i, 0, n)",
        f"diff(t^n, t, n + {FAR}) = n!",
        "sum(b[k+(k+1)/(k-100)-k/(k-100)-1/(k-100)],k,0,n) = sum(b_k,k,0,n)",
    ],
)
def test_limits_indices_and_orders_have_values_before_they_are_simplified(text):
    assert bench.judge(text).status == "CHECKED"


@pytest.mark.parametrize(
    ("text", "given"),
    [
        ("t/(1+E^2) + t E^2/(1+E^2) = t", ""),
        ("t/(1+E^2)*b_2 + t/(1+E^2)*b_0 = t*b_0", ""),
        ("(t^2+E^2)^(-n)*(t^2+E^2)^(n+1) b_0 = t^2*b_0+b_2", "0<t<1"),
        ("B(1,2,1/(1+E^2)) t = B(1,2,E^2/(1+E^2)) t", "0<t<1"),
    ],
)
def test_the_operator_is_no_number_whose_square_is_positive(text, given):
    """1 + E^2 takes points with b_{j+2} = -b_j to 0."""
    assert bench.judge(text, given).status == "UNDECIDED"


def test_a_line_stands_as_it_is_written_until_it_is_known_to_have_a_value():
    """What SymPy would cancel is not defined at n = 100, where no value is tried."""
    total, last = Sum(k, (k, 0, n)), n * (n + 1) / 2
    hidden = Mul(total, Pow(n - 100, -1), n - 100, evaluate=False)
    nothing = Mul(0, Sum(1 / (k - 100), (k, 0, n)), evaluate=False)
    assert check_derivation([hidden, last]).status in ("CHECKED", "UNDECIDED")
    assert check_derivation([Add(n, nothing, evaluate=False), n]).status in ("CHECKED", "UNDECIDED")
    assert prove(Add(total, Mul(0, 1 / (n - 100), evaluate=False), evaluate=False), last).status == "CHECKED"
    below = Mul(Sum(k + 1, (k, -1, n)), Pow(n - 100, -1), n - 100, evaluate=False)  # its index is another symbol
    assert check_derivation([below, (n + 1) * (n + 2) / 2]).status in ("CHECKED", "UNDECIDED")
    for pole in (3, 100):
        within = Sum(Mul(k, Pow(k - pole, -1), k - pole, evaluate=False), (k, 0, n))
        assert "PROVED" not in (prove(within, last).status, check_derivation([within, last]).status)
    assert check_derivation([total, last]).status == "PROVED"


@pytest.mark.parametrize(
    ("text", "given", "status"),
    [
        ("C(n,i) < C(n,i+1)", "i < n/2", "REFUTED"),  # n = 1, i = 0
        ("n - 2i >= 2", "i < n/2", "REFUTED"),
        ("n - 2i >= 1", "i < n/2", "PROVED"),
        ("2n >= i+2", "n > i/2", "REFUTED"),
        ("2n >= i+1", "n > i/2", "PROVED"),
        ("(4n-8i-4)/(n-2i-1) = 4", "i < n/2", "REFUTED"),
    ],
)
def test_a_half_left_out_leaves_no_whole_number_out(text, given, status):
    assert bench.judge(text, given).status == status


@pytest.mark.parametrize("kind", [Sum, Product])
def test_an_index_keeps_its_assumptions_only_where_its_limits_give_them(kind):
    def index(low, high, symbol=k):
        ((found, *_),) = statement(kind(symbol, (symbol, low, high)), n).lhs.limits
        return found

    assert index(0, n) == index(i, n) == k and index(1, n, POSITIVE) == POSITIVE
    assert index(-1, n) == index(i - 1, n) == Symbol("k", integer=True)
    assert index(0, n, POSITIVE) == Symbol("q", integer=True)


def test_other_variables_may_not_leave_what_is_assumed_of_them():
    x = Symbol("x", positive=True)
    for claim in (Subs((n - 5) ** x, x, 0), Integral((n - 5) ** x, (x, 0, 1))):
        verdict = prove(claim, 0, given={n: (5, oo)})
        assert verdict.status == "INVALID" and verdict.note.endswith("x may go beyond what is assumed of it")
    assert prove(Subs(t**k, t, 1), 1).status == "PROVED"


NOT_NEGATIVE, NEGATIVE = Symbol("q", nonnegative=True), Symbol("w", negative=True)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        # Between 1 and -1 the variable of an integral is negative too, and |q| is not q there.
        (Integral(Abs(NOT_NEGATIVE), (NOT_NEGATIVE, 1, -1)), 0),
        (Integral(Abs(NOT_NEGATIVE) * u, (NOT_NEGATIVE, 0, t)), u * t**2 / 2),
        (Integral(Abs(NEGATIVE), (NEGATIVE, -1, 1)), 0),
        # At 1/2 floor(j) is not j.
        (Subs(floor(j) + u, j, t), t + u),
        (Subs((-1) ** (2 * j) + u, j, S.Half), 1 + u),
    ],
)
def test_sympy_has_gone_by_what_is_assumed_of_a_variable(left, right):
    """What is false is INVALID, and so is what is true: the statement that was meant is not there any more."""
    for other in (right, right - 1):
        assert prove(left, other).status == "INVALID"
        assert check_derivation([left, other]).status == "INVALID"


@pytest.mark.parametrize(
    ("left", "right"),
    [
        # SymPy tells Subs(..., k) with one k from that with another only by the name.
        (Sum(Subs(t**2 * u, t, k), (k, -1, 1), (k, 0, 2)), 15 * u),
        (Sum((k + 1) * Sum(Subs(t**2 * u, t, k), (k, -1, 1)), (k, 0, 2)), 42 * u),
        (k + Sum(Subs(t**2 * u, t, k), (k, -1, 1)), k + 3 * k**2 * u),
        # The index goes below 0, and with it the variable of the integral.
        (Sum(Integral(Abs(NOT_NEGATIVE), (NOT_NEGATIVE, k, 1)), (k, -1, 0)), S.Half),
        (Sum(k * Integral(Abs(NOT_NEGATIVE) * u, (NOT_NEGATIVE, 0, k)), (k, -1, 0)), -u / 2),
        (Product(Subs(Abs(NOT_NEGATIVE) + t, NOT_NEGATIVE, 2 * k), (k, -2, -2)), t - 4),
    ],
)
def test_an_index_takes_no_variable_with_it_beyond_what_is_assumed(left, right):
    assert prove(left, right).status == check_derivation([left, right]).status == "INVALID"


def test_an_index_that_stays_may_stand_in_what_is_put_in():
    assert prove(Sum(Subs(t**2 * u, t, k), (k, 0, 2)), 5 * u).status == "PROVED"
    assert prove(Sum(Integral(NOT_NEGATIVE, (NOT_NEGATIVE, k, 1)), (k, 0, 1)), S.Half).status == "PROVED"


@pytest.mark.parametrize(
    ("symbol", "values"),
    [
        (Symbol("p", positive=True), Interval(n, n + 1)),
        (NEGATIVE, Interval(-1 - n, -n)),
        (NEGATIVE, Interval(-oo, 0)),
    ],
)
def test_a_range_may_not_reach_a_0_that_is_left_out_by_assumption(symbol, values):
    assert prove(symbol + symbol, 2 * symbol, given={symbol: values}).status == "INVALID"
    within = Interval(values.start, values.end, True, True)
    assert prove(symbol + symbol, 2 * symbol, given={symbol: within}).status == "PROVED"


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("sum(0^(k+1), k, -1, n) = 0", "REFUTED"),
        ("sum(0^(k+1), k, -1, n) = 1", "PROVED"),
        ("sum(C(0,k+1), k, -1, n) = 0", "REFUTED"),
        ("sum(0^(k+1), k, -1, n) - sum(0, k, -1, n) = 0", "REFUTED"),
        (r"\sum_{k=-1}^{n} 0^{k+1} = 0", "REFUTED"),
        ("sum(B(k,n,t), k, -1, n+1) = 1", "PROVED"),
        ("sum(0^(k+1) * sum(0^(j+2), j, -2, k), k, -1, n) = 0", "REFUTED"),
    ],
)
def test_a_sum_in_a_text_may_begin_below_0(text, status):
    assert bench.judge(text).status == status


def test_what_sympy_refuses_breaks_nothing():
    """Where i is put in, a derivative inside an empty sum has the order -1, and SymPy raises."""
    assert bench.judge("sum(diff(t^k,t,i-1),k,0,i-2)=0", "i>=0").status == "CHECKED"
    assert prove(Sum(Derivative(t**k, (t, i - 1)), (k, 0, i - 2)), 0).status == "CHECKED"
    assert prove(Sum(B(k, n, t), (k, 0, n)), 1).status == "PROVED"


X = Symbol("x", real=True)
AHEAD = Mul(*[n - value for value in range(9)], evaluate=False)  # 0 wherever the refuter looks


@pytest.mark.parametrize(
    ("given", "captured", "right"),
    [
        (Subs(B(1, 1, Integral(X * t, (t, 0, 1))), X, t), Integral(t**2, (t, 0, 1)), t / 2),
        (Subs(B(n, n, Integral(X * u, (u, 0, 1))), X, u), B(n, n, Integral(u**2, (u, 0, 1))), (u / 2) ** n),
        (Subs(B(1, 1, Subs(X * t, t, 2)), X, t), B(1, 1, Subs(t**2, t, 2)), 2 * t),
        (Subs(B(1, 1, Sum(k * X, (k, 0, 3))), X, t), B(1, 1, Sum(k**2, (k, 0, 3))), 6 * t),
    ],
    ids=["a bare integral", "a power", "a value put in", "a sum"],
)
def test_what_is_put_in_is_not_bound_by_what_is_inside(given, captured, right):
    assert prove(AHEAD * given, AHEAD * captured).status == "CHECKED"
    assert prove(given, captured).status == "REFUTED"
    assert prove(AHEAD * given, AHEAD * right).status in ("PROVED", "CHECKED")


def test_an_inner_sum_over_the_same_index_may_divide():
    assert bench.judge("sum(1/sum(1,k,0,n), k, 0, n) = 1").status == "CHECKED"
    assert bench.judge("sum(1/sum(1,k,0,n), k, 0, n) = n").status == "REFUTED"


def test_two_values_put_in_that_sympy_cannot_order_break_nothing():
    put_in = Subs(binomial(n, i - 1), X, t) + Subs(i * binomial(n, i - 1), X, u)
    assert prove(put_in, (i + 1) * binomial(n, i - 1)).status == "CHECKED"
    assert prove(put_in, i * binomial(n, i - 1)).status == "REFUTED"
