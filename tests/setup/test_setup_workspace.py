"""The user's folder of lessons: what the user changed is never written to, and everything else follows the project."""

import json
import os
import stat
import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bezteach.setup import workspace
from bezteach.setup.manifest import MANIFEST
from bezteach.setup.progress import Problem
from bezteach.setup.workspace import Step, copy_lessons


@pytest.fixture
def source(tmp_path):
    (tmp_path / "shipped").mkdir()
    write(tmp_path / "shipped", "a.ipynb", "a1")
    write(tmp_path / "shipped", "b.ipynb", "b1")
    return tmp_path / "shipped"


@pytest.fixture
def target(tmp_path):
    return tmp_path / "mine"


def write(folder, name, text):
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text, encoding="utf-8")


def files(folder):
    """Everything below the folder but the manifest, as {path: text}."""
    paths = (path for path in folder.rglob("*") if path.is_file() and path.name != MANIFEST)
    return {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def actions(steps):
    return {step.path: step.action for step in steps}


# --- the rules


def test_first_time_every_lesson_is_copied(source, target):
    assert copy_lessons(source, target) == [Step("a.ipynb", "copy", "a.ipynb"), Step("b.ipynb", "copy", "b.ipynb")]
    assert files(target) == files(source)


def test_second_time_nothing_is_written(source, target):
    copy_lessons(source, target)
    before = {path: path.stat().st_mtime_ns for path in target.iterdir()}
    assert actions(copy_lessons(source, target)) == {"a.ipynb": "same", "b.ipynb": "same"}
    assert {path: path.stat().st_mtime_ns for path in target.iterdir()} == before


def test_new_release_replaces_what_the_user_left_alone(source, target):
    copy_lessons(source, target)
    write(source, "a.ipynb", "a2")
    assert copy_lessons(source, target)[0] == Step("a.ipynb", "update", "a.ipynb")
    assert files(target) == {"a.ipynb": "a2", "b.ipynb": "b1"}


def test_changed_lesson_stays_and_is_not_spoken_of_beside_an_old_release(source, target):
    copy_lessons(source, target)
    write(target, "a.ipynb", "mine")
    assert actions(copy_lessons(source, target))["a.ipynb"] == "keep"
    assert files(target) == {"a.ipynb": "mine", "b.ipynb": "b1"}


def test_new_release_goes_beside_a_changed_lesson_once(source, target):
    copy_lessons(source, target)
    write(target, "a.ipynb", "mine")
    write(source, "a.ipynb", "a2")
    assert copy_lessons(source, target)[0] == Step("a.ipynb", "beside", "a (new).ipynb")
    assert files(target) == {"a.ipynb": "mine", "a (new).ipynb": "a2", "b.ipynb": "b1"}
    (target / "a (new).ipynb").unlink()
    assert actions(copy_lessons(source, target))["a.ipynb"] == "keep"
    assert files(target) == {"a.ipynb": "mine", "b.ipynb": "b1"}


def test_the_one_beside_follows_later_releases_unless_it_was_changed_too(source, target):
    copy_lessons(source, target)
    write(target, "a.ipynb", "mine")
    for text in ("a2", "a3"):
        write(source, "a.ipynb", text)
        assert copy_lessons(source, target)[0].place == "a (new).ipynb"
    write(target, "a (new).ipynb", "mine too")
    write(source, "a.ipynb", "a4")
    assert copy_lessons(source, target)[0].place == "a (new 2).ipynb"
    expected = {"a.ipynb": "mine", "a (new).ipynb": "mine too", "a (new 2).ipynb": "a4", "b.ipynb": "b1"}
    assert files(target) == expected


def notebook(*texts):
    """A notebook's text, with a code cell for each of these; what it printed is the same again."""
    outputs = [[{"output_type": "stream", "name": "stdout", "text": [text]}] for text in texts]
    cells = [
        {"cell_type": "code", "id": text, "metadata": {}, "source": [text], "execution_count": 1, "outputs": output}
        for text, output in zip(texts, outputs, strict=True)
    ]
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}, indent=1)


