"""What the tests of the lessons share: pytest run apart."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from bezteach import lessons


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
