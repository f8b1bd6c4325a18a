"""The words of the language: letters, functions, LaTeX commands, and what to say about words that are none of them."""

from difflib import get_close_matches

from sympy import IndexedBase, Symbol

from ..symbolic import E, b, i, j, k, n, r, t, u

LETTERS = {
    **{"i": i, "j": j, "k": k, "n": n, "r": r, "t": t, "u": u, "E": E},
    **{letter: Symbol(letter, integer=True, nonnegative=True) for letter in "lmpq"},
    **{letter: Symbol(letter, real=True) for letter in "achsvwxyz"},
}
# the letters of sums that begin below 0, or may: SymPy must not go by their being >= 0
INTEGERS = {name: Symbol(name, integer=True) for name, symbol in LETTERS.items() if symbol.is_integer}
WHOLE = frozenset(symbol for symbol in LETTERS.values() if symbol.is_integer) | frozenset(INTEGERS.values())
POINTS = {"b": b, **{letter: IndexedBase(letter) for letter in "acxyz"}}

# the name that a student may type: the name of the rule that builds it
FUNCTIONS = {
    "B": "B",
    "C": "binomial",
    "binom": "binomial",
    "binomial": "binomial",
    "comb": "binomial",
    "factorial": "factorial",
    "sqrt": "sqrt",
    "abs": "abs",
    "Abs": "abs",
    "g": "g",
    "step": "g",
    "sum": "sum",
    "Sum": "sum",
    "int": "integral",
    "integral": "integral",
    "Integral": "integral",
    "diff": "diff",
    "derivative": "diff",
    "Derivative": "diff",
    "Fraction": "fraction",
    "Rational": "fraction",
}
# a LaTeX command: what it is read as, a sign, a function's name or nothing
COMMANDS = {
    **dict.fromkeys(("cdot", "times", "ast"), "*"),
    **dict.fromkeys(("le", "leq", "leqslant"), "<="),
    **dict.fromkeys(("ge", "geq", "geqslant"), ">="),
    **{"lt": "<", "gt": ">", "equiv": "=", "div": "/", "lbrace": "{", "rbrace": "}", "lbrack": "[", "rbrack": "]"},
    **dict.fromkeys(("left", "right", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "biggl"), ""),
    **dict.fromkeys(("biggr", "displaystyle", "textstyle", "limits", "quad", "qquad", "space", "thinspace"), ""),
    **dict.fromkeys(("frac", "dfrac", "tfrac"), "frac"),
    **dict.fromkeys(("binom", "dbinom", "tbinom"), "binom"),
    **{"sum": "sum", "int": "integral", "sqrt": "sqrt"},
}
FONTS = ("vec", "pmb", "mathbf", "boldsymbol", "bm", "mathrm", "mathit", "mathbb", "text")
COMMAND_ADVICE = {
    "Delta": "write the difference with the operator, (E - 1)",
    "begin": "write only what stands inside, and a matrix as a list of rows, ((1, 0), (-1, 1))",
    "prod": "write the factors, or factorial(n)",
    "partial": "write diff(t^2, t)",
    "prime": "write diff(t^2, t)",
    **dict.fromkeys(
        ("bar", "hat", "tilde", "overline"), "a letter with a mark is another one: take a letter of its own"
    ),
    "choose": r"write \binom{n}{i} or C(n, i)",
    "infty": "infinity is not a number here",
    "pi": "only fractions, roots and the letters of the course are read",
    "ne": "only =, <, <=, > and >= are read",
    "neq": "only =, <, <=, > and >= are read",
    "in": "write the range with signs, 0 <= t <= 1",
    **dict.fromkeys(("dots", "cdots", "ldots"), "write all the terms, or sum(i^2, i, 0, n)"),
    **dict.fromkeys(("alpha", "beta", "gamma", "lambda", "mu", "omega", "tau", "xi"), "take a Latin letter such as w"),
}

PROGRAM = "this is a formula, not a program; write only numbers, letters and functions, such as t*(1 - t)"
_NO_NUMBER = "it is not a number; write a number such as 1/3"
_NO_FUNCTION = "this function does not occur here; only fractions, powers and roots do"
ADVICE = {
    "b": "b stands for the control points; write b[0] or b_0, and for a number take another letter, such as c",
    "B": "write the basis function as B(i, n, t) or B_{i,n}(t)",
    "C": "write the binomial coefficient as C(n, i) or C_n^i",
    "g": "write the de Casteljau step with its parameter, g(t)",
    "I": "it is not a letter here; write 1 for the identity operator",
    "e": 'it is not a letter here; write "*10^3" for the e of "2e3"',
    "d": "write a derivative as diff(t^2, t)",
    "f": "only the course's own functions have names; write the formula itself",
    "o": "it is not a letter here; for zero write 0",
    "P": "the control points are called b; write b[0]",
    "True": "it is not a formula; leave out this word",
    "False": "it is not a formula; leave out this word",
    "Eq": "write the equation with its sign, t = 1",
    "and": "put a comma between statements",
    "or": "put a comma between statements",
    "in": "write the range with signs, 0 <= t <= 1",
    "choose": "write the binomial coefficient as C(n, i)",
    "pi": "it is not a number of the course; for a product write p*i",
    **dict.fromkeys(("nan", "NaN", "NAN", "inf", "Inf", "INF", "infinity", "oo", "zoo", "None"), _NO_NUMBER),
    **dict.fromkeys(("sin", "cos", "tan", "exp", "log", "ln", "sign", "max", "min", "floor", "ceil"), _NO_FUNCTION),
    **dict.fromkeys(("import", "lambda", "eval", "exec", "open", "os", "sys", "def", "class", "for", "if"), PROGRAM),
    **dict.fromkeys(("print", "while", "return", "else", "not", "is", "del", "global", "assert", "raise"), PROGRAM),
    **dict.fromkeys(("range", "list", "input", "getattr", "globals", "locals", "vars", "yield", "await"), PROGRAM),
}


def short(word):
    """The word in quotes, cut where it is long."""
    return f'"{word}"' if len(word) <= 20 else f'"{word[:20]}..."'


def about(word):
    """What is wrong with a word that is no name of the language, and what to write."""
    if word in ADVICE:
        return f"{short(word)} alone is not read: {ADVICE[word]}"
    if len(word) == 2 and word[0] == "d" and word[1] in LETTERS:
        return f"{word} belongs to an integral: write integral(t^2, t, 0, 1), and a derivative as diff(t^2, t)"
    if len(word) == 1:
        return f'"{word}" is not a letter of the course; take one of {", ".join(sorted(LETTERS, key=str.swapcase))}'
    if all(letter in LETTERS or letter == "b" for letter in word) and len(word) <= 4:
        return f'"{word}" is not a name; if you mean a product, write {"*".join(word)}'
    close = get_close_matches(word[:20], FUNCTIONS, n=1)
    help_ = (
        f"do you mean {close[0]}?" if close else "functions are B, binomial, factorial, sqrt, sum, integral, diff, g"
    )
    return f"{short(word)} is not a name that is read here; {help_}"


def about_command(command):
    """What is wrong with a LaTeX command that is not read, and what to write."""
    if command in COMMAND_ADVICE:
        return f"\\{command} is not read here: {COMMAND_ADVICE[command]}"
    close = get_close_matches(command[:20], [*COMMANDS, "binom"], n=1)
    shown = command if len(command) <= 20 else command[:20] + "..."
    help_ = f"do you mean \\{close[0]}?" if close else r"write it without LaTeX, or with \frac, \binom, \sum, \int"
    return f"\\{shown} is not a LaTeX command that is read here; {help_}"
