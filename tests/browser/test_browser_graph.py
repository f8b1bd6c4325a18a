"""Graphs, whose points move up and down only, and boards with a line, whose two points are moved as well."""

from fractions import Fraction as F

import pytest
from browser_screen import Screen, reachable_page

from bezteach.widgets import Board

GRAPH = ((0, 0), (F(1, 3), 1), (F(2, 3), 0), (1, 1))
CUBIC = ((0, 0), (1, 3), (2, 1), (3, 3))
CENTRES = """(root, name) => [...root.querySelectorAll(name)].map(one => {
  const { x, y, width, height } = one.getBoundingClientRect();
  return [x + width / 2, y + height / 2];
})"""


@pytest.fixture(scope="module")
def opened(window):
    with window("file:", offline=True, viewport={"width": 1200, "height": 800}) as one:
        yield one


@pytest.fixture
def shown(opened, tmp_path):
    """A function from a board to its page on the screen."""

    def show(board):
        opened.page.goto(reachable_page(board, tmp_path))
        return Screen(opened.page)

    yield show
    assert opened.complaints() == []


def written(points):
    return [f"({x}, {y})" for x, y in points]


# ---- Graphs


def graph(*heights, view=(-0.1, -1, 1.1, 2)):
    return Board(list(zip((0, F(1, 3), F(2, 3), 1), heights, strict=True)), vertical=True, grid=F(1, 4), view=view)


@pytest.mark.parametrize("key", ["Delete", "Backspace"])
def test_the_number_of_a_graph_s_points_stays(shown, key):
    screen = shown(graph(0, 1, 0, 1))
    screen.handle(1).press(key)
    assert screen.points() == written(GRAPH)
    assert screen.button("Add point").count() == screen.button("Remove point").count() == 0
    screen.handle(1).press("ArrowUp")  # the keys after it go on as before
    assert screen.points()[1] == "(1/3, 5/4)"


def test_a_view_that_changes_meanwhile_waits_for_the_end_of_a_drag(shown):
    screen = shown(graph(0, 1, 0, 1))
    mouse, [x, y] = screen.page.mouse, dots(screen)[1]
    step = (dots(screen)[0][1] - y) / 4
    mouse.move(x, y)
    mouse.down()
    mouse.move(x, y - step)
    screen.page.evaluate("board.set('view', [-0.1, -8, 1.1, 8])")
    mouse.move(x, y - 2 * step)
    assert screen.points()[1] == "(1/3, 3/2)"
    assert dots(screen)[1] == pytest.approx([x, y - 2 * step], abs=1)
    mouse.up()
    assert dots(screen)[0][1] - dots(screen)[1][1] < 4 * step
    assert screen.draws(graph(0, F(3, 2), 0, 1, view=(-0.1, -8, 1.1, 8)))


# ---- A line


def lined(*line):
    return Board(CUBIC, show=("polygon", "curve", "line"), line=line)


def dots(screen):
    return screen.root.evaluate(CENTRES, ".bt-dot")


def names(screen):
    return screen.root.evaluate(CENTRES, ".bt-handle text")


@pytest.mark.parametrize(("line", "index"), [([(1, 3), (0, 1)], 0), ([(0, 1), (2, 1)], 1)], ids="PQ")
def test_the_mouse_takes_a_line_s_point_that_lies_on_a_control_point(shown, line, index):
    screen = shown(lined(*line))
    mouse, [x, y] = screen.page.mouse, dots(screen)[4 + index]
    assert [x, y] in dots(screen)[:4]
    mouse.move(x, y)
    mouse.down()
    mouse.move(x, y + 60, steps=3)
    mouse.up()
    assert screen.points() == written(CUBIC)
    assert screen.handle(index, of="line").get_attribute("aria-valuetext") not in screen.points()


LINES = [
    [(1, F(17, 6)), (2, F(17, 6))],  # P just under a control point
    [(2, F(5, 6)), (3, 1)],
    [(1, 3), (2, 1)],  # both on control points
    [(F(1, 2), 3), (F(9, 10), 1)],  # upright, nearly
    [(0, 0), (1, 0)],
]


@pytest.mark.parametrize("line", LINES)
@pytest.mark.parametrize("projector", [False, True], ids=["small", "large"])
def test_the_names_of_a_line_s_points_cover_no_control_point_and_no_name(shown, line, projector):
    board = lined(*line)
    board.projector = projector
    screen = shown(board)
    size = 1.6 if projector else 1
    for at, dot in zip(names(screen)[4:], dots(screen)[4:], strict=True):
        assert distance(at, dot) < 32 * size
        assert min(distance(at, other) for other in dots(screen)) > 16 * size
        assert min(distance(at, other) for other in names(screen)[:4]) > 16 * size


def distance(p, q):
    return abs(complex(*p) - complex(*q))
