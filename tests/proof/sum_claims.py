"""Equations about sums that stop before the end, deltas, and quotients on an open interval, each with false twins."""

from sympy import Derivative, Integer, Interval, KroneckerDelta, Rational, Sum, binomial, factorial, oo

from bezteach.symbolic import B, b, i, j, k, n, step, t, u

INSIDE = {t: Interval.open(0, 1)}
WITHIN = {i: (0, n)}
FROM_ONE = {n: (1, oo)}
TAIL = Sum(B(j, n, t), (j, i, n))
ALTERNATING = (-1) ** (i + j) * binomial(k, j) * binomial(j, i)

# name: left side, right side, ranges, right sides that are false
CLAIMS = {
    "tail sums": (
        TAIL,
        Sum((-1) ** (i + j) * binomial(n, j) * binomial(j - 1, i - 1) * t**j, (j, i, n)),
        FROM_ONE | {i: (1, n)},
        [
            Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * t**j, (j, i, n)),
            Sum((-1) ** j * binomial(n, j) * binomial(j - 1, i - 1) * t**j, (j, i, n)),
            Sum((-1) ** (i + j) * binomial(n, j) * binomial(j - 1, i - 1) * t**j, (j, i + 1, n)),
        ],
    ),
    "tail and head": (TAIL + Sum(B(j, n, t), (j, 0, i - 1)), Integer(1), {i: (0, n + 1)}, [1 + B(i, n, t)]),
    "derivative of a tail": (Derivative(TAIL, t), n * B(i - 1, n - 1, t), FROM_ONE | {i: (1, n)}, [n * B(i, n - 1, t)]),
    "empty tail": (TAIL, Integer(0), {i: (n + 1, oo)}, [B(n, n, t)]),
    "beyond the degree": (B(i, n, t), Integer(0), {i: (n + 1, oo)}, [B(i - 1, n, t)]),
    "by steps of the polygon": (
        Sum(B(j, n, t) * b[j], (j, 0, n)),
        b[0] + Sum(TAIL * (b[i] - b[i - 1]), (i, 1, n)),
        {},
        [Sum(TAIL * (b[i] - b[i - 1]), (i, 1, n)), b[0] + Sum(TAIL * (b[i] - b[i - 1]), (i, 0, n))],
    ),
    "sum of tails": (Sum(TAIL, (i, 1, n)), n * t, {}, [(n - 1) * t]),
    "sum of heads": (Sum(Sum(B(j, n, t), (j, 0, i)), (i, 0, n)), 1 + n * (1 - t), {}, [n * (1 - t)]),
    "without the first": (
        Sum(B(j, n, t) * b[j], (j, 1, n)),
        (step(t) ** n - (1 - t) ** n) * b[0],
        FROM_ONE,
        [step(t) ** n * b[0] - (1 - t) ** n * b[1]],
    ),
    "without the last": (Sum(B(j, n, t), (j, 0, n - 1)), 1 - t**n, {}, [1 - t ** (n - 1)]),
    "without two": (Sum(B(j, n, t), (j, 1, n - 1)), 1 - t**n - (1 - t) ** n, FROM_ONE, [1 - t**n]),
    "signs from 1": (Sum((-1) ** j * binomial(n, j), (j, 1, n)), Integer(-1), FROM_ONE, [Integer(0)]),
    "neighbours": (
        Sum((binomial(n, j) + binomial(n, j - 1)) * t**j, (j, 1, n)),
        (1 + t) ** (n + 1) - 1 - t ** (n + 1),
        {},
        [(1 + t) ** (n + 1) - 1],
    ),
    "divided by the next": (
        Sum(binomial(n, j) / (j + 1), (j, 0, n)),
        (2 ** (n + 1) - 1) / (n + 1),
        {},
        [2 ** (n + 1) / (n + 1)],
    ),
    "edges of the polygon": (Sum(b[j + 1] - b[j], (j, i, n)), b[n + 1] - b[i], WITHIN, [b[n] - b[i]]),
    "at 0": (B(i, n, 0), KroneckerDelta(i, 0), {}, [KroneckerDelta(i, 1), KroneckerDelta(i, n)]),
    "at 1": (B(i, n, 1), KroneckerDelta(i, n), {}, [KroneckerDelta(i, 0), KroneckerDelta(i, n - 1)]),
    "others at 0": (B(i, n, 0), Integer(0), {i: (1, n)}, [Integer(1)]),
    "others at 1": (B(i, n, 1), Integer(0), FROM_ONE | {i: (0, n - 1)}, [Integer(1)]),
    "first at 0": (B(0, n, 0), Integer(1), {}, [Integer(0)]),
    "last at 1": (B(n, n, 1), Integer(1), {}, [Integer(0)]),
    "inverse matrices": (
        Sum(ALTERNATING, (j, i, k)),
        KroneckerDelta(i, k),
        {i: (0, k)},
        [Integer(0), -KroneckerDelta(i, k)],
    ),
    "inverse matrices, whole rows": (Sum(ALTERNATING, (j, 0, k)), KroneckerDelta(i, k), {}, [KroneckerDelta(i, 0)]),
    "inverse bases": (
        Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * binomial(k, j) / binomial(n, j), (j, i, k)),
        KroneckerDelta(i, k),
        {k: (0, n), i: (0, k)},
        [KroneckerDelta(i, n)],
    ),
    "picked by a delta": (Sum(KroneckerDelta(j, i) * B(j, n, t), (j, 0, n)), B(i, n, t), {}, [B(i + 1, n, t)]),
    "picked beside": (
        Sum(KroneckerDelta(j, i + 1) * B(j, n, t) * b[j], (j, 0, n)),
        B(i + 1, n, t) * b[i + 1],
        {},
        [B(i, n, t) * b[i + 1]],
    ),
    "picked by a basis function": (Sum(B(j, n, 1) * B(i, j, t), (j, i, n)), B(i, n, t), WITHIN, [B(0, n, t)]),
    "at the middle": (B(i, n, Rational(1, 2)), binomial(n, i) / 2**n, WITHIN, [binomial(n, i) / 2 ** (n - i)]),
    "exponential, cut off": (
        Sum(t**j * u ** (n - j) / factorial(j) / factorial(n - j), (j, 2, n)),
        ((t + u) ** n - u**n - n * t * u ** (n - 1)) / factorial(n),
        FROM_ONE,
        [((t + u) ** n - u**n) / factorial(n)],
    ),
}

