"""What is written is whole or not there."""

import os

import pytest

from bezteach.setup.writing import removed_if_empty, write


def test_failing_write_leaves_the_file_as_it_was_and_no_draft(tmp_path, monkeypatch):
    write(tmp_path / "a", b"before")

    def replace(source, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(OSError, match="No space"):
        write(tmp_path / "a", b"after")
    assert [(path.name, path.read_bytes()) for path in tmp_path.iterdir()] == [("a", b"before")]


@pytest.mark.parametrize("made", [["new"], ["new/deeper"], []])
def test_folders_that_a_failing_block_made_are_gone(tmp_path, made):
    with pytest.raises(KeyboardInterrupt), removed_if_empty(tmp_path / "new" / "deeper"):
        for name in made:
            (tmp_path / name).mkdir(parents=True)
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []


def test_folders_with_something_in_them_and_those_of_a_good_block_stay(tmp_path):
    with pytest.raises(ValueError, match="x"), removed_if_empty(tmp_path / "new" / "deeper"):
        (tmp_path / "new" / "deeper").mkdir(parents=True)
        (tmp_path / "new" / "mine").touch()
        raise ValueError("x")
    assert [path.name for path in (tmp_path / "new").iterdir()] == ["mine"]
    with removed_if_empty(tmp_path / "other"):
        (tmp_path / "other").mkdir()
    assert (tmp_path / "other").is_dir()