def looked_at(text):
    """A notebook's text as JupyterLab may save it when it was only opened; any other text as it is."""
    try:
        content = json.loads(text)
        for cell in content["cells"]:
            cell["source"] = "".join(cell["source"])
    except (ValueError, KeyError):
        return text
    content.update(metadata={"language_info": {"name": "python", "version": "3.14.0"}}, nbformat_minor=6)
    return json.dumps(content, indent=4)


def test_lesson_that_was_only_looked_at_follows_the_next_release(source, target):
    write(source, "a.ipynb", notebook("a1"))
    copy_lessons(source, target)
    saved = looked_at(notebook("a1"))
    write(target, "a.ipynb", saved)
    assert actions(copy_lessons(source, target))["a.ipynb"] == "same"
    assert files(target)["a.ipynb"] == saved != notebook("a1")
    write(source, "a.ipynb", notebook("a2"))
    assert actions(copy_lessons(source, target))["a.ipynb"] == "update"
    assert files(target)["a.ipynb"] == notebook("a2")


@pytest.mark.parametrize(
    "mine",
    [
        notebook("a1", "a2").replace('"text": [\n      "a1"', '"text": [\n      "other"'),
        notebook("a1", "edited"),
        notebook("a2", "a1"),
        notebook("a1", "a2", "added"),
        notebook("a1"),
    ],
    ids=["output", "source", "order", "added", "removed"],
)
def test_lesson_whose_cells_were_changed_is_kept(source, target, mine):
    write(source, "a.ipynb", notebook("a1", "a2"))
    copy_lessons(source, target)
    assert mine != notebook("a1", "a2")
    write(target, "a.ipynb", mine)
    assert actions(copy_lessons(source, target))["a.ipynb"] == "keep"
    write(source, "a.ipynb", notebook("a3"))
    assert copy_lessons(source, target)[0] == Step("a.ipynb", "beside", "a (new).ipynb")
    assert (files(target)["a.ipynb"], files(target)["a (new).ipynb"]) == (mine, notebook("a3"))


def test_deleted_lesson_comes_back(source, target):
    copy_lessons(source, target)
    (target / "a.ipynb").unlink()
    assert actions(copy_lessons(source, target)) == {"a.ipynb": "copy", "b.ipynb": "same"}


def test_lesson_changed_back_counts_as_unchanged(source, target):
    copy_lessons(source, target)
    write(target, "a.ipynb", "mine")
    write(source, "a.ipynb", "a2")
    copy_lessons(source, target)
    write(target, "a.ipynb", "a1")
    assert actions(copy_lessons(source, target))["a.ipynb"] == "update"


@pytest.mark.parametrize(
    "manifest", [None, "", "{", "[]", "{}", '{"files": 3}', '{"files": {"a.ipynb": 1}}', "\x00", "[" * 100_000]
)
def test_without_a_readable_manifest_all_that_differs_counts_as_the_users(source, target, manifest):
    write(target, "a.ipynb", "a1")
    write(target, "b.ipynb", "an older release, or mine: who knows")
    if manifest is not None:
        write(target, MANIFEST, manifest)
    assert copy_lessons(source, target) == [Step("a.ipynb", "same"), Step("b.ipynb", "beside", "b (new).ipynb")]
    assert json.loads((target / MANIFEST).read_text(encoding="utf-8"))["files"].keys() == files(target).keys()


def test_manifest_that_is_no_text_counts_as_missing(source, target):
    copy_lessons(source, target)
    (target / MANIFEST).write_bytes(b"\xff\xfe")
    assert actions(copy_lessons(source, target)) == {"a.ipynb": "same", "b.ipynb": "same"}


def test_subfolders_come_along_and_caches_and_hidden_files_do_not(source, target):
    write(source, "pictures/deep/p.svg", "p")
    for name in (".ipynb_checkpoints/a-checkpoint.ipynb", "__pycache__/x.pyc", ".gitkeep", "pictures/.hidden"):
        write(source, name, "no")
    copy_lessons(source, target)
    assert files(target) == {"a.ipynb": "a1", "b.ipynb": "b1", "pictures/deep/p.svg": "p"}


def test_new_file_beside_a_changed_one_in_a_subfolder_lies_in_that_subfolder(source, target):
    write(source, "data/x.json", "1")
    write(target, "data/x.json", "mine")
    assert copy_lessons(source, target)[2] == Step("data/x.json", "beside", "data/x (new).json")


