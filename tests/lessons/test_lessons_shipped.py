"""What holds for every lesson in lessons/, above all where nbval is a check that cannot fail.

nbval compares the text, LaTeX, HTML and SVG that a run gives with what is stored; conftest.py compares the rest.
Neither looks at a tagged cell, or does anything at all unless nbval is switched on. Each rule here is a function from
a notebook to its faults, and is shown a notebook that breaks it.
"""

import ast
import re
from copy import deepcopy

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook, new_output
from nbval.plugin import find_comment_markers, metadata_tags

from bezteach.lessons import ROOT, VIEW, normalised, parsed, serialised, wordless

LESSONS = sorted(p for p in (ROOT / "lessons").rglob("*.ipynb") if ".ipynb_checkpoints" not in p.parts)
ALLOWED_TAGS = set()  # (name of the lesson, tag): none may be excused from the comparison
HEAVIEST = 1_000_000  # bytes

every_lesson = pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)


def read(path):
    return parsed(path.read_text(encoding="utf-8"))


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def outputs(notebook):
    return [output for cell in code_cells(notebook) for output in cell.outputs]


def data(notebook):
    """Each output's representations; what is printed counts as plain text."""
    return [output.get("data") or {"text/plain": output.get("text", "")} for output in outputs(notebook)]


# The rules


def never_run(notebook):
    return [cell.source for cell in code_cells(notebook) if cell.source.strip() and not cell.execution_count]


def errors_and_warnings(notebook):
    return [one for one in outputs(notebook) if one.output_type == "error" or one.get("name") == "stderr"]


def excused_by_tag(notebook, name=""):
    blind = {*metadata_tags, "skip-execution"}  # nbval's own list, and nbclient's
    tags = [tag for cell in notebook.cells for tag in cell.metadata.get("tags", [])]
    return [tag for tag in tags if tag in blind and (name, tag) not in ALLOWED_TAGS]


def excused_by_comment(notebook):
    return [marker for cell in code_cells(notebook) for marker in find_comment_markers(cell.source)]


def widget_state(notebook):
    return list(notebook.metadata.get("widgets", {})) + [one for one in data(notebook) if VIEW in one]


def pictures_nbval_cannot_see(notebook):
    return [list(one) for one in data(notebook) if "image/png" in one and "<img" not in one.get("text/html", "")]


def pictures_without_words(notebook):
    shown = [one for one in outputs(notebook) if "image/png" in one.get("data", {})]
    silent = [one.metadata for one in shown if not one.metadata.get("image/png", {}).get("alt", "").strip()]
    silent += [one for one in data(notebook) if "image/svg+xml" in one]  # which no viewer gives words
    tags = [tag for one in data(notebook) for tag in re.findall("<img[^>]*>", one.get("text/html", ""))]
    return silent + [tag for tag in tags if not re.search(r' alt="\s*[^"\s]', tag)]


def memory_addresses(notebook):
    texts = [text for one in data(notebook) for kind, text in one.items() if kind.startswith("text/")]
    return [text for text in texts if re.search(r"\bat 0x[0-9a-f]+", text)]


def default_widget_reprs(executed):
    return [text for cell in code_cells(executed) for text in wordless(cell.outputs)]


def algorithms(notebook):
    """What computes in a notebook instead of being called from it: def, class, lambda, while, :=, a loop that
    does more than assert, print, display or move a widget; and magics, which hide code from this.
    """
    return [fault for cell in code_cells(notebook) for fault in algorithms_in(cell.source)]


def algorithms_in(source):
    try:
        tree = ast.parse(source)
    except SyntaxError as error:
        return [f"not Python: {error.text}"]
    written = (
        ast.FunctionDef,
        ast.AsyncFunctionDef,
        ast.ClassDef,
        ast.Lambda,
        ast.While,
        ast.AsyncFor,
        ast.NamedExpr,
    )
    computing = [node for node in ast.walk(tree) if isinstance(node, written)]
    for loop in (node for node in ast.walk(tree) if isinstance(node, ast.For)):
        computing += [line for line in loop.body + loop.orelse if not only_shows(line)]
    return [ast.unparse(node) for node in computing]


def only_shows(line):
    """Whether a line of a loop asserts, prints, displays, or sets an attribute (``slider.value = t``)."""
    match line:
        case ast.Assert() | ast.For() | ast.Pass():  # a loop inside is judged by its own lines
            return True
        case ast.Expr(value=ast.Call(func=ast.Name(id="print" | "display"))):
            return True
        case ast.Assign(targets=targets):
            return all(isinstance(target, ast.Attribute) for target in targets)
        case ast.If(body=body, orelse=orelse):
            return all(only_shows(inner) for inner in body + orelse)
    return False


