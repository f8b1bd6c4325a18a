"""What is needed, read from the declarations, and what of it the interpreter lacks."""

import importlib.metadata
import tomllib

import pytest

from bezteach.setup import requirements
from bezteach.setup.progress import Problem

ROOT = requirements.PACKAGE.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_every_declared_requirement_is_understood():
    for group in requirements.declared(ROOT).values():
        for requirement in group:
            requirements.split_requirement(requirement)


@pytest.mark.parametrize("text", ["x~=1.0", "x==1.*", "x>=1; python_version<'3.12'", "x @ file:///x", ""])
def test_requirement_of_another_kind_is_refused(text):
    with pytest.raises(ValueError, match="cannot read"):
        requirements.split_requirement(text)


@pytest.mark.parametrize(
    ("version", "pairs", "expected"),
    [
        ("3.10.0", [(">=", "3.9")], True),  # numbers, not text
        ("3.9", [(">=", "3.10")], False),
        ("2", [("==", "2.0.0")], True),
        ("3.11.2", [("==", "3.11.2")], True),
        ("3.11.20", [("==", "3.11.2")], False),
        ("2.5", [(">=", "2"), ("<", "3")], True),
        ("3.0", [(">=", "2"), ("<", "3")], False),
        ("2.0rc1", [(">=", "2.0")], True),
        ("1.2.post1+local", [("<=", "1.2"), ("!=", "1.3"), (">", "1.1")], True),
        ("0", [], True),
    ],
)
def test_versions_are_compared_number_by_number(version, pairs, expected):
    assert requirements.satisfies(version, pairs) is expected


def test_an_extra_brings_what_it_refers_to():
    names = {requirements.split_requirement(text)[0] for text in requirements.requirements("test", ROOT)}
    assert {"numpy", "jupyterlab", "ipykernel", "pytest"} <= names
    assert "bezteach" not in names


def test_extras_that_refer_to_each_other_end(monkeypatch):
    groups = {"": ["x"], "a": ["bezteach[b]", "y"], "b": ["bezteach[a]", "x", "z"]}
    monkeypatch.setattr(requirements, "declared", lambda root: groups)
    assert requirements.requirements("a", None) == ["x", "y", "z"]
    with pytest.raises(ValueError, match="no extra 'c'"):
        requirements.requirements("c", None)


def test_installed_metadata_say_the_same_as_pyproject(monkeypatch):
    lines = [*PROJECT["dependencies"]]
    for extra, group in PROJECT["optional-dependencies"].items():
        lines += [f"{requirement}; extra == '{extra}'" for requirement in group]
    monkeypatch.setattr(importlib.metadata, "requires", lambda name: lines)
    assert requirements.declared(None) == requirements.declared(ROOT)


def test_metadata_missing_is_an_incomplete_copy(monkeypatch):
    def requires(name):
        raise importlib.metadata.PackageNotFoundError

    monkeypatch.setattr(importlib.metadata, "requires", requires)
    with pytest.raises(Problem, match="pip install"):
        requirements.declared(None)


def test_lacking_names_what_is_absent_too_old_or_broken(monkeypatch):
    installed = {"good": "2.0", "old": "1.9", "broken": None}
    asked = ["good>=2", "old>=2", "broken", "absent"]
    monkeypatch.setattr(requirements, "declared", lambda root: {"": asked, "x": []})

    def version(name):
        if name not in installed:
            raise importlib.metadata.PackageNotFoundError
        return installed[name]

    monkeypatch.setattr(importlib.metadata, "version", version)
    assert requirements.lacking("x", ROOT) == ["old>=2", "broken", "absent"]


def test_checkout_is_told_from_an_installed_package(tmp_path):
    package = tmp_path / "bezteach"
    assert requirements.checkout(package) is None
    for text, expected in (("[project]\nname='other'", None), ("[project]\nname='bezteach'", tmp_path)):
        (tmp_path / "pyproject.toml").write_text(text, encoding="utf-8")
        assert requirements.checkout(package) == expected
    (tmp_path / "pyproject.toml").write_text("<<<<<<< HEAD", encoding="utf-8")
    with pytest.raises(Problem, match="cannot read"):
        requirements.checkout(package)
