"""From a text to tokens: full-width signs, powers such as ², LaTeX commands, and help with every other character."""

import re
from typing import NamedTuple
from unicodedata import category, decomposition, name

from .errors import InvalidAnswer
from .names import ADVICE, COMMANDS, FONTS, FUNCTIONS, LETTERS, POINTS, PROGRAM, about, about_command

MAX_TEXT = 2000


class Token(NamedTuple):
    kind: str  # "number", "name", "command", "sign" or "end"
    text: str
    position: int


SIGNS = {
    **dict.fromkeys("−–—‐‑﹣", "-"),
    **dict.fromkeys("×·⋅∙∗•✕", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    **dict.fromkeys("≤⩽≦", "<="),
    **dict.fromkeys("≥⩾≧", ">="),
    **{"≡": "=", "、": ",", "【": "[", "】": "]", "ˆ": "^", "√": r"\sqrt ", "∑": r"\sum ", "∫": r"\int "},
}
HELP = {
    "∞": "infinity is not a number here",
    "≠": "only =, <, <=, > and >= are read",
    "≈": "only exact equality is read, write =",
    "∈": "write the range with signs, 0 <= t <= 1",
    "±": "write the two values apart, with a comma",
    "…": "where it stands for an answer, replace it; a sum is written sum(i^2, i, 0, n)",
    "′": "write a derivative as diff(t^2, t)",
    "∂": "write a derivative as diff(t^2, t)",
    "Δ": "write the difference with the operator, (E - 1)",
    "Σ": "write sum(i^2, i, 0, n)",
    "½": "write 1/2",
    "¼": "write 1/4",
    "¾": "write 3/4",
    "。": "write . for the point, and nothing at the end",
    "：": "put a comma between two things",
    "；": "put a comma between two things",
}
WRONG_SIGNS = {
    "__": f"__ is not read: {PROGRAM}",
    "...": "... is the place for your answer: write the answer instead, and all terms of a sum",
    ":=": ":= is not read: write = for an equation",
    "!=": '!= is not read: write "n! = 6" with a space for a factorial; an inequality has one of <, <=, >, >=',
    "//": "// is not read: write one / for a fraction",
    "=<": "=< is not read: write <=",
    "=>": "=> is not read: write >=",
    "<<": "<< is not read: write <",
    ">>": ">> is not read: write >",
    "->": "-> is not read: write an equation with =",
    "||": "|| is not read: write abs(...) for an absolute value",
    "|": "| is not read: write abs(...) for an absolute value",
    "'": "' is not read: write a derivative as diff(t^2, t), and leave out quotation marks",
    '"': 'leave out the quotation mark ": write only the formula',
    "`": "leave out the mark `: write only the formula",
    ".": ". is not read here: a decimal number looks like 0.25, and nothing else has a point",
    ";": "; is not read: put a comma between two things",
    ":": ": is not read: put a comma between two things, and write / for a division",
    "$": "leave out the $ signs: write only the formula",
    "&": "& is not read: put a comma between two statements",
    "%": "% is not read: write 1/4 for 25 percent",
    "~": "~ is not read: write - for minus",
    "#": "# is not read: write only the formula",
    "@": "@ is not read: write * for a product",
    "?": "? is not read: write only the formula",
}
READ_SIGNS = {"**": "^", "==": "=", "<=": "<=", ">=": ">=", **{sign: sign for sign in "+-*/^!()[]{},=<>_"}}
_SPACES = " \t\n\r"


def tokens_of(text):
    """The tokens of a text, the last one of kind "end"; InvalidAnswer for what can stand in no formula."""
    if type(text) is not str:
        raise InvalidAnswer('a formula is a text in quotes, such as "t*(1 - t)"')
    if len(text) > MAX_TEXT:
        raise InvalidAnswer(f"the text has {len(text)} characters, {MAX_TEXT} are read: write less", MAX_TEXT + 1)
    plain, positions = _plain(text)
    tokens, at = [], 0
    while at < len(plain):
        length, found = _next(plain, at, positions)
        tokens += found
        at += length
    if not tokens:
        raise InvalidAnswer("nothing is written here: write a formula such as t*(1 - t)", 1)
    return [*tokens, Token("end", "", len(text.rstrip()) + 1)]


def _plain(text):
    """The text in ASCII, and for each of its characters the place in the given text that it comes from."""
    plain, positions, script = "", [], ""
    for position, char in enumerate(text, 1):
        now, char = _in_ascii(char, position)
        piece = char if now == script else "}" * bool(script) + (now + "{" if now else "") + char
        plain, script = plain + piece, now
        positions += [position] * len(piece)
    return plain + "}" * bool(script), [*positions, len(text) + 1]


def _in_ascii(char, position):
    """What a character is read as: "^" or "_" where it stands raised or lowered, and its ASCII form."""
    if char in _SPACES or char.isascii() and char.isprintable():
        return "", char
    if char in SIGNS:
        return "", SIGNS[char]
    if category(char) == "Zs":
        return "", " "
    kind, _, codes = decomposition(char).partition(" ")
    if kind in ("<wide>", "<font>", "<small>", "<super>", "<sub>") and " " not in codes and char not in HELP:
        script, plain = _in_ascii(chr(int(codes, 16)), position)
        return script or {"<super>": "^", "<sub>": "_"}.get(kind, ""), plain
    title = name(char, "a character without a name")
    kind = {"Cf": "the invisible character ", "Cc": "a control character, "}.get(category(char), "")
    if char in HELP:
        advice = HELP[char]
    elif kind:
        advice = "delete it, or type the line again"
    elif title.startswith("GREEK"):
        advice = "Greek letters are not read; take a Latin letter such as w"
    elif title.startswith("CYRILLIC"):
        advice = "it only looks like a Latin letter; type the Latin one"
    else:
        advice = "only Latin letters, digits and the signs + - * / ^ ! ( ) , = < > are read"
    raise InvalidAnswer(f"this is {kind}{title} (U+{ord(char):04X}): {advice}", position)


def _next(plain, at, positions):
    """How many characters the next tokens take, and the tokens, none for a space."""
    char, position = plain[at], positions[at]
    if char in _SPACES:
        return 1, []
    if char.isdigit() or char == "." and plain[at + 1 : at + 2].isdigit():
        number = re.match(r"\d*(\.\d+)?", plain[at:])[0]
        return len(number), [Token("number", number, position)]
    if char.isalpha():
        word = re.match("[A-Za-z]+", plain[at:])[0]
        return len(word), _names(word, positions[at:])
    if char == "\\":
        return _command(plain, at, positions)
    for sign in (plain[at : at + 3], plain[at : at + 2], char):
        if sign in READ_SIGNS:
            return len(sign), [Token("sign", READ_SIGNS[sign], position)]
        if sign in WRONG_SIGNS:
            raise InvalidAnswer(WRONG_SIGNS[sign], position)
    raise AssertionError(char)  # every printable ASCII character is a digit, a letter or in one of the tables


def _names(word, positions):
    """A word, or the names it is made of: a capital letter begins a new one, so tE and nB(i, n, t) are products."""
    pieces = [piece for piece in re.split("([EBC])", word) if piece]
    if ADVICE.get(word) == PROGRAM:
        raise InvalidAnswer(about(word), positions[0])
    known = all(piece in LETTERS or piece in POINTS or piece in ("B", "C", "g") for piece in pieces)
    if not known or word in FUNCTIONS or word in ADVICE:
        return [Token("name", word, positions[0])]
    starts = [sum(map(len, pieces[:number])) for number in range(len(pieces))]
    return [Token("name", piece, positions[start]) for piece, start in zip(pieces, starts, strict=True)]


def _command(plain, at, positions):
    command, position = re.match(r"\\([A-Za-z]+|.?)", plain[at:], re.DOTALL)[1], positions[at]
    length = 1 + len(command)
    if command in ("", "\\", "(", ")", "[", "]", "&"):
        raise InvalidAnswer(f"\\{command} is not read: write only the formula, on one line", position)
    if command in FONTS:
        letter = re.match(r"\s*\{\s*([A-Za-z])\s*\}", plain[at + length :])
        if not letter:
            raise InvalidAnswer(rf"after \{command} one letter in braces is read, \{command}{{b}}", position)
        return length + letter.end(), [Token("name", letter[1], positions[at + length + letter.start(1)])]
    if command in ("{", "}"):
        return length, [Token("sign", command, position)]
    if command in (",", ";", ":", "!", *_SPACES):
        return length, []
    if command not in COMMANDS:
        raise InvalidAnswer(about_command(command), position)
    meaning = COMMANDS[command]
    kind = "sign" if meaning in READ_SIGNS else "command"
    return length, [Token(kind, meaning, position)] if meaning else []
