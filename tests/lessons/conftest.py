"""What the tests of the lessons share: lessons executed once a session, and pytest run apart."""

import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from bezteach import lessons


@pytest.fixture(scope="session")
def afresh():
    """The function from a lesson's path to the lesson executed now, as the kernel gave it, not normalised."""

    @cache
    def run(path: Path):
        return lessons.executed(lessons.parsed(path.read_text(encoding="utf-8")), path.parent)

    return run


@pytest.fixture(scope="session")
def nested_run():
    """The function from a folder and arguments to what a pytest of its own, run in that folder, prints."""
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--color=no"]
    command += ["-p", "no:hypothesispytest"]  # takes two seconds to load, and no notebook needs it
    env = os.environ | {"PYTHONPATH": os.pathsep.join([str(lessons.ROOT), os.environ.get("PYTHONPATH", "")])}

    def run(folder: Path, *arguments):
        if folder != lessons.ROOT:  # else pytest looks for a configuration in the folders above
            (folder / "pytest.ini").write_text("[pytest]\n")
        whole = [*command, *arguments]
        return subprocess.run(whole, cwd=folder, env=env, capture_output=True, text=True, check=False).stdout

    return run