DIVIDED = {
    "itself": (B(i, n, t) / t, B(i, n, t) / t, WITHIN | INSIDE, [B(i, n, t) / t**2]),
    "divided by t": (i * B(i, n, t) / t, n * B(i - 1, n - 1, t), FROM_ONE | WITHIN | INSIDE, [i * B(i - 1, n - 1, t)]),
    "divided by 1 - t": (
        B(i, n, t) / (1 - t),
        binomial(n, i) * t**i * (1 - t) ** (n - i - 1),
        WITHIN | INSIDE,
        [binomial(n, i) * t**i * (1 - t) ** (n - i + 1)],
    ),
    "quotient of neighbours": (
        B(i + 1, n, t) / B(i, n, t),
        (n - i) * t / ((i + 1) * (1 - t)),
        WITHIN | INSIDE,
        [(n - i) * t / ((i + 1) * (1 + t))],
    ),
    "logarithmic derivative": (
        Derivative(B(i, n, t), t),
        (i - n * t) / (t * (1 - t)) * B(i, n, t),
        WITHIN | INSIDE,
        [(i - t) / (t * (1 - t)) * B(i, n, t)],
    ),
    "geometric sum": (Sum(t**k, (k, 0, n)), (1 - t ** (n + 1)) / (1 - t), INSIDE, [(1 - t**n) / (1 - t)]),
    "geometric tail": (
        Sum(t**k, (k, i, n)),
        (t**i - t ** (n + 1)) / (1 - t),
        WITHIN | {t: Interval.Ropen(0, 1)},
        [(1 - t ** (n + 1)) / (1 - t)],
    ),
}
