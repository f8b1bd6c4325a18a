"""The provers are tried alone: what is false far away must not be PROVED, also where the refuter does not see it."""

import pytest

from bezteach.proof.exact import refuter


@pytest.fixture(autouse=True)
def walks_only(monkeypatch):
    """The refuter walks from the smallest points on, and does not look where a divisor vanishes."""
    monkeypatch.setattr(refuter, "roots", lambda statement, walked, budget: ())
