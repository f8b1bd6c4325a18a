"""How JupyterLab is started; that it runs and ends is in test_cli.py."""

import socket
import sys
from pathlib import Path

import pytest

from bezteach.setup import lab
from bezteach.setup.progress import Problem


def test_port_in_use_is_a_problem_and_another_is_free():
    with socket.socket() as server:
        server.bind((lab.HOST, 0))
        server.listen()
        port = server.getsockname()[1]
        with pytest.raises(Problem, match=f"port {port} is in use"):
            lab.free_port(port)
        assert lab.free_port() != port != lab.free_port(0)
    assert lab.free_port(port) == port


def test_page_to_open(tmp_path):
    assert lab.start_page(tmp_path) == "/lab"
    (tmp_path / "00-start.ipynb").touch()
    assert lab.start_page(tmp_path) == "/lab/tree/00-start.ipynb"


@pytest.mark.parametrize(("browser", "root_user"), [(True, False), (False, True)])
def test_command_of_jupyterlab(browser, root_user):
    options = lab.command(Path("/my folder"), 8888, "/lab", browser, root_user)
    assert options[:3] == [sys.executable, "-m", "jupyterlab"]
    assert {"--ServerApp.root_dir=/my folder", "--ServerApp.port=8888", "--ServerApp.port_retries=0"} <= set(options)
    assert ("--no-browser" in options) is not browser
    assert ("--allow-root" in options) is root_user
