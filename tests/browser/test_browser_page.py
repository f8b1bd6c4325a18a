"""The exported page, opened from a file with the network off: all of it can be moved, every number is right."""

from fractions import Fraction as F

import pytest
from browser_screen import Screen

from bezteach import cli, numeric
from bezteach.widgets import Board

CUBIC = ((0, 0), (1, 3), (2, 1), (3, 3))
VIEW = Board(CUBIC).view
STEP, BIG = F(1, 4), F(5, 4)  # of the arrow keys


def after(points=CUBIC, t=F(1, 3), show=("polygon", "curve", "levels"), level=None):
    """The board in Python with these settings; without any, as the page is at its start."""
    return Board(points, t, show, level=level, view=VIEW)


def moved(index, to):
    """The control points with one of them elsewhere."""
    return [to if i == index else point for i, point in enumerate(CUBIC)]


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    file = tmp_path_factory.mktemp("exported") / "board.html"
    assert cli.main(["export", str(file)]) == 0
    return file.as_uri()


@pytest.fixture(scope="module")
def opened(window):
    with window("file:", offline=True) as one:
        yield one


@pytest.fixture
def screen(opened, address):
    """The page as it is when it is opened; no test may leave an error or a request behind."""
    opened.page.set_viewport_size({"width": 1200, "height": 800})
    opened.page.goto(address)
    yield Screen(opened.page)
    assert opened.complaints() == []


def test_it_starts_as_the_board_was(screen):
    assert screen.shows(after())
    assert screen.page.title() == "A cubic split at t = 1/3"


def test_the_mouse_drags_a_point_to_the_grid(screen):
    screen.drag(1, (F(3, 2), F(5, 2)), VIEW)
    assert screen.shows(after(moved(1, (F(3, 2), F(5, 2)))))


def test_a_point_stays_in_the_picture(screen):
    screen.drag(2, (9, -9), VIEW)
    assert screen.shows(after(moved(2, (F(13, 4), F(-1, 4)))))
    screen.handle(2).press("ArrowRight")
    screen.handle(2).press("Shift+ArrowDown")
    assert screen.shows(after(moved(2, (F(13, 4), F(-1, 4)))))


def press_tab_until(screen, selector):
    """Press Tab until what is marked is this; 20 times at most."""
    for _ in range(20):
        screen.page.keyboard.press("Tab")
        if screen.page.evaluate("selector => document.activeElement.matches(selector)", selector):
            return
    raise AssertionError(f"Tab does not reach {selector}")


@pytest.mark.parametrize(
    ("key", "to"),
    [
        ("ArrowLeft", (2 - STEP, 1)),
        ("ArrowRight", (2 + STEP, 1)),
        ("ArrowUp", (2, 1 + STEP)),
        ("ArrowDown", (2, 1 - STEP)),
        ("Shift+ArrowLeft", (2 - BIG, 1)),
        ("Shift+ArrowUp", (2, 1 + BIG)),
    ],
)
def test_an_arrow_key_moves_the_point_that_tab_has_marked(screen, key, to):
    press_tab_until(screen, "[data-handle=points2]")
    screen.page.keyboard.press(key)
    assert screen.shows(after(moved(2, to)))


def test_keys_do_not_scroll_the_page(screen):
    screen.page.set_viewport_size({"width": 700, "height": 300})
    screen.handle(1).focus()
    before = screen.page.evaluate("scrollY")
    screen.page.keyboard.press("ArrowDown")
    screen.page.keyboard.press("ArrowDown")
    assert screen.points()[1] == "(1, 5/2)"
    assert screen.page.evaluate("scrollY") == before


@pytest.mark.parametrize("beside", [(0, 0), (12, 14)])  # pixels
def test_a_finger_drags_a_point_also_from_beside_it_and_the_page_stays(window, address, beside):
    with window("file:", offline=True, has_touch=True, viewport={"width": 400, "height": 500}) as phone:
        phone.page.goto(address)
        screen = Screen(phone.page)
        screen.handle(2).scroll_into_view_if_needed()
        scrolled = phone.page.evaluate("scrollY")
        places = [screen.place(place, VIEW) for place in ((2, 1), (2, 2), (2, F(5, 2)))]
        touch(phone.page, [(x + beside[0], y + beside[1]) for x, y in places])
        assert screen.shows(after(moved(2, (2, F(5, 2)))))
        assert phone.page.evaluate("scrollY") == scrolled


def touch(page, way):
    """A finger goes down, along, and up again."""
    session = page.context.new_cdp_session(page)
    for kind, at in zip(["touchStart", *["touchMove"] * (len(way) - 1)], way, strict=True):
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [dict(zip("xy", at, strict=True))]})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


@pytest.mark.parametrize(
    ("key", "t"), [("ArrowRight", F(3, 8)), ("ArrowLeft", F(7, 24)), ("Home", F(0)), ("End", F(1))]
)
def test_keys_move_t(screen, key, t):
    press_tab_until(screen, "input[type=range]")
    screen.page.keyboard.press(key)
    assert screen.slider().get_attribute("aria-valuetext") == str(t)
    assert screen.shows(after(t=t))


