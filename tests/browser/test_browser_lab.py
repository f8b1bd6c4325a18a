"""Board and lesson in JupyterLab: what is moved on the screen is moved in Python, and Python's numbers come back."""

from fractions import Fraction as F

import pytest
from browser_screen import Screen
from browser_servers import A_BOARD, POINTS, SHOW, copy_lesson, jupyterlab, write_notebook
from playwright.sync_api import expect

from bezteach.widgets import Board

LESSON = "08-splitting.ipynb"
VIEW = Board(POINTS).view
VIEWPORT = {"width": 1200, "height": 900}


@pytest.fixture(scope="session")
def server(tmp_path_factory):
    folder, home = tmp_path_factory.mktemp("work"), tmp_path_factory.mktemp("home")
    write_notebook(folder / "board.ipynb", *A_BOARD)
    copy_lesson(LESSON, folder)
    with jupyterlab(folder, home) as running:
        yield running


@pytest.fixture(scope="module")
def opened(window, server):
    with window(server.address, viewport=VIEWPORT) as one:
        yield one


# ---- A notebook with a board


def after(points=POINTS, t=F(1, 3)):
    """The board in Python with these settings; without any, as the notebook makes it."""
    return Board(points, t, SHOW, view=VIEW)


def moved(index, to):
    """The control points with one of them elsewhere."""
    return [to if i == index else point for i, point in enumerate(POINTS)]


@pytest.fixture(scope="module")
def notebook(opened, server):
    server.run_all(opened.page, "board.ipynb")
    return opened.page


@pytest.fixture
def screen(notebook, opened):
    screen = Screen(notebook)
    screen.button("Reset").click()
    assert screen.shows(after())
    yield screen
    assert opened.complaints() == []


def printed(page):
    """What the second cell prints when it is run now."""
    cell = page.locator(".jp-CodeCell").nth(1)
    before = cell.locator(".jp-InputPrompt").text_content()
    cell.locator(".cm-content").click()
    page.keyboard.press("Control+Enter")
    expect(cell.locator(".jp-InputPrompt")).not_to_have_text(before)
    expect(cell.locator(".jp-InputPrompt")).not_to_have_text("[*]:")
    return cell.locator(".jp-OutputArea-output").text_content().strip()


def test_the_mouse_moves_a_point_in_python_too(screen):
    screen.drag(1, (F(3, 2), F(5, 2)), VIEW)
    board = after(moved(1, (F(3, 2), F(5, 2))))
    assert screen.shows(board)
    assert printed(screen.page) == str(board.points)


def test_the_keyboard_moves_a_point_in_python_too(screen):
    screen.handle(2).press("ArrowLeft")
    screen.page.keyboard.press("Shift+ArrowUp")
    board = after(moved(2, (F(7, 4), F(9, 4))))
    assert screen.shows(board)
    assert printed(screen.page) == str(board.points)


def test_keys_on_the_board_are_not_jupyterlab_s_commands(screen):
    """There b inserts a cell, x cuts one, and the arrows mark another."""
    cells = screen.page.locator(".jp-Cell").count()
    screen.handle(2).focus()
    for key in ("b", "x", "ArrowUp", "Control+z"):
        screen.page.keyboard.press(key)
    assert screen.shows(after())
    assert screen.page.locator(".jp-Cell").count() == cells
    assert screen.handle(2).evaluate("handle => handle === document.activeElement")


def test_the_slider_moves_t(screen):
    screen.slider().press("ArrowRight")
    assert screen.shows(after(t=F(3, 8)))
    screen.slider().press("End")
    assert screen.shows(after(t=F(1)))


def test_many_moves_end_where_the_last_one_went(screen):
    screen.handle(0).focus()
    for key in ["ArrowRight", "ArrowUp"] * 8:
        screen.page.keyboard.press(key)
    assert screen.shows(after(moved(0, (2, 2))))


# ---- The lesson


def test_the_lesson_runs_and_shows_formulas_and_widgets(window, server):
    with window(server.address, viewport=VIEWPORT) as opened:
        page = opened.page
        server.run_all(page, LESSON)
        expect(page.locator(".jp-RenderedLatex:not(:has(mjx-container))")).to_have_count(0)
        assert page.locator(".jp-RenderedLatex").count() > 10
        assert page.locator("mjx-merror").count() == 0
        assert page.locator("[data-mime-type$='stderr'], [data-mime-type$='error']").count() == 0
        assert page.get_by_text("Error displaying widget").count() == 0
        assert page.locator(".jp-OutputArea .jupyter-widgets, .jp-OutputArea .bt-board").count() > 0
