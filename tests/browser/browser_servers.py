"""JupyterLab and Voila as processes: on a free port, at home in a folder of their own, ended for certain."""

import contextlib
import http.client
import re
import secrets
import subprocess
import sys
import time
from typing import NamedTuple

import nbformat
import psutil  # comes with ipykernel
from playwright.sync_api import expect

from bezteach import lessons
from bezteach.setup import lab, processes
from bezteach.setup.requirements import PACKAGE

PATIENCE = 60
NOT_RUN = re.compile(r"\[[ *]\]")  # beside a cell
SHOW = ("polygon", "curve", "levels")
POINTS = ((0, 0), (1, 3), (2, 1), (3, 3))
A_BOARD = (  # the cells of a notebook
    f"from bezteach.widgets import Board; board = Board({list(POINTS)}, show={SHOW}); board",
    "print(board.points)",
)


class Server(NamedTuple):
    """A server that answers: ``address`` is the beginning of all of its pages."""

    address: str
    token: str

    def run_all(self, page, notebook):
        """Open a notebook in JupyterLab and have all of its cells run, as a reader does."""
        page.goto(f"{self.address}/lab/tree/{notebook}?token={self.token}&reset")
        page.locator(".jp-NotebookPanel-toolbar").get_by_text("Python 3").wait_for()
        page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for()  # before, cells may stay unrun
        waiting = page.locator(".jp-CodeCell .jp-InputPrompt", has_text=NOT_RUN)
        waiting.first.wait_for()
        page.get_by_role("menuitem", name="Run", exact=True).click()
        page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
        expect(waiting).to_have_count(0, timeout=1000 * PATIENCE)


def write_notebook(path, *sources):
    """Write a notebook of code cells that have not been run."""
    cells = [nbformat.v4.new_code_cell(source) for source in sources]
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": lessons.KERNELSPEC}), path)


def copy_lesson(name, folder):
    """Copy a lesson as it is shipped, but for the numbers of its cells: they come as each is run."""
    lesson = lessons.parsed((lessons.ROOT / "lessons" / name).read_text(encoding="utf-8"))
    for cell in lesson.cells:
        if cell.cell_type == "code":
            cell.execution_count = None
    nbformat.write(lesson, folder / name)


@contextlib.contextmanager
def jupyterlab(folder, home):
    """JupyterLab in a folder; ``home`` takes whatever it and its kernels write."""
    port = lab.free_port(0)
    command = lab.command(folder, port, "/lab", browser=False, root_user=True)
    command.append("--KernelManager.transport_encryption=auto")  # else ipykernel 7 warns on stderr
    with _running(command, port, home, "/api/status") as server:
        yield server


NOT_OURS = ("@jupyter-notebook/lab-extension", "@jupyter/nbgrader")  # which nbgrader brings along


@contextlib.contextmanager
def voila(notebook, home):
    """Voila that shows one notebook, without extensions of tools that are here for other tests and fail in it."""
    port = lab.free_port(0)
    command = [sys.executable, "-m", "voila", str(notebook), "--no-browser", f"--port={port}", "--Voila.ip=127.0.0.1"]
    command += [f"--VoilaConfiguration.extension_denylist={name}" for name in NOT_OURS]
    with _running(command, port, home, "/voila/static/") as server:
        yield server


@contextlib.contextmanager
def _running(command, port, home, path):
    token = secrets.token_hex(24)
    with open(home / "server.log", "w+b") as log:
        process = processes.start(
            command, cwd=home, env=_environment(home, token), stdout=log, stderr=subprocess.STDOUT
        )
        try:
            _wait_until_up(process, port, path, token, log)
            yield Server(f"http://{lab.HOST}:{port}", token)
        finally:
            _end(process)


def _environment(home, token):
    """Nothing of the user's own Jupyter, and this checkout first on the path of every kernel."""
    kept = processes.child_environment(PACKAGE.parent)
    own = {name: value for name, value in kept.items() if not name.startswith(("JUPYTER", "IPYTHON", "XDG_"))}
    places = {f"JUPYTER_{name.upper()}_DIR": str(home / name) for name in ("config", "data", "runtime")}
    places["JUPYTER_CONFIG_PATH"] = str(PACKAGE / "setup")  # its labconfig: no question about news in the way
    homes = {name: str(home) for name in ("HOME", "USERPROFILE", "APPDATA", "IPYTHONDIR")}
    return own | places | homes | {"JUPYTER_TOKEN": token, "JUPYTER_PREFER_ENV_PATH": "1"}


def _wait_until_up(process, port, path, token, log):
    give_up = time.monotonic() + PATIENCE
    while process.poll() is None and time.monotonic() < give_up:
        connection = http.client.HTTPConnection(lab.HOST, port, timeout=10)
        try:
            connection.request("GET", path, headers={"Authorization": f"token {token}"})
            connection.getresponse().read()
            return
        except (OSError, http.client.HTTPException):
            time.sleep(0.1)
        finally:
            connection.close()
    log.seek(0)
    raise RuntimeError(f"the server does not answer: {log.read().decode(errors='replace')[-2000:]}")


def _end(process):
    """End the server, and for certain its kernels, which run in groups of their own."""
    family = psutil.Process(process.pid).children(recursive=True)
    processes.end(process)
    for member in psutil.wait_procs(family, timeout=5)[1]:
        with contextlib.suppress(psutil.NoSuchProcess):
            member.kill()
