"""The command line as a user meets it: real processes, one line for everything that goes wrong."""

import contextlib
import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import nbformat
import psutil  # comes with ipykernel
import pytest

import bezteach
from bezteach import cli
from bezteach.setup import requirements
from bezteach.setup.progress import Problem

ROOT = Path(bezteach.__file__).parents[1]
pytest_plugins = ["pytester"]


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A home folder of its own for everything a test starts: no trace in the user's, no setting from there."""
    for name in [name for name in os.environ if name.startswith(("JUPYTER", "IPYTHON"))]:
        monkeypatch.delenv(name)
    for name in ("HOME", "USERPROFILE", "APPDATA"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    return tmp_path


@pytest.fixture
def lessons(home, monkeypatch):
    """A checkout with lessons of its own and this package, since the real ones are none of these tests' business."""
    root = home / "check out ü"
    (root / "lessons").mkdir(parents=True)
    shutil.copytree(ROOT / "bezteach", root / "bezteach", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setenv("PYTHONPATH", str(root))
    (root / "pyproject.toml").write_bytes((ROOT / "pyproject.toml").read_bytes())
    cell = nbformat.v4.new_code_cell("import bezteach")
    nbformat.write(nbformat.v4.new_notebook(cells=[cell]), root / "lessons" / "00-start.ipynb")
    return root / "lessons"


def run(*arguments, **options):
    return subprocess.run(
        [sys.executable, "-m", "bezteach", *arguments],
        check=False,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        **{"cwd": os.environ["HOME"], **options},
    )


def one_line(done, *words):
    assert done.returncode == 1 and done.stderr.startswith("bezteach: ") and done.stderr.count("\n") == 1, done.stderr
    for word in words:
        assert word in done.stderr
    return True


# --- arguments


def test_version(home):
    done = run("--version")
    assert (done.returncode, done.stdout, done.stderr) == (0, f"bezteach {bezteach.__version__}\n", "")


def test_without_a_command_the_commands_are_shown(home):
    done = run()
    assert done.returncode == 0
    for name in cli.COMMANDS:
        assert f"\n    {name} " in done.stdout


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (["labb"], "invalid choice: 'labb'"),
        (["lab", "--port", "65536"], "'65536' is no port"),
        (["lab", "--port", "-1"], "is no port"),
        (["lab", "--port", "x"], "'x' is no port"),
        (["lab", "--port", "²"], "is no port"),
        (["lab", "--dir", ""], "the name is empty"),
        (["lab", "--nothing"], "unrecognized arguments: --nothing"),
    ],
)
def test_wrong_arguments(line, words, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(line)
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("rest", [[], ["-h"], ["--version"], ["-k", "a or b"], ["--", "-x"], ["lab"], ["tests", "-q"]])
def test_arguments_behind_test_are_pytests(rest):
    arguments = cli.parse(["test", *rest])
    assert (arguments.command, arguments.rest, arguments.all) == ("test", rest, ["test", *rest])


def test_tests_of_an_installed_wheel(monkeypatch, capsys):
    monkeypatch.setattr(requirements, "checkout", lambda: None)
    assert cli.main(["test"]) == 1
    assert capsys.readouterr().err.startswith("bezteach: the tests come with a checkout")


@pytest.mark.parametrize(
    ("raised", "code", "words"),
    [
        (Problem("do this"), 1, "bezteach: do this\n"),
        (OSError(28, "No space left on device"), 1, "bezteach: [Errno 28] No space left on device\n"),
        (KeyboardInterrupt(), 130, "bezteach: stopped\n"),
    ],
)
def test_what_goes_wrong_is_one_line(raised, code, words, monkeypatch, capsys):
    def fail(arguments):
        raise raised

    monkeypatch.setitem(cli.COMMANDS, "test", cli.Command("x", fail))
    assert cli.main(["test"]) == code
    assert capsys.readouterr().err == words


# --- bezteach test


def test_pytest_runs_in_the_checkout_with_its_exit_code_and_its_output(home):
    done = run("test", "--collect-only", "-q", "-k", "no_such_name", "tests/test_cli.py")
    assert (done.returncode, done.stderr) == (pytest.ExitCode.NO_TESTS_COLLECTED, "")
    assert "deselected" in done.stdout.splitlines()[-1]


@pytest.fixture
def inner(pytester, monkeypatch):
    """A function that runs a pytest of its own, with the project's conftest, on some tests."""
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    pytester.makeconftest((ROOT / "conftest.py").read_text(encoding="utf-8"))

    def run_inner(tests, require_all):
        monkeypatch.setenv("BEZTEACH_REQUIRE_ALL", require_all)
        pytester.makepyfile(tests)
        return pytester.runpytest_subprocess()

    return run_inner


NOT_PASSED = """
    import pytest
    def test_good(): pass
    @pytest.mark.skip
    def test_skipped(): pass
    @pytest.mark.xfail
    def test_xfailed(): assert False
    @pytest.mark.xfail
    def test_xpassed(): pass
"""


@pytest.mark.parametrize("kind", ["skipped", "xfailed", "xpassed"])
def test_in_ci_a_test_that_did_not_simply_pass_is_a_failure(inner, kind):
    only = NOT_PASSED.partition("    def test_good")[0] + "".join(
        re.findall(rf".*\n    def test_{kind}.*\n", NOT_PASSED)
    )
    result = inner(only, require_all="1")
    assert result.ret == 1
    result.stdout.fnmatch_lines([f"BEZTEACH_REQUIRE_ALL: not passed but *::test_{kind}"])


def test_elsewhere_it_is_none(inner):
    result = inner(NOT_PASSED, require_all="")
    assert result.ret == 0
    result.assert_outcomes(passed=1, skipped=1, xfailed=1, xpassed=1)
    result.stdout.no_fnmatch_line("BEZTEACH_REQUIRE_ALL*")


def test_in_ci_passing_tests_pass(inner):
    assert inner("def test_good(): pass", require_all="1").ret == 0


def test_ci_script_is_bash_and_executable():
    script = ROOT / ".ci" / "run"
    assert os.access(script, os.X_OK)
    subprocess.run(["bash", "-n", script], check=True)


# --- bezteach lab


@contextlib.contextmanager
def running(lessons, *arguments):
    """The lab as a process, in another folder than the checkout; yields it, its address, and the lines before that."""
    process = subprocess.Popen(
        [sys.executable, "-m", "bezteach", "lab", "--no-browser", *arguments],
        cwd=lessons.parents[1],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    with process:
        try:
            said = []
            for line in process.stdout:
                said.append(line)
                if address := re.search(r"http://\S+", line):
                    break
            else:
                pytest.fail(process.communicate()[1])
            yield process, address[0], said
        finally:
            if process.poll() is None:
                process.terminate()
                process.communicate(timeout=60)


def get(address, path=None):
    """Fetch a page of the server; return (status, text)."""
    host, rest, token = re.fullmatch(r"http://([^/]+)(/.*)\?token=(\w+)", address).groups()
    connection = http.client.HTTPConnection(host, timeout=60)
    try:
        connection.request("GET", path or rest, headers={"Authorization": f"token {token}"})
        response = connection.getresponse()
        return response.status, response.read().decode()
    finally:
        connection.close()


def start_kernel(address):
    """Start a kernel on the server, as an opened notebook does, and wait until it is there."""
    host, token = re.fullmatch(r"http://([^/]+)/.*\?token=(\w+)", address).groups()
    connection = http.client.HTTPConnection(host, timeout=60)
    try:
        connection.request("POST", "/api/kernels", '{"name": "python3"}', {"Authorization": f"token {token}"})
        return json.loads(connection.getresponse().read())["id"]
    finally:
        connection.close()


def words_of(process):
    """The command line of a process; none of one that ended a moment ago, also if nobody has asked for its end yet."""
    try:
        return process.cmdline()
    except psutil.NoSuchProcess:
        return []


def test_lab_serves_the_lessons_until_ctrl_c(lessons, home):
    with running(lessons) as (process, address, said):
        folder = home / "bezteach-lessons"
        assert said[0] == f"bezteach: your lessons are in {folder} (1 copied)\n"
        assert "/lab/tree/00-start.ipynb?token=" in address
        status, page = get(address)
        assert status == 200 and "JupyterLab" in page
        # No question about news stands before the lesson, and none are fetched.
        status, text = get(address, "/lab/api/settings/@jupyterlab/apputils-extension:notification")
        defaults = {key: value["default"] for key, value in json.loads(text)["schema"]["properties"].items()}
        assert (defaults["fetchNews"], defaults["checkForUpdates"]) == ("false", False)
        status, text = get(address, "/api/contents/00-start.ipynb?content=1")
        assert status == 200
        assert get(re.sub(r"\w+$", "wrong", address), "/api/contents")[0] == 403
        start_kernel(address)
        family = psutil.Process(process.pid).children(recursive=True)
        lines = [line for member in family if (line := words_of(member))]
        assert len(lines) >= 2
        # The token is on no command line: those are shown to every user of the machine.
        token = address.rpartition("=")[2]
        assert not any(token in word for line in lines for word in line)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out, err) == (0, f"bezteach: ended; your work is in {folder}\n", "")
    assert psutil.wait_procs(family, timeout=30)[1] == []


def test_sigterm_ends_the_lab_too(lessons, home):
    with running(lessons, "--dir", "work here", "--port", "0") as (process, address, said):
        family = psutil.Process(process.pid).children(recursive=True)
        assert get(address)[0] == 200
        process.terminate()
        out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (128 + signal.SIGTERM, "")
    assert out == f"bezteach: ended; your work is in {home / 'work here'}\n"
    assert psutil.wait_procs(family, timeout=30)[1] == []


def test_kernels_import_this_bezteach(lessons):
    """They run in the user's folder, with the lab's interpreter and with the checkout first on their path."""
    with running(lessons, "--dir", "work") as (process, address, said):
        start_kernel(address)
        kernels = []
        for _ in range(100):
            children = psutil.Process(process.pid).children(recursive=True)
            kernels = [child for child in children if any("ipykernel" in word for word in words_of(child))]
            if kernels:
                break
            time.sleep(0.1)
        setting = kernels[0].environ()
        assert setting["PYTHONPATH"].split(os.pathsep)[0] == str(lessons.parent)
        assert os.path.samefile(kernels[0].exe(), sys.executable)
        assert kernels[0].cwd() == str(lessons.parents[1] / "work")


def test_lab_that_cannot_start_says_why(lessons, home, monkeypatch):
    (home / "jupyterlab.py").write_text("import sys; sys.exit('ERROR: odd thing')", encoding="utf-8")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(lessons.parent), str(home)]))
    done = run("lab", "--no-browser")
    assert one_line(done, "JupyterLab did not start: odd thing")


def test_home_that_cannot_be_written(lessons, home, monkeypatch):
    (home / "file").touch()
    monkeypatch.setenv("HOME", str(home / "file" / "x"))
    monkeypatch.setenv("USERPROFILE", str(home / "file" / "x"))
    assert one_line(run("lab", "--no-browser", cwd=home), "is not a folder", "--dir")
    assert one_line(run("lab", "--no-browser", "--dir", "work", cwd=home), "set HOME")


def test_port_in_use(lessons, home):
    with socket.socket() as server:
        server.bind(("127.0.0.1", 0))
        server.listen()
        port = server.getsockname()[1]
        assert one_line(run("lab", "--no-browser", "--port", str(port)), f"port {port} is in use: choose another")
    assert not (home / "bezteach-lessons").exists()


def test_folder_that_cannot_be(lessons, home):
    (home / "file").touch()
    assert one_line(run("lab", "--no-browser", "--dir", "file"), "is not a folder")
    assert one_line(run("lab", "--no-browser", "--dir", "file/x"), "is not a folder")
    assert one_line(run("lab", "--no-browser", "--dir", str(lessons)), "belongs to the project")
