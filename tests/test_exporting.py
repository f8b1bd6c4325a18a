"""``bezteach export``: a page that is whole or not there, and one line for everything that goes wrong."""

import errno
import os
from fractions import Fraction

import pytest

from bezteach import cli, exporting
from bezteach.examples import EXAMPLES
from bezteach.widgets import Board
from bezteach.widgets.board.export import page

CUBIC = [(0, 0), (1, 3), (2, 1), (3, 3)]


@pytest.fixture
def export(tmp_path, monkeypatch, capsys):
    """The command in a folder of its own: arguments to exit code, what it says, and what goes wrong."""
    monkeypatch.chdir(tmp_path)

    def run(*line):
        code = cli.main(["export", *line])
        said = capsys.readouterr()
        return code, said.out, said.err

    return run


def fails(result, *words):
    """The command ended with 1, said nothing, and wrote one line of complaint with these words."""
    code, out, err = result
    assert (code, out) == (1, "") and err.startswith("bezteach: ") and err.count("\n") == 1, result
    for word in words:
        assert word in err
    return True


def test_the_page_is_that_of_the_slide_s_cubic(export, tmp_path):
    code, out, err = export("board.html")
    assert (code, err) == (0, "")
    board = Board(CUBIC, t=Fraction(1, 3), show=("polygon", "curve", "levels"))
    assert (tmp_path / "board.html").read_text(encoding="utf-8") == page(board, "A cubic split at t = 1/3")


def test_it_says_where_it_wrote_and_how_much(export, tmp_path):
    _, out, _ = export("board.html")
    place = tmp_path / "board.html"
    kilobytes = round(place.stat().st_size / 1000)
    assert out.startswith(f"bezteach: wrote {place} ({kilobytes} KB)") and out.count("\n") == 1
    assert kilobytes < 100
    assert os.listdir(tmp_path) == ["board.html"]


def test_the_page_fetches_nothing(export, tmp_path):
    export("board.html")
    content = (tmp_path / "board.html").read_text(encoding="utf-8").replace("http://www.w3.org/2000/svg", "")
    for way_out in ("http:", "https:", "//cdn", "src=", "<link", "@import", "url(", "fetch(", "import("):
        assert way_out not in content


@pytest.mark.parametrize("name", exporting.usable())
def test_every_example_with_points_in_the_plane_has_a_page(name, export, tmp_path):
    assert export("board.html", "--example", name)[0] == 0
    board = exporting.board_of(name)
    assert page(board, exporting.title_of(name)) == (tmp_path / "board.html").read_text(encoding="utf-8")
    assert set(board.points) <= set((EXAMPLES[name].given | EXAMPLES[name].answer)["points"])


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("deck/splitt", "'deck/splitt' is no example"),
        ("", "'' is no example"),
        ("deck/recursion", "'deck/recursion' has no control points in the plane"),
        ("deck/quartic", "'deck/quartic' has no control points in the plane"),  # one has a free height
    ],
)
def test_what_is_no_such_example_names_those_that_are(name, wrong, export, tmp_path):
    assert fails(export("board.html", "--example", name), wrong, *exporting.usable())
    assert os.listdir(tmp_path) == []


def test_a_file_that_is_there_is_overwritten_by_force_only(export, tmp_path):
    (tmp_path / "board.html").write_text("mine")
    assert fails(export("board.html"), "board.html is there already", "--force")
    assert (tmp_path / "board.html").read_text() == "mine"
    assert export("board.html", "--force")[0] == 0
    assert (tmp_path / "board.html").read_text().startswith("<!DOCTYPE html>")


def test_a_broken_link_is_something_that_is_there(export, tmp_path):
    (tmp_path / "board.html").symlink_to(tmp_path / "nowhere")
    assert fails(export("board.html"), "is there already")


@pytest.mark.parametrize(
    ("file", "wrong"),
    [
        ("folder.html", "folder.html is a folder"),
        ("no/board.html", "there is no folder"),
        ("file/board.html", "there is no folder"),
        ("deck/split", "'split' is no name for a page: let it end in .html"),
        (".", "no name for a page"),
    ],
)
def test_a_place_that_cannot_be(file, wrong, export, tmp_path):
    (tmp_path / "folder.html").mkdir()
    (tmp_path / "file").touch()
    assert fails(export(file, "--force"), wrong)
    assert sorted(os.listdir(tmp_path)) == ["file", "folder.html"]


@pytest.mark.parametrize("error", [errno.EACCES, errno.EROFS, errno.ENOSPC])
def test_where_writing_fails_everything_stays_as_it_was(error, export, tmp_path, monkeypatch):
    (tmp_path / "board.html").write_text("mine")

    def fail(*paths):
        raise OSError(error, os.strerror(error))

    monkeypatch.setattr(os, "replace", fail)
    assert fails(export("board.html", "--force"), "cannot write", os.strerror(error))
    assert os.listdir(tmp_path) == ["board.html"] and (tmp_path / "board.html").read_text() == "mine"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ([], "the following arguments are required: FILE.html"),
        ([""], "the name is empty"),
        (["a.html", "b.html"], "unrecognized arguments: b.html"),
    ],
)
def test_it_takes_one_name_of_a_file(line, words, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(["export", *line])
    assert words in capsys.readouterr().err