def test_files_that_are_not_lessons_are_left_alone(source, target):
    write(target, "notes.txt", "mine")
    copy_lessons(source, target)
    assert files(target)["notes.txt"] == "mine"


def test_copies_are_writable_even_if_the_shipped_files_are_not(source, target):
    (source / "a.ipynb").chmod(0o444)
    copy_lessons(source, target)
    assert (target / "a.ipynb").stat().st_mode & stat.S_IWUSR


NAMES = ("a.ipynb", "b.ipynb", "d/c.ipynb")
PLACES = (*NAMES, "a (new).ipynb", "b (new).ipynb", "a (new 2).ipynb", MANIFEST)
EVENTS = st.one_of(
    st.tuples(st.just("release"), st.sampled_from(NAMES), st.sampled_from("1234")),
    st.tuples(st.just("edit"), st.sampled_from(PLACES), st.sampled_from(["mine", "1", "2", "{}"])),
    st.tuples(st.just("look"), st.sampled_from(PLACES), st.none()),
    st.tuples(st.just("delete"), st.sampled_from(PLACES), st.none()),
    st.tuples(st.just("run"), st.none(), st.none()),
)


def meaning(folder):
    """What the files say: of notebooks the cells."""

    def said(text):
        try:
            return [("".join(cell["source"]), cell["outputs"]) for cell in json.loads(text)["cells"]]
        except (ValueError, KeyError):
            return text

    return {name: said(text) for name, text in files(folder).items()}


