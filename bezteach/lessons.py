"""Execute the lessons and write them, the same bytes from run to run: ``python -m bezteach.lessons``.

Lessons are kept in git with their outputs, because nbval compares those. What differs from run to run without
a reader seeing it is taken out; ``--check`` names the lessons whose outputs are not what their code gives.
"""

import argparse
import base64
import copy
import difflib
import hashlib
import io
import json
import os
import re
import subprocess
import sys
import time
import warnings
from collections import Counter
from pathlib import Path

import nbformat
from jupyter_client import AsyncKernelManager
from jupyter_client.kernelspec import KernelSpecManager
from nbclient import NotebookClient
from nbclient.exceptions import CellControlSignal, CellExecutionError
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
VIEW = "application/vnd.jupyter.widget-view+json"
NOISE = ("collapsed", "scrolled", "execution", "ExecuteTime", "trusted")  # tools leave these in a cell
KERNELSPEC = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
LANGUAGE = {"file_extension": ".py", "mimetype": "text/x-python", "name": "python"}  # of no one version


def parsed(text):
    """The notebook in a file's text; ValueError when it is none."""
    problem = {}
    try:
        with warnings.catch_warnings(action="ignore"):  # missing or repeated ids: ``normalised`` sets all
            notebook = nbformat.reads(text, as_version=4, capture_validation_error=problem)
    except (AttributeError, KeyError, TypeError, ValueError, nbformat.ValidationError):
        problem = True
    if problem:
        raise ValueError("not a notebook")
    return notebook


def brief(text):
    return str(text).strip().partition("\n")[0]


def serialised(notebook):
    """The notebook as its file's text: indent 1, keys sorted, characters as they are, a last newline."""
    return nbformat.v4.writes(notebook) + "\n"


def normalised(notebook):
    """A copy of the notebook in which only what the author wrote and what the code gave is left to vary.

    Set: ids, kernel, language, execution counts as a run from the top gives them (a blank cell never runs).
    Gone: widget state, timings, display noise. Tags and other metadata stay. Doing it again changes nothing.
    An id is a hash of the cell's source, counted where sources are equal: a script that writes a notebook
    gives it new random ids each time; this way only an edited cell changes its id, whatever moves around it.
    """
    notebook, seen, count = copy.deepcopy(notebook), Counter(), 0
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    notebook.metadata.pop("widgets", None)
    notebook.metadata.update(nbformat.from_dict({"kernelspec": KERNELSPEC, "language_info": LANGUAGE}))
    for cell in notebook.cells:
        digest = hashlib.sha256(cell.source.encode()).hexdigest()[:8]
        seen[digest] += 1
        cell.id = f"{digest}-{seen[digest]}" if seen[digest] > 1 else digest
        cell.metadata = nbformat.from_dict({k: v for k, v in cell.metadata.items() if k not in NOISE})
        if cell.cell_type == "code":
            count += bool(cell.source.strip())
            cell.execution_count = count if cell.source.strip() else None
            cell.outputs = normalised_outputs(cell.outputs, cell.execution_count)
    return notebook


def normalised_outputs(outputs, count):
    """The outputs without live widget views, a stream's pieces joined, a result numbered like its cell.

    A view stored without its widget shows as an error in JupyterLab until the cell is run; without it, what
    is stored beside it shows. Its id is random, so an output that is only a view goes. nbval skips views.
    """
    kept = []
    for output in outputs:
        if "data" in output and output.data.pop(VIEW, None) and not output.data:
            continue
        if output.output_type == "execute_result":
            output.execution_count = count
        # In how many pieces a stream comes, the clock decides. Only neighbours are joined: the order stays.
        if kept and output.output_type == "stream" and output.name == kept[-1].get("name"):
            kept[-1].text += output.text
        else:
            kept.append(output)
    return kept


def wordless(outputs):
    """Of outputs as a kernel gave them: the texts of widgets that say no more in words than their traits."""
    words = [output.data.get("text/plain", "") for output in outputs if VIEW in output.get("data", {})]
    return [text for text in words if re.match(r"\s*$|\w+\((\w+=|\)|$)", text)]


