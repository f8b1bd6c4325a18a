"""What the browser paints by itself is what Python draws: at many positions, element by element."""

import json
import random
from fractions import Fraction as F
from itertools import pairwise

import pytest
from browser_screen import PICTURE, differences, reachable_page

from bezteach.palette import FIRST, INK, QUIET, SECOND
from bezteach.widgets import Board
from bezteach.widgets.board import LAYERS
from bezteach.widgets.board.marks import STYLES, Mark
from bezteach.widgets.board.state import DEEPEST, HIGHEST, OF_KNOTS

WIDTHS = (1200, 760, 400)  # of the window: readout beside the picture, under it, second frame under the first
STATES = 20  # at each width
PAINT = f"""([state, view, ends, marks]) => {{
  board.set("view", view);
  board.set("ends", ends);
  board.set("state", state);
  if (marks.length) board.set("answer", {{ ...board.get("answer"), marks }});
  return ({PICTURE})(document.querySelector(".bt-board"));
}}"""


@pytest.fixture(scope="module")
def opened(window):
    with window("file:", offline=True) as one:
        yield one


@pytest.fixture
def painted(opened, tmp_path):
    """A function from a board to the browser's picture of it; a page is made for the first one of its kind."""
    kinds = {}

    def paint(board, width):
        opened.page.set_viewport_size({"width": width, "height": 900})
        kind = (board.vertical, board.letter, board.knots is None)
        if kinds.get("open") != kind:
            kinds["open"] = kind
            opened.page.goto(reachable_page(board, tmp_path))
        sent = json.loads(
            json.dumps([board.get_state(["state"])["state"], board.view, board.ends, board.answer["marks"]])
        )
        return opened.page.evaluate(PAINT, sent)

    yield paint
    assert opened.complaints() == []


def random_board(chance):
    """Any number of points, any layers, any settings; the fractions have small denominators."""

    def number(low, high, part):
        return F(chance.randint(low * part, high * part), part)

    def point():
        return number(-6, 6, 4), number(-4, 5, 4)

    points = [point() for _ in range(chance.randint(2, 8))]
    line = [point(), point()]
    while line[0] == line[1]:
        line[1] = point()
    t, a, b = (number(0, 1, chance.choice((2, 3, 7, 24))) for _ in range(3))
    return Board(
        points,
        t,
        [name for name in LAYERS if chance.random() < 0.5],
        a=a,
        b=b,
        line=line,
        level=chance.choice([None, *range(len(points))]),
        end=chance.randint(0, 1),
        depth=chance.randint(0, DEEPEST),
        raised=chance.randint(0, HIGHEST),
    )


@pytest.mark.parametrize("width", WIDTHS)
def test_random_boards(painted, width):
    chance = random.Random(width)
    for _ in range(STATES):
        board = random_board(chance)
        assert differences(painted(board, width), board) == [], board.state


def random_spline(chance):
    """Any degree, any knots with any multiplicities up to one more than it, t a knot or between two, any layers."""
    degree, count = chance.randint(1, 5), chance.randint(1, 9)
    points = [(F(chance.randint(-24, 24), 4), F(chance.randint(-16, 20), 4)) for _ in range(degree + count)]
    while True:
        knots = sorted(F(chance.randint(0, 12), chance.choice((1, 2, 3))) for _ in range(2 * degree + count + 1))
        if all(one < other for one, other in zip(knots, knots[degree + 1 :], strict=False)):
            break
    inside = knots[degree : degree + count + 1]
    t = chance.choice([*inside, *((one + other) / 2 for one, other in pairwise(inside))])
    return Board(points, t, [name for name in OF_KNOTS if chance.random() < 0.6], knots=knots)


@pytest.mark.parametrize("width", WIDTHS)
def test_random_splines(painted, width):
    chance = random.Random(width)
    for _ in range(STATES):
        board = random_spline(chance)
        assert differences(painted(board, width), board) == [], board.state


DEGENERATE = {
    "two points": [(0, 0), (2, 1)],
    "all points in one": [(1, 1)] * 4,
    "on one line": [(0, 0), (1, 1), (3, 3), (2, 2)],
    "on one upright line": [(1, 0), (1, 3), (1, 1)],
    "closed": [(0, 0), (2, 3), (4, 1), (0, 0)],
    "ends that rest": [(0, 0), (0, 0), (2, 2), (3, 0), (3, 0)],
    "one point twice": [(0, 0), (1, 2), (1, 2), (3, 0)],
    "twenty points": [(i, i * i % 7) for i in range(20)],
}


@pytest.mark.parametrize("points", DEGENERATE.values(), ids=DEGENERATE)
def test_degenerate_points_in_all_layers(painted, points):
    for t in (F(0), F(1, 3), F(1)):
        board = Board(points, t, LAYERS, end=int(t))
        assert differences(painted(board, 1000), board) == [], board.state


@pytest.mark.parametrize(
    "line",
    [
        [(0, 0), (4, 0)],  # through both ends
        [(0, 2), (1, 2)],  # along an edge
        [(0, F(3, 2)), (1, F(3, 2))],  # touches the curve
        [(2, 0), (2, 1)],  # upright
        [(0, 5), (1, 5)],  # passes by
    ],
)
def test_lines_that_touch(painted, line):
    board = Board([(0, 0), (1, 2), (3, 2), (4, 0)], show=["line"], line=line)
    assert differences(painted(board, 1000), board) == []


def extra(state):
    """One mark of each kind, in both frames, depending on the state."""
    points = tuple(tuple(map(float, point)) for point in state.points)
    kinds = ("line", "area", "curve", "dots", "squares")
    marks = [Mark(kind, points, STYLES["left"], frame=frame) for kind in kinds for frame in (0, 1)]
    names = tuple(f"<{i}> & more" for i in range(len(points)))
    marks += [Mark(kind, points, words=names) for kind in ("names", "below")]
    return marks + [Mark(kind, points[:2], STYLES["hull"]) for kind in ("whole", "circle")]


@pytest.mark.parametrize("settings", [{}, {"vertical": True, "letter": "f"}], ids=["plane", "graph"])
def test_marks_that_come_from_python_under_the_layers(painted, settings):
    for t in (F(0), F(2, 5)):
        board = Board([(0, 1), (1, 3), (2, -2), (3, 0)], t, ["curve", "levels"], marks=extra, **settings)
        assert differences(painted(board, 1200), board) == []


def test_the_page_has_the_palette_s_colours(opened, painted):
    painted(Board([(0, 0), (1, 1)]), 1200)
    style = "name => getComputedStyle(document.querySelector('.bt-board')).getPropertyValue(name)"
    shown = {name: opened.page.evaluate(style, f"--bt-{name}").lower() for name in ("ink", "first", "second", "quiet")}
    assert shown == {"ink": INK, "first": FIRST, "second": SECOND, "quiet": QUIET}
