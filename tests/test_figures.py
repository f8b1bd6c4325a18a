"""The pictures hold what they are given, say it in words, and are the same bytes from run to run."""

import re
from fractions import Fraction as F
from urllib.parse import unquote

import numpy as np
import pytest
from matplotlib.text import Text

from bezteach import figures, palette
from bezteach.examples import EXAMPLES

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
ALL = {
    "basis": lambda: figures.basis(3),
    "stacked": lambda: figures.stacked(3),
    "areas": lambda: figures.areas(3),
    "graph": lambda: figures.graph([0, 0, F(1, 3), 1], "$t^2$"),
    "graphs": lambda: figures.graphs({"$B_{1,3}$": [0, 1, 0, 0], "$B_{1,3}'$": [3, 0, -3]}),
    "triangle": lambda: figures.triangle(CUBIC, F(1, 3)),
    "loci": lambda: figures.loci(CUBIC, F(1, 3)),
    "split": lambda: figures.split(CUBIC, F(1, 3)),
    "segment": lambda: figures.segment(ARCH, F(1, 4), F(3, 4)),
    "halving": lambda: figures.halving(CUBIC),
    "decay": lambda: figures.decay([1, 0.26, 0.0625], F(1, 4)),
}


def drawn(axes):
    """The vertices of every line of a panel."""
    return [np.column_stack(line.get_data()) for line in axes.get_lines()]


def holds(axes, points):
    return any(
        line.shape == np.shape(points) and np.allclose(line, np.array(points, dtype=float)) for line in drawn(axes)
    )


def test_split_draws_the_slide_s_halves():
    (axes,) = ALL["split"]().axes
    answer = EXAMPLES["deck/split"].answer
    assert holds(axes, answer["left"]) and holds(axes, answer["right"]) and holds(axes, CUBIC)


def test_triangle_grows_by_one_level_a_panel():
    figure = ALL["triangle"]()
    levels = EXAMPLES["deck/split"].answer["triangle"]
    for last, axes in enumerate(figure.axes):
        assert [holds(axes, level) for level in levels] == [k <= last for k in range(4)]
    assert [text.get_text() for text in figure.axes[2].texts] == ["(2/3, 13/9)", "(5/3, 19/9)"]


def test_loci_are_curves_of_the_level_s_degree_through_its_points():
    levels = EXAMPLES["deck/split"].answer["triangle"]
    panels = ALL["loci"]().axes[:3]
    for k, axes in enumerate(panels, 1):
        polygon, *paths, points = drawn(axes)
        assert len(paths) == 4 - k and np.allclose(points, np.array(levels[k], dtype=float))
        for path, ends in zip(paths, zip(CUBIC, CUBIC[k:], strict=False), strict=True):
            assert np.allclose(path[[0, -1]], np.array(ends, dtype=float))
            assert np.abs(np.diff(path, k + 1, axis=0)).max() < 1e-12 < np.abs(np.diff(path, k, axis=0)).max()


def test_segment_draws_the_part():
    (axes,) = ALL["segment"]().axes
    assert holds(axes, EXAMPLES["deck/segment"].answer["part"])


def test_halving_draws_twice_as_many_polygons_a_panel():
    assert [sum(len(line) == 4 for line in drawn(axes)) for axes in ALL["halving"]().axes] == [1, 2, 4, 8]