def executed(notebook, folder):
    """A copy of the notebook with the outputs of a fresh kernel of this interpreter, working in the folder.

    ValueError names the first cell that raised, had a callback raise, wrote to stderr, hung or died.
    """
    # Without folders to look in, this interpreter is the kernel, whatever kernelspecs the user has.
    manager = AsyncKernelManager(kernel_spec_manager=KernelSpecManager(kernel_dirs=[]))
    client = NotebookClient(copy.deepcopy(notebook), km=manager, timeout=600, shutdown_kernel="immediate")
    client.record_timing = client.store_widget_state = False
    client.skip_cells_with_tag = ""  # no tag excuses a cell; that of "raises-exception" is seen below
    client.widget_registry = {}  # else nbclient keeps to itself what an Output widget catches, errors too
    # The lesson finds this bezteach, draws inline and breaks lines alike, whatever is set around.
    env = {name: value for name, value in os.environ.items() if name not in ("MPLBACKEND", "COLUMNS")}
    env["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), env.get("PYTHONPATH")]))
    try:
        notebook = client.execute(cwd=str(folder), env=env, cleanup_kc=True, stderr=subprocess.DEVNULL)
    except (CellControlSignal, RuntimeError, AssertionError) as error:  # the last is nbclient after Ctrl-C
        said = f"{error.ename}: {error.evalue}" if isinstance(error, CellExecutionError) else error
        raise ValueError(f"In [{client.code_cells_executed}]: {brief(said) or 'interrupted'}") from None
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if output.output_type == "error" or output.get("name") == "stderr":
                said = output.get("text") or f"{output.ename}: {output.evalue}"
                raise ValueError(f"In [{cell.execution_count}]: {brief(said)}")
    return notebook


def staleness(text, fresh):
    """Where and how a stored text first differs from the notebook it should hold; "" when it does not."""
    stored = parsed(text)
    for index, (old, new) in enumerate(zip(stored.cells, fresh.cells, strict=True), start=1):
        if diff := difference(old, new):
            where = f"In [{new.execution_count}]" if "outputs" in new else f"cell {index} ({new.cell_type})"
            return "\n    ".join([f"{where}, stored - and fresh +", *(line[:150] for line in diff)])
    same = stored.metadata == fresh.metadata and serialised(stored) == text
    return "" if same else "its metadata or the layout of its JSON"


def difference(old, new):
    """The first lines in which two cells differ, as a diff; none when they hold the same."""
    return list(difflib.unified_diff(lines(old), lines(new), n=1, lineterm=""))[2:12]


def lines(cell):
    """The cell as lines of JSON to compare, with a digest of the pixels in place of a PNG's bytes.

    Another Pillow may compress the same picture into other bytes; a lesson is not stale for that.
    """
    cell = copy.deepcopy(cell)
    for output in cell.get("outputs", []):
        if png := output.get("data", {}).get("image/png"):
            try:
                picture = Image.open(io.BytesIO(base64.b64decode(png))).convert("RGBA")
                output.data["image/png"] = f"{picture.size} {hashlib.sha256(picture.tobytes()).hexdigest()}"
            except (OSError, SyntaxError, ValueError):  # Pillow and base64, on a broken one
                continue
    return json.dumps(cell, indent=1, sort_keys=True, ensure_ascii=False).replace("\\n", "\n").splitlines()


def notebooks(paths):
    """The notebooks that files and folders name, but checkpoints; ValueError for a path that names none."""
    for path in paths:
        found = sorted(path.rglob("*.ipynb")) if path.is_dir() else [path]
        found = [one for one in found if one.suffix == ".ipynb" and ".ipynb_checkpoints" not in one.parts]
        if not path.exists() or not found:
            raise ValueError(f"{path}: {'no notebook here' if path.exists() else 'no such file or folder'}")
        yield from found


def process(path, check):
    """Execute a lesson, write or check it, and say so; True unless stale. ValueError: which cell failed."""
    start = time.monotonic()
    try:
        text = path.read_text(encoding="utf-8")
        fresh = normalised(executed(parsed(text), path.resolve().parent))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    stale = staleness(text, fresh) if check else ""
    if not check and serialised(fresh) != text:
        new = path.resolve().with_name(f".{path.name}.new")  # so that no one ever sees half a lesson
        new.write_text(serialised(fresh), encoding="utf-8", newline="\n")
        new.replace(path.resolve())
    seconds, size = time.monotonic() - start, path.stat().st_size / 1000
    print(f"{path}: {seconds:.1f} s, {size:.0f} KB{', stale: ' if stale else ''}{stale}", flush=True)
    return not stale


def main(arguments=None):
    """0 when all went well, 1 when lessons are stale, 2 when one does not run or a path is wrong."""
    parser = argparse.ArgumentParser(prog="python -m bezteach.lessons", description=brief(__doc__))
    parser.add_argument("paths", nargs="*", type=Path, metavar="PATH", help="default: the folder lessons")
    parser.add_argument("--check", action="store_true", help="write nothing, fail when a lesson is stale")
    options = parser.parse_args(arguments)
    try:
        chosen = list(notebooks(options.paths or [ROOT / "lessons"]))
        return max(int(not process(path, options.check)) for path in chosen)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
