"""What ``python -m bezteach.lessons`` promises: the same bytes from run to run, stale ones found."""

import base64
import io
import json
import os
import subprocess
import sys
from copy import deepcopy

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output, new_raw_cell
from PIL import Image

from bezteach import lessons
from bezteach.lessons import VIEW, main, normalised, parsed, serialised, staleness

FIGURE = """\
import matplotlib.pyplot as plt
from matplotlib_inline.backend_inline import set_matplotlib_formats
set_matplotlib_formats("png", "svg", metadata={"Date": None})
plt.rcParams["svg.hashsalt"] = "bezteach"
figure, axes = plt.subplots()
axes.plot([0, 1, 2], [1, 3, 2])
plt.show()"""
SLIDER = """\
from IPython.display import HTML, Math, display
from ipywidgets import IntSlider
slider = IntSlider(value=1, max=9)
print("before")
display(slider)
slider.value = 4
print("t =", slider.value)"""
ALONE = f"display({{'{VIEW}': {{'model_id': slider.model_id, 'version_major': 2}}}}, raw=True)"
EVERYTHING = [
    FIGURE,
    SLIDER,
    ALONE,
    "display(Math('b_0^2'))\nHTML('<b>split</b>')",
    "",
    "# room for an answer",
    "6 * 7",
]


def notebook(*sources):
    return new_notebook(cells=[new_markdown_cell("# Bézier, 贝塞尔"), *map(new_code_cell, sources)])


def saved(path, *sources):
    path.write_text(serialised(notebook(*sources)), encoding="utf-8")
    return path


def executed_by_hand():
    """A notebook with every kind of thing that differs from run to run, as several tools would leave it."""
    view = {VIEW: {"model_id": "0f3a", "version_major": 2, "version_minor": 0}}
    messy = notebook("print('one')", "slider", "slider", "x = 1", " ")
    messy.metadata = nbformat.from_dict(
        {"widgets": {"state": {}}, "authors": [{"name": "A"}], "kernelspec": {"name": "mine"}}
    )
    messy.metadata.language_info = nbformat.from_dict({"name": "python", "version": "3.99"})
    messy.cells.append(new_raw_cell("raw"))
    messy.cells[1].metadata = nbformat.from_dict(
        {
            "collapsed": True,
            "scrolled": False,
            "execution": {"iopub.status.busy": "2024"},
            "tags": ["answer"],
            "jupyter": {"source_hidden": True},
        }
    )
    messy.cells[1].execution_count = 17
    messy.cells[1].outputs = [
        new_output("stream", name="stdout", text="o"),
        new_output("stream", name="stdout", text="ne\n"),
        new_output("display_data", data={"text/html": "<b>1</b>"}),
        new_output("stream", name="stdout", text="two\n"),
    ]
    messy.cells[2].outputs = [
        new_output("execute_result", data={"text/plain": "slider"} | view, execution_count=18),
        new_output("display_data", data=view),
    ]
    return messy


# Normalising


def test_normalising_twice_changes_nothing_more():
    once = normalised(executed_by_hand())
    assert serialised(normalised(once)) == serialised(once)
    nbformat.validate(once)


def test_normalising_leaves_its_argument_alone():
    messy = executed_by_hand()
    before = deepcopy(messy)
    normalised(messy)
    assert messy == before


def test_an_id_follows_its_source_and_nothing_else():
    cells = normalised(notebook("a", "b", "a")).cells
    shifted = normalised(notebook("new", "a", "b", "a")).cells
    assert [cell.id for cell in shifted[2:]] == [cell.id for cell in cells[1:]]
    assert cells[3].id == f"{cells[1].id}-2"
    assert [cell.id for cell in normalised(notebook("a", "b", "a")).cells] == [cell.id for cell in cells]


def test_counts_are_those_of_a_run_from_the_top():
    result = normalised(executed_by_hand())
    assert [cell.execution_count for cell in result.cells if cell.cell_type == "code"] == [1, 2, 3, 4, None]
    assert result.cells[2].outputs[0].execution_count == 2


def test_noise_goes_and_what_the_author_set_stays():
    result = normalised(executed_by_hand())
    assert result.cells[1].metadata == {"tags": ["answer"], "jupyter": {"source_hidden": True}}
    assert set(result.metadata) == {"authors", "kernelspec", "language_info"}
    assert result.metadata.kernelspec == {
        "display_name": "Python 3 (ipykernel)",
        "language": "python",
        "name": "python3",
    }
    assert "version" not in result.metadata.language_info


def test_a_stream_comes_in_one_piece_but_keeps_its_place():
    outputs = normalised(executed_by_hand()).cells[1].outputs
    assert [output.get("text") for output in outputs] == ["one\n", None, "two\n"]


