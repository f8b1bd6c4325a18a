"""Runs JupyterLab in the user's folder: quiet, on a port known beforehand, ended by one Ctrl-C.

Standard library only: JupyterLab is a child process, and what we say about it we learn over HTTP.
"""

import contextlib
import errno
import http.client
import os
import secrets
import socket
import subprocess
import sys
import tempfile
import time
import urllib.parse
from pathlib import Path

from bezteach.setup.processes import child_environment, end, held_back, start
from bezteach.setup.progress import Problem, reason, say
from bezteach.setup.requirements import checkout

HOST = "127.0.0.1"
FIRST_LESSON = "00-start.ipynb"


def free_port(port=None):
    """Return the port if it is free; for 0 any free one; for None the first free one from 8888 on.

    Raises Problem if the port cannot be had.
    """
    if port is None:
        for candidate in range(8888, 8938):
            with contextlib.suppress(Problem):
                return free_port(candidate)
        port = 0
    with socket.socket() as probe:
        if os.name == "posix":
            # As the server does it: a port that was in use a moment ago is free. (On Windows it means another thing.)
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((HOST, port))
            return probe.getsockname()[1]
        except OSError as error:
            if error.errno == errno.EACCES:
                raise Problem(f"port {port} is reserved by the system: choose one from 1024 on") from None
            raise Problem(f"port {port} is in use: choose another, or leave --port out") from None


def start_page(folder):
    """Return the page to open: the first lesson if it is there, else the folder."""
    return "/lab/tree/" + urllib.parse.quote(FIRST_LESSON) if (folder / FIRST_LESSON).is_file() else "/lab"


def command(folder, port, page, browser, root_user=False):
    """Return the command that starts JupyterLab."""
    options = [
        f"--ServerApp.root_dir={folder}",
        f"--ServerApp.ip={HOST}",
        f"--ServerApp.port={port}",
        "--ServerApp.port_retries=0",
        # A user's own server may have these set otherwise; our address counts on them.
        "--ServerApp.base_url=/",
        "--ServerApp.certfile=",
        "--ServerApp.keyfile=",
        f"--LabApp.default_url={page}",
        "--Application.log_level=CRITICAL",
    ]
    if not browser:
        options.append("--no-browser")
    if root_user:
        options.append("--allow-root")
    return [sys.executable, "-m", "jupyterlab", *options]


def serve(folder, port, browser):
    """Run JupyterLab in the folder until Ctrl-C and return the exit code. Raises Problem if it does not come up."""
    # The token goes by the environment: command lines are shown to every user of the machine.
    token = secrets.token_hex(24)
    environment = child_environment(checkout())
    environment["JUPYTER_TOKEN"] = token
    # No question about news before the lesson, and nothing fetched; the user's own settings still have the last word.
    paths = [str(Path(__file__).resolve().parent), environment.get("JUPYTER_CONFIG_PATH", "")]
    environment["JUPYTER_CONFIG_PATH"] = os.pathsep.join(filter(None, paths))
    # Else a kernel of the same name that the user once installed for another Python would be taken.
    environment["JUPYTER_PREFER_ENV_PATH"] = "1"
    root_user = hasattr(os, "geteuid") and os.geteuid() == 0
    page = start_page(folder)
    server, came_up = None, False
    say("starting JupyterLab")
    # JupyterLab's own words are kept, to find the reason in them if it fails.
    with tempfile.TemporaryFile() as log:
        try:
            with held_back():
                server = start(
                    command(folder, port, page, browser, root_user),
                    cwd=folder,
                    env=environment,
                    stdout=log,
                    stderr=subprocess.STDOUT,
                )
            _wait_until_up(server, port, token)
            came_up = True
            say(
                f"JupyterLab runs; Ctrl-C here ends it. {'If no page opens' if browser else 'Open'}: "
                f"http://{HOST}:{port}{page}?token={token}"
            )
            # Not wait(): on Windows Ctrl-C does not reach through it.
            while server.poll() is None:
                time.sleep(0.2)
            # Code 0: ended from the page itself (File > Shut Down).
            if server.returncode:
                raise Problem(f"JupyterLab ended unexpectedly: {_reason(log)}")
            return 0
        except ChildProcessError:
            raise Problem(f"JupyterLab did not start: {_reason(log)}") from None
        except KeyboardInterrupt:
            if not came_up:
                raise
            return 0
        finally:
            if server is not None:
                with held_back():
                    end(server)
            if came_up:
                say(f"ended; your work is in {folder}")


def _wait_until_up(server, port, token, patience=180.0):
    """Wait until our server answers to our token.

    Raises ChildProcessError if it ends before that, Problem if it is stuck.
    """
    give_up = time.monotonic() + patience
    while time.monotonic() < give_up:
        if server.poll() is not None:
            raise ChildProcessError
        # Not urllib: that would ask a proxy for an address of this machine.
        connection = http.client.HTTPConnection(HOST, port, timeout=10)
        try:
            connection.request("GET", "/api/status", headers={"Authorization": f"token {token}"})
            if connection.getresponse().status == 200:
                return
        except (OSError, http.client.HTTPException):
            pass
        finally:
            connection.close()
        time.sleep(0.1)
    raise Problem(f"JupyterLab does not answer after {patience:.0f} s: run the command again, or with another --port")


def _reason(log):
    with contextlib.suppress(RuntimeError):
        if not os.access(Path.home(), os.W_OK):
            return "it needs a home folder that it can write in: set HOME to one"
    log.seek(0)
    return reason(log.read().decode(errors="replace").splitlines())
