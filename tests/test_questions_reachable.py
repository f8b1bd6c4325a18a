"""Each task of a lesson can be done on its own board: where a drag ends is on the grid and within the view."""

import ast
from fractions import Fraction as F

import pytest

from bezteach.lessons import ROOT, parsed
from bezteach.numeric.bspline import insert
from bezteach.questions import GOALS
from bezteach.questions.bsplines import CUBIC, CUBIC_KNOTS

LESSONS = sorted((ROOT / "lessons").glob("[0-9][0-9]-*.ipynb"))
STOPS = {F(k, 24) for k in range(25)}  # of the sliders of t, a and b
DONE = {  # worked on paper: {control point: where it is dragged to}, and what else is set
    "start/lift": ({1: (2, 6)}, {}),
    "why/through": ({1: (F(3, 2), F(3, 2))}, {}),
    "definitions/closed": ({3: (-9, 0)}, {}),
    "basis/straight": ({1: (F(1, 3), F(1, 3)), 2: (F(2, 3), F(2, 3))}, {}),
    "curve/velocities": ({1: (2, 0), 2: (3, 5)}, {}),
    "curve/three-crossings": ({}, {"line": ((0, 1), (2, 2))}),
    "curve/dented": ({2: (F(1, 2), F(1, 8))}, {}),
    "curve/pulled": ({2: (4, 2)}, {}),
    "casteljau/horizontal": ({}, {"t": F(2, 3)}),
    "casteljau/still": ({2: (0, 0)}, {}),
    "operator/no-second-difference": ({1: (1, 1), 2: (2, 2)}, {}),
    "derivatives/straight-start": ({2: (F(3, 2), 3)}, {}),
    "derivatives/same-circle": ({2: (2, 0)}, {}),
    "derivatives/cusp": ({1: (3, 2), 2: (0, 2)}, {}),
    "splitting/middle-edge": ({}, {"a": F(1, 3), "b": F(2, 3)}),
    "splitting/just-enough": ({}, {"depth": 4}),
    "splitting/three-changes-one-root": ({1: (F(1, 3), 1), 2: (F(2, 3), -1)}, {}),
    "elevation/parabola": ({2: (3, 4)}, {}),
    "elevation/cut-off": ({}, {"line": ((0, F(5, 2)), (3, F(5, 2)))}),
    "joining/no-corner": ({4: (6, 4)}, {}),
    "joining/clock": ({}, {"t": F(1, 3)}),
    "joining/close-the-frame": ({5: (8, 2)}, {}),
    "joining/same-bend": ({5: (7, 2)}, {}),
    "bsplines/two-spans": ({1: (0, 6)}, {}),
    "bsplines/quarter": ({}, {"knots": (0, 0, 0, 1, F(3, 2), 3, 4, 4, 4)}),
    "bsplines/corner": ({}, {"knots": (0, 0, 0, 2, 2, 3, 4, 4, 4)}),
    "bsplines/insert": ({}, dict(zip(("points", "knots"), insert(CUBIC, CUBIC_KNOTS, 2, 2), strict=True))),
    "bsplines/through": ({}, {"knots": (0, 0, 0, 0, 2, 2, 2, 4, 4, 4, 4)}),
    "rational/circle": ({}, {"w": F(2)}),
    "rational/through": ({}, {"w": F(2)}),
}


def names_in(line):
    return {node.id for node in ast.walk(line) if isinstance(node, ast.Name)}


def shown_by(sources):
    """What the last line of the last cell shows; before it only imports and the assignments that it needs are run."""
    *before, last = ast.parse("\n".join(sources)).body
    needed, run = names_in(last), []
    for line in reversed(before):
        imports = isinstance(line, ast.Import | ast.ImportFrom)
        if imports or isinstance(line, ast.Assign) and any(names_in(target) & needed for target in line.targets):
            needed |= names_in(line)
            run.insert(0, line)
    space = {}
    exec(compile(ast.Module(run, []), "lesson", "exec"), space)
    return eval(compile(ast.Expression(last.value), "lesson", "eval"), space)


def board_of(goal):
    """The board, fresh, on which a lesson sets a task."""
    shown = shown_with(goal)
    return getattr(shown, "board", shown)


def shown_with(goal):
    """What a lesson shows, fresh, with a task: a board, or a panel with a board and controls."""
    for path in LESSONS:
        cells = parsed(path.read_text(encoding="utf-8")).cells
        sources = [cell.source for cell in cells if cell.cell_type == "code"]
        for place, source in enumerate(sources):
            if f'GOALS["{goal}"]' in source:
                return shown_by(sources[: place + 1])
    raise ValueError(f"no lesson has the task {goal}")


def out_of_reach(board, places):
    """The places where no drag ends."""
    x0, y0, x1, y1 = board.view
    return [
        (x, y)
        for x, y in places
        if F(x) % F(board.grid) or F(y) % F(board.grid) or not (x0 <= x <= x1 and y0 <= y <= y1)
    ]


def test_every_task_has_its_solution_here():
    assert set(DONE) == set(GOALS)


@pytest.mark.parametrize("name", DONE)
def test_a_task_can_be_done_on_its_board(name):
    goal, shown = GOALS[name], shown_with(name)
    board, controls = getattr(shown, "board", shown), getattr(shown, "controls", {})
    moved, settings = DONE[name]
    assert goal.text in board.text and not goal.reached(board.state)
    here = {setting: value for setting, value in settings.items() if setting not in controls}
    dragged = {"points": [moved.get(i, there) for i, there in enumerate(board.points)]}
    board.change(**(dragged | here))  # an inserted knot brings its own points
    for setting in settings.keys() - here.keys():
        controls[setting].value = settings[setting]  # which has no stop but its own
    assert goal.praise in board.text and (here != settings or goal.reached(board.state))
    assert {settings.get(parameter, F(0)) for parameter in "tab"} <= STOPS
    free = [(0, y) if board.vertical else (x, y) for x, y in moved.values()]  # up and down only
    assert out_of_reach(board, [*free, *settings.get("line", ())]) == []
    assert [knot for knot in settings.get("knots", ()) if F(knot) % F(board.limits["knots"])] == []


def test_what_no_drag_reaches_is_seen():
    board = board_of("curve/velocities")
    assert out_of_reach(board, [(2, 0), (3, 5), (3, F(21, 4))]) == []
    assert out_of_reach(board, [(3, 6), (F(1, 3), 0), (-1, 0)]) == [(3, 6), (F(1, 3), 0), (-1, 0)]