def test_a_live_view_gives_way_to_what_is_stored_beside_it():
    outputs = normalised(executed_by_hand()).cells[2].outputs
    assert [output.data for output in outputs] == [{"text/plain": "slider"}]


def test_the_file_is_laid_out_as_jupyterlab_does():
    text = serialised(normalised(executed_by_hand()))
    assert text.endswith("}\n")
    assert "Bézier, 贝塞尔" in text
    assert json.dumps(json.loads(text), indent=1, sort_keys=True, ensure_ascii=False) + "\n" == text


# Staleness, of a stored text against what a run gives


@pytest.fixture
def fresh():
    return normalised(executed_by_hand())


def test_what_a_run_gives_is_not_stale(fresh):
    assert staleness(serialised(fresh), fresh) == ""


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda nb: nb.cells[1].outputs[0].update(text="three\n"), "In [1]"),
        (lambda nb: nb.cells[1].outputs.clear(), "In [1]"),
        (lambda nb: nb.cells[2].update(execution_count=7), "In [2]"),
        (lambda nb: nb.cells[2].outputs[0].data.update({"text/plain": "slides"}), "In [2]"),
        (lambda nb: nb.cells[0].metadata.update(collapsed=True), "cell 1 (markdown)"),
        (lambda nb: nb.metadata.update(widgets={}), "metadata"),
        (lambda nb: nb.metadata.language_info.update(version="3.11"), "metadata"),
    ],
)
def test_a_change_is_found_and_placed(fresh, change, told):
    stored = deepcopy(fresh)
    change(stored)
    assert told in staleness(serialised(stored), fresh).partition("\n")[0]


def test_another_layout_of_the_same_json_is_stale(fresh):
    assert "layout" in staleness(json.dumps(json.loads(serialised(fresh)), indent=2), fresh)


def test_the_difference_is_shown_short(fresh):
    stored = deepcopy(fresh)
    stored.cells[1].outputs[0].text = "x" * 10**6
    told = staleness(serialised(stored), fresh)
    assert '-   "text": "xxx' in told
    assert '+   "text": "one' in told
    assert len(told) < 2000


def test_a_png_is_its_pixels(fresh):
    def with_picture(colour, **options):
        file = io.BytesIO()
        Image.new("RGB", (9, 9), colour).save(file, "PNG", **options)
        copy = deepcopy(fresh)
        copy.cells[1].outputs[1].data["image/png"] = base64.b64encode(file.getvalue()).decode()
        return copy

    packed, plain = with_picture("navy", compress_level=9), with_picture("navy", compress_level=0)
    assert packed != plain
    assert staleness(serialised(plain), packed) == ""
    assert "In [1]" in staleness(serialised(with_picture("red")), packed)
    plain.cells[1].outputs[1].data["image/png"] = "broken"
    assert "In [1]" in staleness(serialised(plain), packed)


