"""What anyone states as text is judged; what cannot be read is said, with its line and character."""

import pytest

from bezteach.bench import judge
from bezteach.parsing import InvalidAnswer


@pytest.mark.parametrize(
    ("text", "given", "status"),
    [
        ("sum(B(i,n,t), i, 0, n) = 1", "n >= 1", "PROVED"),
        ("sum(B(i,n,t), i, 1, n) = 1", "n >= 1", "REFUTED"),
        ("B(i,n,t) >= 0", "0 <= i <= n, 0 <= t <= 1", "PROVED"),
        ("B(i,n,t) >= 0", "0 <= i <= n", "REFUTED"),
        ("t = t/0*0", "", None),
        ("1/n = 1/n", "", "INVALID"),
    ],
)
def test_a_statement(text, given, status):
    if status is None:
        with pytest.raises(InvalidAnswer):
            judge(text, given)
    else:
        assert judge(text, given).status == status


@pytest.mark.parametrize(
    ("text", "where", "within"),
    [
        ("t/t = 1", "t = 0: undefined", "0 < t <= 1"),
        ("1/(n-12) - 1/(n-12) = 0", "n = 12: undefined", "n > 12"),
        ("0*(1/(3t-2)) = 0", "t = 2/3: undefined", "0 <= t < 2/3"),
        ("(1/(n-12))^0 = 1", "n = 12: undefined", "n <= 11"),
        ("1/(1/t) = t", "t = 0: undefined", "t > 0"),
        ("C(n-3, 0) = 1", "n = 0: undefined", "n >= 3"),
        ("(n-3)!/(n-3)! = 1", "n = 0: undefined", "n >= 3"),
        ("t t^(i-1) = t^i", "i = 0, t = 0: undefined", "i >= 1"),
        ("t^i t^(n-i) = t^n", "n = 0, i = 1, t = 0: undefined", "0 <= i <= n"),
        ("B(i,n-1,t) - B(i,n-1,t) = 0", "n = 0, i = 0, t = 1/2: undefined", "n >= 1"),
        ("sum((i-12)/(i-12), i, 0, n) = n + 1", "n = 12: undefined", "n <= 11"),
        ("sum((n+12-i)/(n+12-i), i, 0, 2n) = 2n + 1", "n = 12: undefined", "n <= 11"),
        ("b[n/n] = b_1", "n = 0: undefined", "n >= 1"),
        ("diff(1/(n-12) - 1/(n-12), t) = 0", "n = 12, t = 1/2: undefined", "n > 12"),
        ("(1-t)B(i,n,t)/(1-t) = B(i,n,t)", "n = 0, i = 0, t = 1: undefined", "0 <= t < 1"),
    ],
)
def test_what_has_no_value_is_not_cancelled(text, where, within):
    verdict = judge(text)
    assert verdict.status == "REFUTED" and where in f"{verdict.counterexample}"
    assert judge(text, within).status == "PROVED"


def test_a_derivation_names_its_first_wrong_line():
    """The deck's proof of the recursion: its third line has the exponents wrong."""
    judgement = judge(
        """B(i,n,u)
        = (C(n-1,i) + C(n-1,i-1)) u^i (1-u)^(n-i)
        = C(n-1,i) u^i (1-u)^(n-i) + C(n-1,i-1) u^(i-1) (1-u)^(n-i+1)
        = (1-u) B(i,n-1,u) + u B(i-1,n-1,u)""",
        "n >= 1, 1 <= i <= n",
    )
    assert (judgement.status, judgement.first_wrong) == ("REFUTED", 3)
    assert judgement.last_equals_first


@pytest.mark.parametrize(
    ("text", "given", "said"),
    [
        ("", "", "nothing is written here"),
        ("t", "", "this is no statement"),
        ("t\n= 2 t)", "", r"line 2, character \d+"),
        ("t\n= t = 1", "", "line 2"),
        ("t\nt = t", "", "line 2 is no formula"),
        ("t, t", "", "this is no statement"),
        ("t = t", "q >", "character"),
    ],
)
def test_what_cannot_be_read(text, given, said):
    with pytest.raises(InvalidAnswer, match=said) as caught:
        judge(text, given)
    assert "\n" not in str(caught.value)


def test_a_line_of_a_derivation_may_begin_with_either_equals_sign():
    assert judge("t\n== 2t - t\n  = t").status == "PROVED"
    with pytest.raises(InvalidAnswer, match=r"line 2, character 7: the bracket"):
        judge("t\n== t+ (t")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("0 <= t, t <= 1", "several statements: have each judged alone"),
        ("t = t + 0 = t", "each formula on its own line"),
        ("0 <= t <= 1", "write the two statements apart"),
    ],
)
def test_several_statements_at_once_are_told_apart(text, said):
    with pytest.raises(InvalidAnswer, match=said):
        judge(text)


@pytest.mark.parametrize(
    ("text", "given"),
    [
        ("sum(B(k,n,t), k, -1, n)\nsum(B(k,n,t), k, 0, n)\n1", ""),
        ("sum(B(k,n,t), k, j-1, n)\n= sum(B(k,n,t), k, j, n) + B(j-1,n,t)", "1 <= j <= n"),
        ("k + sum(B(k,n,t), k, -1, n)\nk + 1", "k >= 1"),
        ("k + sum(0^(k+1), k, -1, n) = k + 1", "k >= 2"),
    ],
)
def test_one_letter_is_one_symbol_in_all_lines_and_ranges(text, given):
    """A sum that begins below 0 in one of them has a letter without a sign, and the others have the same one."""
    assert judge(text, given).status == "PROVED"


def test_a_line_that_cannot_be_read_is_named_also_beside_a_sum_from_below_0():
    with pytest.raises(InvalidAnswer, match=r"line 2, character 10"):
        judge("sum(B(k,n,t), k, -1, n)\n= 1 + (t))")