def test_undo_takes_back_one_change_after_the_other(screen):
    assert screen.button("Undo").is_disabled()
    screen.drag(1, (F(3, 2), F(5, 2)), VIEW)  # however many moves of the mouse it took
    screen.handle(0).press("ArrowUp")
    screen.button("Undo").click()
    assert screen.shows(after(moved(1, (F(3, 2), F(5, 2)))))
    screen.handle(0).press("Control+z")
    assert screen.shows(after())
    assert screen.button("Undo").is_disabled()


def test_reset_goes_back_to_the_start(screen):
    screen.drag(1, (F(3, 2), F(5, 2)), VIEW)
    screen.button("Elevate").click()
    screen.slider().press("End")
    screen.button("Reset").click()
    assert screen.shows(after())


def test_a_point_is_added_in_the_middle_behind_the_marked_one(screen):
    screen.handle(1).focus()
    screen.button("Add point").click()
    assert screen.shows(after((*CUBIC[:2], (F(3, 2), 2), *CUBIC[2:])))
    assert screen.handle(2).evaluate("handle => handle === document.activeElement")


@pytest.mark.parametrize(
    ("last", "added"),
    [
        ((2, F(3, 2)), (2, F(7, 4))),
        ((3, 3), (F(13, 4), F(13, 4))),  # not (7/2, 4), which is outside the picture
    ],
)
def test_behind_the_last_one_a_point_is_added_half_an_edge_further_inside_the_picture(screen, last, added):
    screen.drag(3, last, VIEW)
    screen.button("Add point").click()
    assert screen.shows(after([*moved(3, last), added]))


def test_without_a_marked_point_one_is_added_behind_the_last(screen):
    screen.button("Add point").click()
    assert len(screen.points()) == 5 and screen.points()[:4] == [f"({x}, {y})" for x, y in CUBIC]


@pytest.mark.parametrize("how", ["button", "Delete", "Backspace"])
def test_the_marked_point_is_removed(screen, how):
    screen.handle(1).focus()
    if how == "button":
        screen.button("Remove point").click()
    else:
        screen.page.keyboard.press(how)
    assert screen.shows(after((CUBIC[0], *CUBIC[2:])))


def test_two_points_are_the_fewest_and_twenty_the_most(screen):
    for _ in range(2):
        screen.button("Remove point").click()
    assert screen.button("Remove point").is_disabled()
    screen.handle(0).press("Delete")
    assert screen.shows(after(CUBIC[:2]))
    while screen.button("Elevate").is_enabled():
        screen.button("Elevate").click()
    assert len(screen.points()) == 20 and screen.button("Add point").is_disabled()


def test_elevating_keeps_the_curve_and_gives_exact_points(screen):
    for r in (1, 2, 3):
        screen.button("Elevate").click()
        exact = numeric.elevate([[F(x), F(y)] for x, y in CUBIC], r)
        assert screen.points() == [f"({x}, {y})" for x, y in exact]
        assert screen.shows(after(exact))


def test_t_plays_until_it_is_stopped_and_rests_on_the_slider_s_grid(screen):
    screen.slider().press("Home")
    screen.button("play").click()
    screen.page.wait_for_function(
        "(([p, q = 1]) => p / q > 1 / 24)(document.querySelector('output').textContent.split('/'))"
    )
    screen.button("pause").click()
    t = F(screen.root.locator("output").first.text_content())
    assert 0 < t < 1 and (24 * t).denominator == 1
    assert screen.shows(after(t=t))


def test_levels_appear_one_by_one(screen):
    screen.button("−").click()
    assert screen.shows(after(level=2))
    screen.button("−").click()
    screen.button("−").click()
    assert screen.shows(after(level=0))
    assert screen.button("−").is_disabled()
    screen.button("+").click()
    assert screen.shows(after(level=1))


def test_layers_are_switched(screen):
    screen.layer("convex hull and its box").check()
    screen.layer("control polygon").uncheck()
    assert screen.draws(after(show=("hull", "curve", "levels")))


def test_a_handle_says_what_it_is_and_where_exactly(screen):
    handles = [screen.handle(i) for i in range(4)]
    assert [one.get_attribute("role") for one in handles] == ["slider"] * 4
    assert [one.get_attribute("aria-label") for one in handles] == [f"control point b{i}" for i in "₀₁₂₃"]
    screen.button("Elevate").click()
    assert screen.handle(1).get_attribute("aria-valuetext") == "(3/4, 9/4)"
    assert float(screen.handle(1).get_attribute("aria-valuenow")) == 9 / 4


@pytest.mark.parametrize(
    ("selector", "part", "mark"),
    [
        ("[data-handle=points0]", ".bt-ring", "stroke"),
        ("input[type=range]", "*", "outline-style"),
        ("button", "*", "outline-style"),
        ("summary", "*", "outline-style"),
    ],
)
def test_what_the_keyboard_marks_is_seen(screen, selector, part, mark):
    style = """(one, [part, mark]) =>
        getComputedStyle(part === "*" ? one : one.querySelector(part)).getPropertyValue(mark)"""
    press_tab_until(screen, selector)
    marked = screen.page.evaluate_handle("document.activeElement")
    assert marked.evaluate(style, [part, mark]) != "none"
    marked.evaluate("one => one.blur()")
    assert marked.evaluate(style, [part, mark]) == "none"
