"""The README's picture is the one the code draws; its Python runs as a doctest."""

import re
from pathlib import Path

import pytest

from bezteach.examples import EXAMPLES
from bezteach.ledger.summary import written_into
from bezteach.widgets import explore_split
from bezteach.widgets.board.svg import picture

ROOT = Path(__file__).parents[1]


def test_the_picture_is_what_the_explorer_shows():
    board = explore_split(EXAMPLES["deck/split"].given["points"])
    (alt,) = re.findall(r"!\[(.*)\]\(\.github/split\.svg\)", (ROOT / "README.md").read_text(encoding="utf-8"))
    drawn = picture(board.marks, board.view, alt)
    assert (ROOT / ".github" / "split.svg").read_text(encoding="utf-8") == drawn + "\n"


def test_every_folder_and_file_it_names_is_there():
    for line in (ROOT / "README.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("| `"):
            names = [name for name in line.split("|")[1].split("`") if name.strip(" ,")]
            places = [ROOT / name if "/" in name else ROOT / "bezteach" / name for name in names]
            assert all(place.exists() for place in places), line


def test_a_readme_without_the_marks_is_refused():
    with pytest.raises(ValueError, match="lost the marks"):
        written_into("# bezteach", "240 claims")
