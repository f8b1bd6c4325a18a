"""A lesson exported as HTML, for a course page or a printout: its pictures are there without Python and network."""

import os
import re
import subprocess
import sys

import pytest

from bezteach.lessons import ROOT, parsed

LESSON = ROOT / "lessons" / "08-splitting.ipynb"
LIBRARIES = re.compile("require|mathjax", re.IGNORECASE)  # nbconvert's page wants them from other servers
PICTURES = """() => [...document.querySelectorAll(".jp-OutputArea :is(img, svg)")].map(picture => {
  const { width, height } = picture.getBoundingClientRect();
  return { words: picture.alt, width, height, whole: picture.complete && picture.naturalWidth > 0 };
})"""


@pytest.fixture(scope="module")
def page(window, tmp_path_factory):
    folder = tmp_path_factory.mktemp("handout")
    command = [sys.executable, "-m", "nbconvert", "--to=html", f"--output-dir={folder}", str(LESSON)]
    subprocess.run(command, check=True, capture_output=True, env=os.environ | {"JUPYTER_CONFIG_DIR": str(folder)})
    with window("file:", offline=True, stubbed=LIBRARIES) as opened:
        opened.page.goto((folder / LESSON.with_suffix(".html").name).as_uri())
        yield opened.page


@pytest.fixture(scope="module")
def stored():
    """The words of the pictures that are stored in the lesson."""
    cells = parsed(LESSON.read_text(encoding="utf-8")).cells
    outputs = [output for cell in cells for output in cell.get("outputs", [])]
    return [output.data["text/plain"] for output in outputs if "<img" in output.get("data", {}).get("text/html", "")]


def test_every_stored_picture_is_seen(page, stored):
    pictures = page.evaluate(PICTURES)
    assert len(pictures) == len(stored) > 0
    for picture in pictures:
        assert picture["whole"] and picture["width"] > 200 and picture["height"] > 100


def test_every_picture_has_its_words(page, stored):
    assert [picture["words"] for picture in page.evaluate(PICTURES)] == stored
