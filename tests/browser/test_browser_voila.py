"""Voila shows the notebook's board without the notebook, and Python answers to it."""

import re
from fractions import Fraction as F

import pytest
from browser_screen import Screen
from browser_servers import A_BOARD, POINTS, SHOW, voila, write_notebook

from bezteach.widgets import Board

ICONS = re.compile("fontawesome")  # Voila's page wants its icons from another server; a test does not leave the machine


@pytest.fixture(scope="session")
def server(tmp_path_factory):
    home = tmp_path_factory.mktemp("home")
    write_notebook(home / "board.ipynb", *A_BOARD)
    with voila(home / "board.ipynb", home) as running:
        yield running


def test_a_key_moves_a_point_and_python_says_where_everything_is(window, server):
    with window(server.address, stubbed=ICONS) as opened:
        opened.page.goto(server.address)
        screen = Screen(opened.page)
        assert screen.shows(Board(POINTS, show=SHOW))
        screen.handle(1).press("Shift+ArrowDown")
        moved = [(1, F(7, 4)) if point == (1, 3) else point for point in POINTS]
        assert screen.shows(Board(moved, show=SHOW, view=Board(POINTS).view))