RULES = [
    never_run,
    errors_and_warnings,
    excused_by_tag,
    excused_by_comment,
    widget_state,
    pictures_nbval_cannot_see,
    pictures_without_words,
    memory_addresses,
    algorithms,
]


# The lessons obey


def test_there_are_lessons():
    assert LESSONS, "lessons/ is empty: everything below would pass"


@every_lesson
@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_a_lesson_has_no(rule, path):
    assert rule(read(path)) == []


@every_lesson
def test_a_lesson_is_light(path):
    assert path.stat().st_size <= HEAVIEST


@every_lesson
def test_a_lesson_is_stored_as_the_tool_writes_it(path):
    text = path.read_text(encoding="utf-8")
    assert text == serialised(normalised(parsed(text))), "run python -m bezteach.lessons"


# The rules find what they are for


def cell(source="x", outputs=(), count=1, **metadata):
    one = new_code_cell(source, outputs=list(outputs), execution_count=count, metadata=metadata)
    return new_notebook(cells=[one])


def shown(metadata=None, **kinds):
    names = {"png": "image/png", "svg": "image/svg+xml", "html": "text/html", "plain": "text/plain", "view": VIEW}
    data = {names[kind]: value for kind, value in kinds.items()}
    return cell(outputs=[new_output("display_data", data=data, metadata=metadata or {})])


IMAGE = '<img alt="a cubic" src="data:image/svg+xml,%3Csvg/%3E">'
BROKEN = [
    (never_run, cell(count=None)),
    (errors_and_warnings, cell(outputs=[new_output("error", ename="E", evalue="", traceback=[])])),
    (errors_and_warnings, cell(outputs=[new_output("stream", name="stderr", text="careful")])),
    *[(excused_by_tag, cell(tags=["mine", tag])) for tag in (*metadata_tags, "skip-execution")],
    (excused_by_comment, cell("x = 1\n  # NBVAL_SKIP")),
    (excused_by_comment, cell("#NBVAL_IGNORE_OUTPUT\nx")),
    (excused_by_comment, cell("# PYTEST_VALIDATE_IGNORE_OUTPUT\nx")),
    (widget_state, new_notebook(metadata={"widgets": {"application/vnd.jupyter.widget-state+json": {}}})),
    (widget_state, shown(view={"model_id": "0f3a"}, plain="a board")),
    (pictures_nbval_cannot_see, shown(png="iVBO", plain="<Figure>")),
    (pictures_nbval_cannot_see, shown(png="iVBO", html="<p>a cubic</p>")),
    (pictures_without_words, shown(png="iVBO", html=IMAGE)),
    (pictures_without_words, shown(png="iVBO", html=IMAGE, metadata={"image/png": {"alt": " "}})),
    (pictures_without_words, shown(svg="<svg/>", plain="a cubic")),
    (pictures_without_words, shown(html='<img alt="" src="data:,">')),
    (pictures_without_words, shown(html=f'{IMAGE}<img src="data:,">')),
    (memory_addresses, shown(plain="[<matplotlib.lines.Line2D at 0x7f0a>]")),
    (memory_addresses, cell(outputs=[new_output("stream", text="<function f at 0x7f0a>\n")])),
    (default_widget_reprs, shown(view={}, plain="IntSlider(value=1, max=9)")),
    (default_widget_reprs, shown(view={}, plain="HBox(children=(IntSlider(value=1),))")),
    (default_widget_reprs, shown(view={}, plain="Board()")),
    (default_widget_reprs, shown(view={})),
    *[
        (algorithms, cell(source))
        for source in (
            "def f(t): return t",
            "class Curve: pass",
            "f = lambda t: t",
            "while points: points = points[1:]",
            "for k in range(3): total += k",
            "for k in range(3):\n    for j in range(k):\n        levels.append(k)",
            "for k in range(3):\n    if k:\n        b[k] = 0",
            "[last := last + k for k in range(3)]",
            "%matplotlib inline",
        )
    ],
]
SOUND = [
    (default_widget_reprs, shown(view={}, plain="the cubic split at t = 1/3, points (0, 0), (1, 3)")),
    (pictures_without_words, shown(png="iVBO", html=IMAGE, metadata={"image/png": {"alt": "a cubic"}})),
    (pictures_nbval_cannot_see, shown(html=IMAGE, plain="a board")),
    (excused_by_tag, cell(tags=["answer", "hide-input"])),
    (excused_by_comment, cell("print('# NBVAL_SKIP')")),
    (never_run, cell("", count=None)),
    (
        algorithms,
        cell("for t in (0, 1):\n    slider.value = t\n    print(slider.value)\n    assert slider.value == t"),
    ),
    (algorithms, cell("left, right = bz.split(points, t)\n[str(t) for t in left]")),
]