@settings(deadline=None, max_examples=150)
@given(st.lists(EVENTS, max_size=25))
def test_whatever_happens_no_file_the_user_changed_is_overwritten(events):
    """Releases, looks, edits, deletions and runs in any order, the manifest itself among the victims."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder, "shipped"), Path(folder, "mine")
        target.mkdir()
        for name in NAMES:
            write(source, name, notebook("1"))
        users = {}
        for kind, name, text in [*events, ("run", None, None)]:
            if kind == "release":
                write(source, name, notebook(text))
            elif kind == "edit":
                write(target, name, text if text == "{}" else notebook(text))
                # What is equal to something shipped is no work of the user's.
                users.pop(name, None)
                if text == "mine":
                    users[name] = meaning(target).get(name)
            elif kind == "look":
                if (target / name).is_file():
                    write(target, name, looked_at((target / name).read_text(encoding="utf-8")))
            elif kind == "delete":
                (target / name).unlink(missing_ok=True)
                users.pop(name, None)
            else:
                users.pop(MANIFEST, None)
                steps = copy_lessons(source, target)
                now, shipped = meaning(target), meaning(source)
                assert {name: now[name] for name in users} == users
                assert {step.path for step in steps} == set(NAMES)
                for step in steps:
                    if step.action in ("copy", "update", "same"):
                        assert now[step.path] == shipped[step.path]
                    elif step.action == "beside":
                        assert now[step.place] == shipped[step.path] != now[step.path]
                # The same again has nothing to do.
                assert {step.action for step in copy_lessons(source, target)} <= {"same", "keep"}
                assert meaning(target) == now


# --- what goes wrong


def fails(source, target):
    """Copying fails with one line, and nothing in the target is other than before. Returns the line."""
    before = sorted(target.rglob("*")) if target.is_dir() else target.exists()
    with pytest.raises(Problem) as caught:
        copy_lessons(source, target)
    assert (sorted(target.rglob("*")) if target.is_dir() else target.exists()) == before
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_shipped_folder_missing_or_empty(tmp_path, target):
    assert "missing" in fails(tmp_path / "nothing", target)
    (tmp_path / "empty").mkdir()
    assert "no lessons" in fails(tmp_path / "empty", target)


def test_target_in_the_shipped_folder(source):
    assert "belongs to the project" in fails(source, source)
    assert "belongs to the project" in fails(source, source / "deeper")


def test_target_is_a_file_or_under_one(source, target):
    target.write_text("mine", encoding="utf-8")
    assert "not a folder" in fails(source, target)
    assert "not a folder" in fails(source, target / "deeper" / "still")


def test_target_is_a_link_to_nowhere(source, target):
    target.symlink_to(target.parent / "nowhere")
    assert "not a folder" in fails(source, target)


def test_lesson_name_taken_by_a_folder(source, target):
    (target / "b.ipynb").mkdir(parents=True)
    assert "b.ipynb is no file" in fails(source, target)


def test_folder_name_taken_by_a_file(source, target):
    write(source, "pictures/p.svg", "p")
    write(target, "pictures", "mine")
    assert "pictures is in the way" in fails(source, target)


def test_folder_that_leads_out_of_the_target(source, target, tmp_path):
    write(source, "pictures/p.svg", "p")
    (tmp_path / "elsewhere").mkdir()
    target.mkdir()
    (target / "pictures").symlink_to(tmp_path / "elsewhere")
    assert "pictures is in the way" in fails(source, target)
    assert files(tmp_path / "elsewhere") == {}


def test_lesson_that_is_a_link_belongs_to_the_user(source, target, tmp_path):
    write(tmp_path, "elsewhere.ipynb", "a1")
    target.mkdir()
    (target / "a.ipynb").symlink_to(tmp_path / "elsewhere.ipynb")
    (target / "b.ipynb").symlink_to(tmp_path / "nowhere")
    assert set(actions(copy_lessons(source, target)).values()) == {"beside"}
    assert (target / "a.ipynb").is_symlink() and (target / "b.ipynb").is_symlink()
    assert files(tmp_path)["elsewhere.ipynb"] == "a1"


def test_no_permission_to_write(source, target, monkeypatch):
    target.mkdir()
    monkeypatch.setattr(os, "access", lambda path, mode: path != target)  # root may write everywhere
    assert f"no permission to write in {target}" in fails(source, target)


def failing_at(content, monkeypatch):
    """Make writing of this content fail in the middle, as a full disk does."""

    def write_bytes(path, data):
        with open(path, "wb") as file:
            file.write(data[:1] if data == content else data)
            if data == content:
                raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", write_bytes)


def test_disk_full_at_once_leaves_nothing(source, target, monkeypatch):
    failing_at(b"a1", monkeypatch)
    assert "No space left on device" in fails(source, target / "deeper")
    assert not target.exists()


def test_disk_full_half_way_leaves_whole_files_and_knows_them(source, target, monkeypatch):
    with monkeypatch.context() as patch:
        failing_at(b"b1", patch)
        with pytest.raises(Problem, match="No space left on device"):
            copy_lessons(source, target)
    assert files(target) == {"a.ipynb": "a1"}
    write(source, "a.ipynb", "a2")
    assert actions(copy_lessons(source, target)) == {"a.ipynb": "update", "b.ipynb": "copy"}


def test_home_folder_unknown(monkeypatch):
    def home():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", home)
    with pytest.raises(Problem, match="--dir"):
        workspace.folder()


def test_folder_is_absolute_and_knows_the_tilde(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert workspace.folder() == tmp_path / "bezteach-lessons"
    assert workspace.folder(Path("~/x")) == workspace.folder(Path("x")) == tmp_path / "x"


def test_source_in_a_checkout_and_in_a_wheel(monkeypatch):
    assert workspace.lessons_source(Path("/clone")) == Path("/clone/lessons")
    monkeypatch.setattr(workspace, "checkout", lambda: None)
    assert workspace.lessons_source() == workspace.PACKAGE / "_lessons"


# --- what is said


def test_summary_counts_and_names_what_is_beside():
    steps = [Step("a", "copy", "a"), Step("b", "copy", "b"), Step("c", "update", "c"), Step("d", "keep")]
    folder = Path("mine")
    assert workspace.summary([Step("a", "same")], folder) == ["your lessons are in mine"]
    first, second = workspace.summary([*steps, Step("e.ipynb", "beside", "e (new).ipynb")], folder)
    assert first == "your lessons are in mine (2 copied, 1 brought up to date, 1 yours, left as they are)"
    assert "e.ipynb" in second and "e (new).ipynb" in second


def test_written_notebooks_are_named_and_other_files_are_not():
    steps = [Step("a.ipynb", "copy", "a.ipynb"), Step("b.ipynb", "keep"), Step("c.svg", "copy", "c.svg")]
    assert workspace.written(steps, Path("mine")) == [Path("mine", "a.ipynb")]
