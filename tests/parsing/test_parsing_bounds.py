"""No text takes long, and the bounds on what is read are met exactly."""

import sys
import time

import pytest
from parsing_texts import REFUSED

from bezteach.parsing import InvalidAnswer, parse, parse_given

# the longest, the deepest, the dearest: each as much as the bounds let through, or a little more
HEAVY = {
    "many terms": "+".join("t" * 200),
    "many powers": "+".join(f"t^{e}" for e in range(100)),
    "many factors": "*".join(f"(t+{e})" for e in range(100)),
    "roots of primes": "*".join(f"sqrt({999999999989 - e})" for e in range(16)),
    "cube roots": "*".join(f"{999999999989 - e}^(11/12)" for e in range(16)),
    "fractions in fractions": "1/(t*u-" * 39 + "t" + ")" * 39,
    "nested roots": "*".join(f"sqrt(9-sqrt({e}-sqrt(2)))" for e in range(3, 8)),
    "root of an integral": "sqrt(integral(1/t, t, 0, 1) - sqrt(integral(1/t, t, 0, 1)^2))^n",
    "root of a sum": "(sum(1/i, i, 0, 400) - 7)^(1/3)*abs(sum((-1)^i/i!, i, 0, 400))^t",
    "factorials": "+".join(f"1/{400 - e}!" for e in range(80)),
    "binomials": "*".join(["C(400,200)"] * 30),
    "symbolic binomials": "*".join(f"C(n+{e},n-{e})" for e in range(40)),
    "large numbers": "(" * 20 + "t+1" + f")*{'9' * 39}" * 20,
    "long fractions": "+".join(f"1/9{e:039}" for e in range(44)),
    "nested integrals": "integral(" * 39 + "t" + ",t,0,1)" * 39,
    "nested derivatives": "diff(" * 39 + "t^2*u^3" + ",t)" * 39,
    "nested B": "B(0,1," * 39 + "t" + ")" * 39,
    "nested abs": "abs(t-" * 39 + "t" + ")" * 39,
    "a list of points": ",".join(["(1,2)"] * 64),
    "statements": ",".join(["t<1"] * 64),
    "spaces": " " * 1999 + "t",
    "scripts": "b" + "₁²" * 999,
    "words": "ab " * 666,
    "commands": r"\frac" * 400,
    "dots": "." * 2000,
    "exclamation marks": "t" + "!" * 1999,
    "sums": r"\sum_{i=0}^n " * 150,
    "wide": "（" * 2000,
    "quotients": "d/" * 1000,
}


@pytest.mark.parametrize("text", [*HEAVY.values(), *(row[0] for row in REFUSED)], ids=lambda text: f"{text[:12]!a}")
def test_no_text_makes_much_work(text):
    """Seconds of the processor, where a text without a bound would take minutes or for ever."""
    parse("sqrt(2)*t*integral(t, t, 0, 1) + sum(i, i, 0, n)^n/abs(1-t)")  # SymPy loads what it needs
    start = time.process_time()
    try:
        parse(text)
    except InvalidAnswer as error:
        assert error.position
    assert time.process_time() - start < 2


BOUNDS = {
    # the largest that is read, one more
    "characters": ("t" + " " * 1999, "t" + " " * 2000),
    "parts": ("-" + "+".join("t" * 200), "--" + "+".join("t" * 200)),
    "levels": ("(" * 40 + "t" + ")" * 40, "(" * 41 + "t" + ")" * 41),
    "digits": ("7" * 40, "7" * 41),
    "digits of a decimal": ("0." + "7" * 39, "0." + "7" * 40),
    "exponent": ("t^200", "t^201"),
    "negative exponent": ("t^(-200)", "t^(-201)"),
    "degree": ("(t^200)^2", "(t^200)^2*t"),
    "factorial": ("400!", "401!"),
    "items": (",".join("1" * 64), ",".join("1" * 65)),
    "points": (",".join(["(0,1)"] * 64), ",".join(["(0,1)"] * 65)),
    "digits of a power": ("(10^19)^200", "(10^20)^200"),
    "digits under a root": ("sqrt(999999999999)", "sqrt(9999999999999)"),
    "sums": ("sum(" * 3 + "i" + ",i,0,n)" * 3, "sum(" * 4 + "i" + ",i,0,n)" * 4),
}


@pytest.mark.parametrize("bound", BOUNDS)
def test_bounds_are_met_exactly(bound):
    within, beyond = BOUNDS[bound]
    parse(within)
    with pytest.raises(InvalidAnswer):
        parse(beyond)


@pytest.mark.parametrize("read", [parse, parse_given])
def test_no_depth_of_the_caller_lets_another_error_out(read):
    def deeper(depth):
        if depth:
            return deeper(depth - 1)
        with pytest.raises(InvalidAnswer, match="too large to be read"):
            read("(" * 39 + "1" + ")" * 39 + "<= n")

    frame, depth = sys._getframe(), 0
    while frame:
        frame, depth = frame.f_back, depth + 1
    deeper(sys.getrecursionlimit() - depth - 120)
