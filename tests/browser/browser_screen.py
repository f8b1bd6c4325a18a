"""A board on a screen as a reader has it: what is shown there, held against Python, and what can be done to it."""

import re
from itertools import zip_longest
from xml.etree import ElementTree

from bezteach.widgets.board import svg
from bezteach.widgets.board.export import page

SVG = "{http://www.w3.org/2000/svg}"
PLACES = ("points", "cx", "cy", "r", "x", "y", "width", "height", "viewBox")
WEIGHTS = {"stroke-width": "1", "stroke-dasharray": "", "fill-opacity": "1"}  # with what it is where nothing is said
NEAR = 0.5  # pixels

# Every element of the picture as {tag, text, attribute: ...}: the marks of each frame, and on top what can be moved.
PICTURE = """root => {
  const svg = root.querySelector(".bt-picture > svg");
  const [frames, handles] = svg.children;
  const told = node => ({
    tag: node.tagName,
    text: node.textContent,
    ...Object.fromEntries([...node.attributes].map(({ name, value }) => [name, value])),
  });
  return {
    svg: told(svg),
    frames: [...frames.children].map(frame => ({ ...told(frame), marks: [...frame.children].map(told) })),
    handles: [...handles.children].map(handle => ({ ...told(handle), parts: [...handle.children].map(told) })),
  };
}"""
# Its words, row by row, and those that Python's HTML has.
WORDS = """(root, html) => {
  const python = new DOMParser().parseFromString(html, "text/html");
  const words = node => [...node.querySelectorAll("b, p, td")].map(one => one.textContent);
  return [words(root.querySelector(".bt-readout")), words(python)];
}"""


def reachable_page(board, folder):
    """The address of a board's exported page, with its stand-in for Python as ``board`` within the reach of a test."""
    hidden, reachable = "model: standIn(", "model: globalThis.board = standIn("
    content = page(board, "a board")
    assert content.count(hidden) == 1
    (folder / "board.html").write_text(content.replace(hidden, reachable), encoding="utf-8")
    return (folder / "board.html").as_uri()


class Screen:
    """The board in a page, or in a part of one; it is read when it is asked for."""

    def __init__(self, page, root=".bt-board"):
        self.page, self.root = page, page.locator(root)

    # -- what is shown

    def picture(self):
        return self.root.evaluate(PICTURE)

    def points(self):
        """The control points as they are said to somebody who does not see them."""
        return [handle["aria-valuetext"] for handle in _points(self.picture())]

    def draws(self, board):
        """Whether the picture is that of this board."""
        assert differences(self.picture(), board) == []
        return True

    def shows(self, board):
        """Whether picture and exact numbers are those of this board, as soon as the numbers have come."""
        self.root.locator(".bt-readout:not(.bt-stale)").wait_for()
        shown, right = self.root.evaluate(WORDS, board.answer["html"])
        assert shown == right
        return self.draws(board)

    # -- what can be done

    def handle(self, index, of="points"):
        return self.root.locator(f'[data-handle="{of}{index}"]')

    def button(self, name):
        return self.root.get_by_role("button", name=name, exact=True)

    def slider(self, name="t"):
        return self.root.get_by_role("slider", name=name, exact=True)

    def layer(self, label):
        """The box that switches a layer."""
        if self.root.locator("details:not([open])").count():
            self.root.locator("summary").click()
        return self.root.get_by_label(label)

    def place(self, point, view, line=None):
        """Where in the window a point of the plane is, or one of the knots' line, of which that is the view."""
        picture = self.picture()
        knots = any(one["data-handle"].startswith("knots") for one in picture["handles"])
        _, rectangles = svg.layout(int(picture["svg"]["width"]), view, len(picture["frames"]) > 1, line=knots)
        frame = svg.Frame(rectangles[0], view) if line is None else svg.Frame(rectangles[1], line, True)
        ((x, y),) = frame.place([point])
        box = self.root.locator(".bt-picture > svg").bounding_box()
        return box["x"] + x, box["y"] + y

    def drag(self, index, to, view):
        """Move a control point with the mouse to some pixels off the place: it snaps."""
        self.handle(index).scroll_into_view_if_needed()
        box = self.handle(index).locator(".bt-dot").bounding_box()
        x, y = self.place(to, view)
        mouse = self.page.mouse
        mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        mouse.down()
        mouse.move(x + 4, y - 3, steps=5)
        mouse.up()


