"""What the user reads while pip works and when it fails: few lines, and never more than one for a reason."""

import io
from collections import namedtuple

import pytest

from bezteach.setup import progress

PIP = """\
Looking in indexes: x
Obtaining file:///clone
  Installing build dependencies: started
Collecting numpy>=2.0 (from bezteach==0.1.0)
  Downloading numpy-2.3.1-cp311-cp311-linux.whl (16 MB)
Collecting ipywidgets>=8.1
Building wheels for collected packages: bezteach
Installing collected packages: numpy, ipywidgets, bezteach
Successfully installed numpy-2.3.1
""".splitlines()


class Terminal(io.StringIO):
    def isatty(self):
        return True


def told(stream):
    tell = progress.teller(stream, clock=lambda: 0.0)
    for line in PIP:
        if news := progress.news(line):
            tell(*news)
    tell(None)
    return stream.getvalue()


def test_pips_many_lines_become_a_few():
    assert told(io.StringIO()).splitlines() == [
        "bezteach: preparing",
        "bezteach: collecting packages",
        "bezteach: installing 3 packages",
    ]


def test_on_a_terminal_one_line_is_kept_up_to_date_and_cleared(monkeypatch):
    monkeypatch.setenv("COLUMNS", "50")
    text = told(Terminal())
    assert "\n" not in text
    shown = [part.rstrip() for part in text.split("\r") if part.strip()]
    assert shown[-1] == "[  0 s] installing 3 packages: numpy, ipywidge..."
    assert "[  0 s] collecting packages: numpy" in shown
    assert max(map(len, shown)) < 50
    assert text.endswith("\r" + " " * 49 + "\r")


@pytest.mark.parametrize(
    ("output", "expected"),
    [
        (
            "WARNING: Retrying ... NewConnectionError(...)\nERROR: No matching distribution found for hatchling",
            "network",
        ),
        ("ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device", "full"),
        ("/x/.venv/bin/python: No module named pip", "no pip"),
        ("ERROR: Could not install: [Errno 13] Permission denied: '/x'", "permission"),
        (
            "ERROR: first\nnote: this is\nERROR: No matching distribution found for x==9\n\n[notice] new pip",
            "found for x==9",
        ),
        ("Traceback\nValueError: odd", "ValueError: odd"),
        ("", "no reason was given"),
    ],
)
def test_reason_is_one_line(output, expected):
    reason = progress.reason(output.splitlines())
    assert expected in reason and "\n" not in reason and "ERROR" not in reason


def test_full_disk_is_the_reason_even_if_nobody_says_so(monkeypatch, tmp_path):
    usage = namedtuple("usage", "total used free")
    monkeypatch.setattr(progress.shutil, "disk_usage", lambda folder: usage(1e12, 1e12, 1e6))
    assert "full" in progress.reason(["Segmentation fault"], tmp_path)
    assert progress.reason(["Segmentation fault"]) == "Segmentation fault"
