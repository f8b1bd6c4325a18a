"""The identity of a file: for a notebook what its cells say, for anything else its bytes."""

import copy
import hashlib
import json

import nbformat
import pytest

from bezteach.setup.manifest import MANIFEST, identity, manifest_text, read_manifest
from bezteach.setup.progress import Problem

LESSON = {
    "cells": [
        {
            "cell_type": "markdown",
            "id": "one",
            "metadata": {"tags": ["a", "b"]},
            "source": ["# x\n", "y"],
            "attachments": {"p.svg": {"image/svg+xml": ["<svg>\n", "</svg>"]}},
        },
        {
            "cell_type": "code",
            "id": "two",
            "metadata": {},
            "source": ["1\n", "2"],
            "execution_count": 1,
            "outputs": [
                {"output_type": "stream", "name": "stdout", "text": ["a\n", "b\n"]},
                {"output_type": "error", "ename": "E", "evalue": "e", "traceback": ["a", "b"]},
                {
                    "output_type": "execute_result",
                    "execution_count": 1,
                    "metadata": {},
                    "data": {"text/plain": ["ü\n", "v"], "image/png": "cA==", "application/json": ["x", "y"]},
                },
            ],
        },
    ],
    "metadata": {"kernelspec": {"name": "python3", "display_name": "Python 3"}},
    "nbformat": 4,
    "nbformat_minor": 5,
}


@pytest.fixture
def same(tmp_path):
    """A function that tells whether a notebook, as text or as JSON, has the identity of LESSON."""

    def tell(content, name="a.ipynb"):
        found = []
        for text in (json.dumps(LESSON, indent=1), content if isinstance(content, str) else json.dumps(content)):
            (tmp_path / name).write_text(text, encoding="utf-8")
            found.append(identity(tmp_path / name))
        return found[0] == found[1]

    return tell


def changed(place, value):
    """LESSON with one thing in it other."""
    result = copy.deepcopy(LESSON)
    inner = result
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    return result


OUTPUTS = ("cells", 1, "outputs")


@pytest.mark.parametrize(
    "content",
    [
        json.dumps(LESSON, indent=4, ensure_ascii=False, sort_keys=True),
        changed(["metadata"], {"language_info": {"name": "python"}}),
        changed(["nbformat_minor"], 6),
        changed(["cells", 0, "source"], "# x\ny"),
        changed(["cells", 0, "source"], ["# x\ny"]),
        changed(["cells", 0, "attachments", "p.svg", "image/svg+xml"], "<svg>\n</svg>"),
        changed([*OUTPUTS, 0, "text"], "a\nb\n"),
        changed([*OUTPUTS, 2, "data", "text/plain"], "ü\nv"),
        changed([*OUTPUTS, 2, "data", "image/png"], ["cA=="]),
    ],
)
def test_notebook_is_its_cells_however_they_are_written(same, content):
    assert same(content)


@pytest.mark.parametrize(
    "content",
    [
        changed(["cells"], LESSON["cells"][::-1]),
        changed(["cells"], LESSON["cells"][:1]),
        changed(["cells"], LESSON["cells"] * 2),
        changed(["cells", 0, "source"], "# x\ny "),
        changed(["cells", 0, "cell_type"], "raw"),
        changed(["cells", 0, "id"], "three"),
        changed(["cells", 0, "metadata"], {"tags": ["ab"]}),
        changed(["cells", 0, "attachments"], {}),
        changed(["cells", 1, "execution_count"], 2),
        changed(["cells", 1, "outputs"], []),
        changed([*OUTPUTS, 0, "text"], "a\n"),
        changed([*OUTPUTS, 1, "traceback"], ["ab"]),
        changed([*OUTPUTS, 2, "data", "text/plain"], "u"),
        changed([*OUTPUTS, 2, "data", "application/json"], "xy"),
    ],
)
def test_whatever_is_other_in_a_cell_is_another_notebook(same, content):
    assert not same(content)


def test_writing_by_jupyter_changes_no_identity(same):
    assert same(nbformat.writes(nbformat.from_dict(LESSON)))


def test_only_a_notebook_has_cells(same):
    assert not same(changed(["nbformat_minor"], 6), name="a.json")


DEEP = b'{"cells": ' + b"[" * 100_000 + b"]" * 100_000 + b"}"


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"<<<<<<< HEAD",
        b"\xff\xfe\x00",
        b"3",
        b"[]",
        b"{}",
        b'{"cells": 1}',
        b'{"cells": [1]}',
        b'{"cells": [{}]}',
        b'{"cells": [{"source": [1]}]}',
        b'{"cells": [{"source": "", "outputs": [1]}]}',
        b'{"cells": [{"source": "", "attachments": 1}]}',
        b'{"worksheets": [{"cells": []}]}',
        DEEP,
    ],
)
def test_what_is_no_notebook_is_its_bytes(tmp_path, content):
    path = tmp_path / "a.ipynb"
    path.write_bytes(content)
    assert identity(path) == hashlib.sha256(content).hexdigest()


def test_unreadable_file_is_a_problem(tmp_path):
    with pytest.raises(Problem, match="cannot read"):
        identity(tmp_path)


def test_manifest_is_read_as_it_was_written(tmp_path):
    files = {"a ü.ipynb": {"copied": "1", "told": "2"}}
    assert read_manifest(tmp_path) == {}
    (tmp_path / MANIFEST).write_text(manifest_text(files), encoding="utf-8")
    assert read_manifest(tmp_path) == files
