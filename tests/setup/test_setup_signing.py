"""Signing the copied lessons: Jupyter trusts them, and a failure is a line and no more."""

import sqlite3

import nbformat
import pytest
from nbformat.sign import NotebookNotary

from bezteach.setup.signing import sign


@pytest.fixture
def jupyter_data(tmp_path, monkeypatch):
    for name in ("JUPYTER_DATA_DIR", "JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR"):
        monkeypatch.setenv(name, str(tmp_path / name))
    return tmp_path / "JUPYTER_DATA_DIR"


def test_signed_notebooks_are_trusted(tmp_path, jupyter_data):
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_markdown_cell("x")])
    paths = [tmp_path / "a.ipynb", tmp_path / "b.ipynb"]
    for path in paths:
        nbformat.write(notebook, path)
    assert sign(paths) == ""
    with NotebookNotary() as notary:
        assert notary.check_signature(nbformat.read(paths[0], as_version=4))


def test_signing_that_fails_says_why_and_raises_nothing(tmp_path, jupyter_data, monkeypatch, capfd):
    path = tmp_path / "a.ipynb"
    path.write_text("no notebook", encoding="utf-8")
    assert sign([path]) != ""
    nbformat.write(nbformat.v4.new_notebook(), path)

    def connect(name, **options):
        if name != ":memory:":
            raise sqlite3.OperationalError("disk I/O error")
        return real(name, **options)

    real = sqlite3.connect
    monkeypatch.setattr(sqlite3, "connect", connect)
    assert sign([path]) == "the database of signatures cannot be written"
    assert capfd.readouterr() == ("", "")


def test_nothing_to_sign():
    assert sign([]) == ""