@pytest.mark.parametrize(("rule", "notebook"), BROKEN)
def test_a_rule_finds_what_breaks_it(rule, notebook):
    assert rule(notebook) != []


@pytest.mark.parametrize(("rule", "notebook"), SOUND)
def test_a_rule_lets_sound_cells_be(rule, notebook):
    assert rule(notebook) == []


# nbval is switched on, reaches the lessons, and fails where it can see


def test_pytest_as_configured_collects_every_code_cell_strictly(pytestconfig):
    options = " ".join(pytestconfig.getini("addopts")).split()
    assert {"--nbval", "--nbval-current-env"} <= set(options)
    assert not {"--nbval-lax", "-x"} & set(options)
    assert not [option for option in options if "sanitize" in option]
    assert "lessons" in pytestconfig.getini("testpaths")


def test_nbval_reaches_every_code_cell(nested_run):
    told = nested_run(ROOT, "--collect-only", "-q", "lessons")
    listed = re.findall(r"^lessons/(.+?)::Cell \d+$", told, re.MULTILINE)
    cells = [(path, cell) for path in LESSONS for cell in code_cells(read(path))]
    assert sorted(listed) == sorted(path.relative_to(ROOT / "lessons").as_posix() for path, _ in cells)
    assert listed


def first(cells, kind, *, but=()):
    """The place of the first cell, but some, with an output of the kind; text beside a picture is no text."""
    for place, one in enumerate(cells):
        kinds = {key for output in one.get("outputs", []) for key in output.get("data", ["stream"])}
        if kind in kinds - ({"text/plain"} if "text/html" in kinds else set()) and place not in but:
            return place
    raise AssertionError(f"no cell with {kind} left to corrupt")


def corrupted(notebook):
    """A copy with four lies, ending after the last, and the places of the four among the cells."""
    lying = deepcopy(notebook)
    picture = first(lying.cells, "image/png")
    pixels = first(lying.cells, "image/png", but=[picture])
    text = first(lying.cells, "text/plain", but=[picture, pixels])
    stripped = first(lying.cells, "stream", but=[picture, pixels, text])
    drawn = representation(lying.cells[picture], "text/html")
    drawn["text/html"] = with_another_digit(drawn["text/html"])
    painted = representation(lying.cells[pixels], "image/png")
    painted["image/png"] = representation(lying.cells[picture], "image/png")["image/png"]
    representation(lying.cells[text], "text/plain")["text/plain"] += "0"
    lying.cells[stripped].update(outputs=[], execution_count=None)
    places = [picture, pixels, text, stripped]
    lying.cells = lying.cells[: max(places) + 1]
    return lying, places


def representation(cell, kind):
    return next(output.data for output in cell.outputs if kind in output.get("data", {}))


def with_another_digit(image):
    """The picture with the first point of its first line moved, by one character."""
    spot = re.search(r" d=%22M -?(\d)", image).start(1)
    return image[:spot] + str((int(image[spot]) + 1) % 10) + image[spot + 1 :]


def test_a_corrupted_lesson_fails(tmp_path, nested_run):
    """nbval sees the digit in a picture and the character in a text; conftest.py also pixels and an emptied cell."""
    copy, places = corrupted(read(ROOT / "lessons" / "02-definitions.ipynb"))
    nbformat.write(copy, tmp_path / "copy.ipynb")
    (tmp_path / "conftest.py").write_text((ROOT / "conftest.py").read_text())
    told = nested_run(tmp_path, "-v", "--tb=no", "--nbval", "--nbval-current-env", "copy.ipynb")
    verdicts = re.findall(r"::Cell \d+ (PASSED|FAILED)", told)
    code = [index for index, one in enumerate(copy.cells) if one.cell_type == "code"]
    failed = [place for place, verdict in zip(code, verdicts, strict=True) if verdict == "FAILED"]
    assert failed == sorted(places)
    assert never_run(copy) == [copy.cells[places[3]].source]
