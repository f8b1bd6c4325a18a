"""The tokens under the reader's finger: what comes next, what is missing, lists, brackets, and how much was read."""

from . import latex
from .errors import InvalidAnswer
from .names import about, short

MAX_NODES = 400
MAX_DEPTH = 40
MAX_ROOTS = 16  # products of roots are dear in SymPy
MAX_ITEMS = 64
CLOSING = {"(": ")", "[": "]", "{": "}"}
RELATIONS = ("=", "<", "<=", ">", ">=")


class Reader:
    """The tokens, how far they are read, how many parts were built and how deep they are nested."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.index = self.nodes = self.roots = self.depth = 0

    @property
    def token(self):
        return self.tokens[self.index]

    def sees(self, *signs):
        return self.token.kind == "sign" and self.token.text in signs

    def advance(self):
        self.index += 1
        return self.tokens[self.index - 1]

    def wrong(self, message):
        """The error that stands at the next token."""
        return InvalidAnswer(message, self.token.position)

    def expect(self, sign, help_):
        if not self.sees(sign):
            raise self.wrong(f'"{sign}" is missing here: {help_}')
        return self.advance()

    def count(self, position, root=False):
        """One part more, which may be a root."""
        self.nodes += 1
        self.roots += root
        if self.nodes > MAX_NODES:
            raise InvalidAnswer(f"the formula has more than {MAX_NODES} parts: write less", position)
        if self.roots > MAX_ROOTS:
            raise InvalidAnswer(f"the formula has more than {MAX_ROOTS} roots: write fewer", position)

    def nested(self, read, *args):
        """Read something one level deeper."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.wrong(f"this is nested more than {MAX_DEPTH} deep: write it in fewer brackets")
        value = read(*args)
        self.depth -= 1
        return value

    def end(self):
        """Nothing may be left."""
        if self.token.kind != "end":
            raise self.wrong(self._surplus())

    def _surplus(self):
        if self.sees(*")]}"):
            return f'"{self.token.text}" closes a bracket that was not opened: leave it out, or open it before'
        if self.sees(*RELATIONS):
            return (
                f'one statement at a time: write "{self.token.text}" outside brackets, and a comma between statements'
            )
        if self.sees("_"):
            return "_ is read after the names of points only: write b_0, or another letter"
        if latex.is_differential(self.token):
            return about(self.token.text)
        return f"{short(self.token.text)} does not fit here: write + - * or / before it"

    def items(self, read, closing):
        """What ``read`` reads once; with commas, a tuple."""
        values, comma = [], False
        while True:
            if len(values) == MAX_ITEMS:
                raise self.wrong(f"the list has more than {MAX_ITEMS} items: write less")
            values.append(read())
            if not self.sees(","):
                break
            comma = True
            position = self.advance().position
            if self.token.kind == "end" if closing == "end" else self.sees(closing):
                break
        if comma:
            self.count(position)
        return tuple(values) if comma else values[0]

    def bracket(self, read=None):
        """What stands in brackets; with commas, a tuple."""
        opened = self.advance()
        closing = CLOSING[opened.text]
        if self.sees(closing):
            raise InvalidAnswer("nothing is written in these brackets: fill them, or leave them out", opened.position)
        value = self.items(read or self.formula, closing)
        self._close(opened)
        if opened.text == "{" and isinstance(value, tuple) and read is None:
            raise InvalidAnswer("a list or a point is written in ( ) or [ ], not in braces", opened.position)
        return value

    def _close(self, opened):
        if self.token.kind == "end":
            raise InvalidAnswer(
                f'the bracket "{opened.text}" is not closed: write "{CLOSING[opened.text]}"', opened.position
            )
        if self.sees(*")]}") and not self.sees(CLOSING[opened.text]):
            message = f'"{opened.text}" is closed by "{self.token.text}": write "{CLOSING[opened.text]}"'
            raise self.wrong(message)
        if not self.sees(CLOSING[opened.text]):
            raise self.wrong(self._surplus())
        self.advance()