# ---- One picture, drawn twice


def differences(picture, board):
    """Pairs (what the browser has, what Python draws) that are not the same: [] for the same picture.

    Python's last dots and names, the control points, are handles in the browser, apart from the marks and larger.
    """
    width, count = int(picture["svg"]["width"]), len(board.points)
    options = {"stretched": board.vertical, "line": board.line_view}
    drawn = ElementTree.fromstring(svg.picture(board.marks, board.view, "", width, **options))
    frames = drawn.findall(f"{SVG}svg")
    marks = [[_told(element) for element in frame] for frame in frames]
    marks[0], dots, names = marks[0][: -2 * count], marks[0][-2 * count : -count], marks[0][-count:]
    handles = [handle["parts"] for handle in _points(picture)]
    knots = [handle["parts"] for handle in picture["handles"] if handle["data-handle"].startswith("knots")]
    if knots:
        marks[1], stacked = marks[1][: -len(board.knots)], marks[1][-len(board.knots) :]
    pairs = [
        (_only(picture["svg"], "width", "height"), _only(drawn.attrib, "width", "height")),
        *_pairs(picture["frames"], map(_told, frames)),
        *_pairs([name for name, _, _ in handles], names),
        *_pairs([_only(ring, "cx", "cy") for _, ring, _ in handles], [_only(dot, "cx", "cy") for dot in dots]),
        *_pairs([_only(dot, "cx", "cy") for _, _, dot in handles], [_only(dot, "cx", "cy") for dot in dots]),
    ]
    for part in (0, 1) if knots else ():
        pairs += _pairs(
            [_only(parts[part], "cx", "cy") for parts in knots], [_only(dot, "cx", "cy") for dot in stacked]
        )
    for frame, elements in zip(picture["frames"], marks, strict=False):
        pairs += _pairs(frame["marks"], elements)
    return [(screen, python) for screen, python in pairs if not _same(screen, python)]


def _points(picture):
    return [handle for handle in picture["handles"] if handle["data-handle"].startswith("points")]


def _told(element):
    return {"tag": element.tag.removeprefix(SVG), "text": element.text or "", **element.attrib}


def _only(element, *names):
    return {name: element[name] for name in names}


def _pairs(screen, python):
    """What should be the same, side by side; {} where one of them has nothing."""
    return list(zip_longest(screen, python, fillvalue={}))


def _same(screen, python):
    alike = screen.get("tag") == python.get("tag") and all(_near(screen, python, name) for name in PLACES)
    if screen.get("tag") == "text":  # its colours come from the page's style
        return alike and screen["text"] == python["text"]
    if "stroke" not in python:
        return alike
    looks = [[_numbers(one.get(name, usual)) for name, usual in WEIGHTS.items()] for one in (screen, python)]
    return alike and looks[0] == looks[1] and all(_colour(screen[name]) == python[name] for name in ("fill", "stroke"))


def _near(screen, python, name):
    one, other = (_numbers(element.get(name, "")) for element in (screen, python))
    return len(one) == len(other) and all(abs(p - q) <= NEAR for p, q in zip(one, other, strict=True))


def _numbers(text):
    """The numbers in an attribute; what is none, as nan and 100%, is an error."""
    return [float(number) for number in re.split("[ ,]+", text) if number]


def _colour(text):
    """A colour of the page's style as Python writes it."""
    return svg.COLOURS[text[len("var(--bt-") : -1]] if text.startswith("var(") else text
