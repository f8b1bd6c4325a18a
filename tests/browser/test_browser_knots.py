"""The line of knots in a page without Python: knots are dragged, inserted by a click, moved by keys, all exactly."""

from fractions import Fraction as F

import pytest
from browser_screen import Screen, reachable_page

from bezteach.numeric import bspline
from bezteach.widgets import explore_bspline

POINTS = ((0, 0), (1, 3), (3, 4), (5, 1), (7, 3), (8, 0))
KNOTS = (0, 0, 0, 1, 2, 3, 4, 4, 4)  # the transcript's: degree 2
SHOW = ("polygon", "spline", "deboor")


def board(points=POINTS, knots=KNOTS, t=F(3, 2), show=SHOW, **settings):
    """The board in Python with these settings; without any, as the page is at its start."""
    made = explore_bspline(points, knots, t, show=show, **settings)
    made.view, made.ends = START.view, START.ends
    return made


START = explore_bspline(POINTS, KNOTS, F(3, 2), show=SHOW)


@pytest.fixture(scope="module")
def opened(window):
    with window("file:", offline=True, viewport={"width": 1200, "height": 900}) as one:
        yield one


@pytest.fixture
def screen(opened, tmp_path):
    opened.page.goto(reachable_page(START, tmp_path))
    yield Screen(opened.page)
    assert opened.complaints() == []


def centre(screen, index):
    box = screen.handle(index, of="knots").locator(".bt-dot").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag_knot(screen, index, to):
    """Move a knot with the mouse to some pixels off its new place, and some below the line: it snaps."""
    mouse, (x, y) = screen.page.mouse, screen.place((float(to), 0), START.view, START.line_view)
    mouse.move(*centre(screen, index))
    mouse.down()
    mouse.move(x + 4, y + 30, steps=5)
    mouse.up()


def knots_said(screen):
    handles = [one for one in screen.picture()["handles"] if one["data-handle"].startswith("knots")]
    return [handle["aria-valuetext"] for handle in handles]


def test_it_starts_as_the_board_was(screen):
    assert screen.shows(board())
    assert knots_said(screen) == [str(knot) for knot in KNOTS]
    assert screen.handle(3, of="knots").get_attribute("aria-label") == "knot t₃"


def test_a_knot_dragged_onto_its_neighbour_makes_a_double_knot(screen):
    drag_knot(screen, 3, 2)
    assert screen.shows(board(knots=(0, 0, 0, 2, 2, 3, 4, 4, 4)))
    drag_knot(screen, 4, F(5, 2))  # and one of both goes on alone
    assert screen.shows(board(knots=(0, 0, 0, 2, F(5, 2), 3, 4, 4, 4)))


def test_a_knot_may_pass_another_in_one_drag(screen):
    drag_knot(screen, 3, F(9, 4))
    assert screen.shows(board(knots=(0, 0, 0, 2, F(9, 4), 3, 4, 4, 4)))


def test_a_knot_stays_in_the_line_and_no_stack_grows_over_degree_plus_one(screen):
    drag_knot(screen, 5, 9)  # where there are three fours already
    assert knots_said(screen).count("4") == 3
    assert F(knots_said(screen)[5]) < 4  # as far as it could go
    drag_knot(screen, 8, 9)
    assert knots_said(screen)[-1] == "4"


def test_a_click_inserts_the_knot_once_more_and_keeps_the_curve(screen):
    points, knots = POINTS, KNOTS
    for _ in range(2):
        screen.page.mouse.click(*centre(screen, 4))
        points, knots = bspline.insert(points, knots, 2)
        assert screen.shows(board(points, tuple(knots)))
    assert screen.points()[4] == "(4, 5/2)"  # three times 2: a double point of the curve
    screen.page.mouse.click(*centre(screen, 4))  # a fourth time is against the rules
    assert screen.shows(board(points, tuple(knots)))
    screen.button("Undo").click()
    screen.button("Undo").click()
    assert screen.shows(board())


def test_a_drag_that_the_rules_refuse_is_no_click(screen):
    mouse, (x, y) = screen.page.mouse, centre(screen, 0)
    mouse.move(x, y)
    mouse.down()
    mouse.move(x - 60, y, steps=4)
    mouse.up()
    assert screen.shows(board())


def test_the_button_inserts_a_knot_at_t(screen):
    screen.button("Insert knot at t").click()
    points, knots = bspline.insert(POINTS, KNOTS, F(3, 2))
    assert screen.shows(board(points, tuple(knots)))
    screen.slider().press("Home")  # there are three zeros
    assert screen.button("Insert knot at t").is_disabled()


@pytest.mark.parametrize("key", ["+", "Enter"])
def test_the_keyboard_alone_does_all_of_it(screen, key):
    screen.handle(3, of="knots").focus()
    screen.page.keyboard.press("ArrowRight")
    screen.page.keyboard.press("Shift+ArrowRight")  # five steps of 1/4, past the knot 2
    assert screen.shows(board(knots=(0, 0, 0, 2, F(5, 2), 3, 4, 4, 4)))
    assert screen.page.evaluate("document.activeElement.dataset.handle") == "knots4"
    screen.page.keyboard.press("ArrowLeft")
    screen.page.keyboard.press(key)
    points, knots = bspline.insert(POINTS, (0, 0, 0, 2, F(9, 4), 3, 4, 4, 4), F(9, 4))
    assert screen.shows(board(points, tuple(knots)))


def test_t_stays_in_a_domain_that_shrinks(screen):
    screen.slider().press("End")
    for _ in range(3):
        drag_knot(screen, 8, F(7, 2))
    assert screen.shows(board(knots=(0, 0, 0, 1, 2, 3, F(7, 2), F(7, 2), F(7, 2)), t=F(7, 2)))


def test_t_goes_in_steps_of_the_knots_grid_and_plays_to_the_end(screen):
    screen.slider().press("Home")
    screen.slider().press("ArrowRight")
    assert screen.shows(board(t=F(1, 4)))
    screen.slider().press("End")
    assert screen.shows(board(t=F(4)))
    screen.button("play").click()  # from the start again
    screen.page.wait_for_function("document.querySelector('output').textContent !== '4'")
    screen.button("pause").click()
    t = F(screen.root.locator("output").first.text_content())
    assert 0 <= t < 4 and (4 * t).denominator == 1
    assert screen.shows(board(t=t))


def test_a_control_point_moves_its_spans_only_and_none_is_removed(screen):
    screen.drag(1, (1, 4), START.view)
    assert screen.shows(board((POINTS[0], (1, 4), *POINTS[2:])))
    screen.handle(1).press("Delete")
    assert len(screen.points()) == len(POINTS)
    assert screen.button("Remove point").count() == screen.button("Elevate").count() == 0


def test_a_layer_that_is_switched_on_is_painted_in_its_place(screen):
    screen.layer("basis functions").check()
    screen.layer("what the span of t depends on, and its hull").check()
    assert screen.draws(board(show=(*SHOW, "functions", "span")))
