"""Two runs in one checkout."""

import os

import pytest
from setup_clone import PIP_GOOD, begin, stand_in


@pytest.mark.skipif(os.name != "posix", reason="the stand-in .venv is made of links")
def test_two_at_once_wait_for_each_other(clone):
    stand_in(clone.parent, pip="import time; time.sleep(1.5)\n" + PIP_GOOD)
    with begin(clone, "setting up") as one, begin(clone, "waiting for another") as two:
        outputs = [one.communicate(timeout=120)[0], two.communicate(timeout=120)[0]]
    assert [one.returncode, two.returncode] == [5, 5]
    assert "set up after" in outputs[0]
    assert [line.split()[0] for line in outputs[1].splitlines()] == ["pytest"]