# The tool at work


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A lesson with every kind of output, written by the tool."""
    path = saved(tmp_path_factory.mktemp("written") / "everything.ipynb", *EVERYTHING)
    assert main([str(path)]) == 0
    return path


def outputs(path):
    cells = parsed(path.read_text(encoding="utf-8")).cells
    return [output for cell in cells for output in cell.get("outputs", [])]


def test_every_kind_of_output_is_stored(written):
    kinds = {kind for output in outputs(written) for kind in output.get("data", {output.output_type: 0})}
    assert kinds == {"text/plain", "text/html", "text/latex", "image/png", "image/svg+xml", "stream"}
    assert [output.text for output in outputs(written) if "text" in output] == ["before\n", "t = 4\n"]


def test_a_second_run_gives_the_same_bytes(written):
    again = written.with_name("again.ipynb")
    again.write_bytes(written.read_bytes())
    assert main([str(again)]) == 0
    assert again.read_bytes() == written.read_bytes()
    assert sorted(one.name for one in written.parent.iterdir()) == ["again.ipynb", "everything.ipynb"]


def test_nbval_accepts_what_the_tool_writes(written, tmp_path, nested_run):
    """Among it a widget stored without its live view, and an output that was nothing but a view."""
    (tmp_path / "copy.ipynb").write_bytes(written.read_bytes())
    told = nested_run(tmp_path, "-q", "--nbval", "--nbval-current-env", "copy.ipynb")
    assert "7 passed" in told, told
    assert "failed" not in told


def test_check_passes_on_what_the_tool_wrote_and_writes_nothing(tmp_path, capsys):
    path = saved(tmp_path / "a.ipynb", "print('one')", "x = 1", "x + 1")
    assert main([str(path)]) == 0
    before = path.read_bytes(), path.stat().st_mtime_ns
    assert main([str(path), "--check"]) == 0
    assert (path.read_bytes(), path.stat().st_mtime_ns) == before
    assert capsys.readouterr().out.count(" s, 1 KB\n") == 2


def test_check_names_every_stale_notebook_and_its_first_stale_cell(tmp_path):
    good = saved(tmp_path / "good.ipynb", "1 + 1")
    assert main([str(good)]) == 0
    source, output = tmp_path / "source.ipynb", tmp_path / "output.ipynb"
    source.write_text(good.read_text().replace("1 + 1", "1 + 2"))
    output.write_text(good.read_text().replace('"2"', '"3"'))
    before = source.read_bytes(), output.read_bytes()
    command = [sys.executable, "-m", "bezteach.lessons", "--check", tmp_path]
    run = subprocess.run(
        command,
        check=False,
        capture_output=True,
        text=True,
        env=os.environ | {"PYTHONPATH": str(lessons.ROOT)},
    )
    assert run.returncode == 1
    assert run.stderr == ""
    told = [line for line in run.stdout.splitlines() if ", stale: " in line]
    assert [line.partition(":")[0] for line in told] == [str(output), str(source)]
    assert all("In [1]" in line for line in told)
    assert (source.read_bytes(), output.read_bytes()) == before


@pytest.mark.parametrize(
    ("source", "told"),
    [
        ("1 / 0", "In [2]: ZeroDivisionError: division by zero"),
        ("import sys; print('careful\\nmore', file=sys.stderr)", "In [2]: careful"),
        (
            "from ipywidgets import interact\n@interact(t=(0, 4))\ndef show(t):\n    1 / (2 - t)",
            "In [2]: ZeroDivisionError",
        ),
        ("import os; os._exit(1)", "In [2]: Kernel died"),
    ],
    ids=["raises", "stderr", "callback raises", "kernel dies"],
)
def test_a_cell_that_fails_stops_the_tool_and_leaves_the_file(tmp_path, capsys, source, told):
    path = saved(tmp_path / "bad.ipynb", "x = 1", source, "print('never')")
    stored = parsed(path.read_text(encoding="utf-8"))
    stored.cells[2].metadata.tags = ["raises-exception", "skip-execution"]  # no way out
    path.write_text(serialised(stored), encoding="utf-8")
    before = path.read_bytes()
    assert main([str(path)]) == 2
    assert capsys.readouterr().err.startswith(f"{path}: {told}")
    assert capsys.readouterr().err.count("\n") <= 1
    assert path.read_bytes() == before
    assert [one.name for one in tmp_path.iterdir()] == ["bad.ipynb"]


def test_the_kernel_is_this_interpreter_in_the_lessons_folder_whatever_is_set_around(tmp_path, monkeypatch):
    spec = tmp_path / "share" / "kernels" / "python3" / "kernel.json"
    spec.parent.mkdir(parents=True)
    broken = {"argv": ["/no/such/python", "{connection_file}"], "display_name": "", "language": "python"}
    spec.write_text(json.dumps(broken))
    monkeypatch.setenv("JUPYTER_PATH", str(tmp_path / "share"))
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.delenv("PYTHONPATH", raising=False)
    monkeypatch.setenv("COLUMNS", "20")
    told = "import os, sys, bezteach\nprint(sys.executable, os.getcwd(), sep='\\n')\n"
    told += "print(os.environ['MPLBACKEND'], 'COLUMNS' in os.environ)"
    path = saved(tmp_path / "a.ipynb", told)
    assert main([str(path)]) == 0
    (result,) = outputs(path)
    inline = "module://matplotlib_inline.backend_inline"
    assert result.text.splitlines() == [sys.executable, str(tmp_path), f"{inline} False"]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("gone.ipynb", None),
        ("notes.md", "# notes"),
        ("empty.ipynb", ""),
        ("list.ipynb", "[1]"),
        ("other.ipynb", "{}"),
    ],
)
def test_a_path_without_a_notebook_is_a_one_line_error(tmp_path, capsys, name, text):
    path = tmp_path / name
    if text is not None:
        path.write_text(text)
    assert main([str(path)]) == 2
    told = capsys.readouterr().err
    assert told.startswith(f"{path}: ")
    assert told.count("\n") == 1


def test_a_folder_stands_for_every_notebook_in_it_but_checkpoints(tmp_path):
    for name in ("b.ipynb", "part/a.ipynb", ".ipynb_checkpoints/b-checkpoint.ipynb", "notes.md"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        saved(tmp_path / name)
    assert [str(one.relative_to(tmp_path)) for one in lessons.notebooks([tmp_path])] == [
        "b.ipynb",
        os.path.join("part", "a.ipynb"),
    ]
    with pytest.raises(ValueError, match="no notebook here"):
        list(lessons.notebooks([tmp_path / ".ipynb_checkpoints"]))