def test_basis_draws_each_function_with_its_name_at_its_peak():
    (axes,) = ALL["basis"]().axes
    graphs = [line for line in drawn(axes) if len(line) > 1]
    middle = [graph[len(graph) // 2] for graph in graphs]
    assert np.allclose(middle, [(0.5, value / 8) for value in (1, 3, 3, 1)])
    assert holds(axes, [(1 / 3, 4 / 9)]) and holds(axes, [(2 / 3, 4 / 9)])
    assert [text.get_text() for text in axes.texts] == [f"$B_{{{i},3}}$" for i in range(4)]
    assert (
        len({(line.get_color(), str(line.get_linestyle())) for line in axes.get_lines() if len(line.get_xdata()) > 1})
        == 4
    )


def test_stacked_functions_fill_the_height_1():
    (axes,) = ALL["stacked"]().axes
    tops = [layer.get_paths()[0].get_extents() for layer in axes.collections]
    assert [round(box.y1, 9) for box in tops] == [1, 1, 1, 1]
    assert round(tops[0].y0, 9) == 0 and [text.get_text() for text in axes.texts][3] == "$B_{3,3}$"


def test_graphs_are_those_of_the_coefficients():
    (axes,) = ALL["graphs"]().axes
    function, slope = (line for line in drawn(axes) if len(line) > 2)
    assert np.allclose(slope[[0, -1]], [(0, 3), (1, -3)])
    assert np.allclose(function[len(function) // 2], (0.5, 3 / 8))


def test_areas_are_filled_under_each_function():
    panels = ALL["areas"]().axes
    assert [axes.get_title() for axes in panels] == [f"$B_{{{i},3}}$: area 1/4" for i in range(4)]
    outline = panels[1].collections[0].get_paths()[0].vertices
    x, y = outline[:-1].T
    assert abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) / 2 == pytest.approx(1 / 4, abs=1e-3)


def test_graph_stands_beside_the_polygon_of_its_coefficients():
    (axes,) = ALL["graph"]().axes
    assert holds(axes, [(0, 0), (1 / 3, 0), (2 / 3, 1 / 3), (1, 1)])
    square = next(line for line in drawn(axes) if len(line) > 4)
    assert np.allclose(square[:, 1], square[:, 0] ** 2)


def test_decay_draws_the_values_beside_the_guide():
    (axes,) = ALL["decay"]().axes
    assert holds(axes, [(0, 1), (1, 0.26), (2, 0.0625)])
    assert holds(axes, [(0, 1), (1, 0.25), (2, 0.0625)])


def test_bases_draws_each_degree_in_a_panel_of_its_own():
    figure = figures.bases((0, 1, 3))
    assert [len(axes.get_lines()) for axes in figure.axes] == [1, 2, 4]
    middle = [line.get_ydata()[32] for line in figure.axes[2].get_lines()]
    assert np.allclose(middle, [1 / 8, 3 / 8, 3 / 8, 1 / 8])
    assert figure.get_label().endswith("degree 0, 1 function; degree 1, 2 functions; degree 3, 4 functions.")


@pytest.mark.parametrize("name", ALL)
def test_every_picture_says_in_words_what_it_shows(name):
    assert len(ALL[name]().get_label()) > 40


def test_words_hold_the_exact_numbers():
    assert "(2/3, 13/9)" in ALL["split"]().get_label()
    assert "from t = 1/4 to t = 3/4" in ALL["segment"]().get_label()


@pytest.mark.parametrize("name", ALL)
def test_nothing_lies_outside_its_panel(name):
    figure = ALL[name]()
    figure.draw_without_rendering()
    frame = figure.bbox.padded(1)
    for axes in figure.axes:
        for text in filter(Text.get_text, [*axes.texts, axes.title]):
            box = text.get_window_extent()
            assert frame.contains(box.x0, box.y0) and frame.contains(box.x1, box.y1), text.get_text()


@pytest.mark.parametrize("name", ["triangle", "split", "segment"])
def test_names_do_not_overlap(name):
    figure = ALL[name]()
    figure.draw_without_rendering()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in [*axes.texts, axes.title]]
        assert not any(one.overlaps(other) for k, one in enumerate(boxes) for other in boxes[:k])


def shown(monkeypatch, figure):
    caught = []
    monkeypatch.setattr("IPython.display.display", lambda bundle, **options: caught.append((bundle, options)))
    figures.show(figure)
    return caught[0]


def test_shown_as_png_and_svg_with_alternative_text(monkeypatch):
    bundle, options = shown(monkeypatch, ALL["stacked"]())
    words = "The 4 Bernstein functions of degree 3 stacked: at every t they fill exactly the height 1."
    assert bundle["text/plain"] == words
    assert options == {"raw": True, "metadata": {"image/png": {"alt": words}}}
    assert bundle["image/png"].startswith(b"\x89PNG")
    tag, drawn = re.fullmatch(r'(<img alt="[^"]*") src="data:image/svg\+xml,([^"]*)">', bundle["text/html"]).groups()
    assert tag == f'<img alt="{words}"' and "</svg>" in unquote(drawn)


def test_the_same_bytes_from_run_to_run(monkeypatch):
    assert shown(monkeypatch, ALL["split"]()) == shown(monkeypatch, ALL["split"]())


@pytest.mark.parametrize("colours", [(palette.INK, palette.QUIET), (palette.FIRST, palette.QUIET)])
def test_what_lies_together_differs_in_greyscale(colours):
    one, other = (
        sum(w * int(c[i : i + 2], 16) for w, i in zip((0.299, 0.587, 0.114), (1, 3, 5), strict=True)) for c in colours
    )
    assert abs(one - other) > 40


def test_error_growth_draws_what_was_measured_and_says_the_last():
    found = {"power basis, Horner": (0.0, 1e-9, 2e3), "de Casteljau": (1e-16, 2e-16, 3e-16)}
    figure = figures.error_growth([1, 2, 3], found)
    (axes,) = figure.axes
    horner, casteljau = (line for line in axes.get_lines() if len(line.get_ydata()) == 3)
    assert list(horner.get_ydata())[1:] == [1e-9, 2e3] and horner.get_ydata()[0] > 0
    assert list(casteljau.get_ydata()) == [1e-16, 2e-16, 3e-16]
    assert len({line.get_linestyle() for line in (horner, casteljau)}) == 2
    assert len({line.get_marker() for line in (horner, casteljau)}) == 2
    assert "Horner 10^4" in figure.get_label() and "de Casteljau 10^-15" in figure.get_label()


def test_lower_curves_meet_the_level_before_the_last():
    figure = figures.lower_curves(CUBIC, F(1, 3))
    (axes,) = figure.axes
    *_, before, last = EXAMPLES["deck/split"].answer["triangle"]
    drawn = [np.column_stack(line.get_data()) for line in axes.get_lines()]
    for level in (before, last):
        assert any(line.shape == np.shape(level) and np.allclose(line, np.array(level, dtype=float)) for line in drawn)
    first, second = (line for line in drawn if len(line) > 4 and np.abs(np.diff(line, 3, axis=0)).max() < 1e-12)
    assert np.allclose([first[0], first[-1], second[0], second[-1]], [CUBIC[i] for i in (0, 2, 1, 3)])
    assert "(2/3, 13/9)" in figure.get_label() and "(1, 5/3)" in figure.get_label()
