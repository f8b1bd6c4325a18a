"""The checkout that the tests of the set-up set up."""

import shutil

import pytest
from setup_clone import PIP_GOOD, PYTEST, VENV, stand_in

from bezteach.setup.requirements import PACKAGE


@pytest.fixture
def clone(tmp_path):
    """A checkout whose name is hard to handle, with a requirement that is nowhere installed, and the stand-ins."""
    root = tmp_path / "Bézier 曲线, a 'copy'"
    root.mkdir()
    shutil.copytree(PACKAGE, root / "bezteach", ignore=shutil.ignore_patterns("__pycache__"))
    (root / "pyproject.toml").write_text(
        '[project]\nname = "bezteach"\n[project.optional-dependencies]\ntest = ["absent>=1"]\n', encoding="utf-8"
    )
    stand_in(tmp_path, venv=VENV, pip=PIP_GOOD, pytest=PYTEST, ensurepip="")
    return root
