"""What holds for every test: a cell of a lesson gives all that is stored, and in CI nothing is skipped.

nbval compares no PNG and no cell without an execution count; what a cell gave it is compared here once more, whole.
With BEZTEACH_REQUIRE_ALL set, as in CI, a test that did not simply pass makes the run fail: a skipped test proves
nothing, and on a machine that has everything there is no reason to skip one.
"""

import copy
import os

import pytest
from hypothesis import HealthCheck, settings

# How fast a machine is, is the benchmark's business. The parent is what Hypothesis takes here, another one in CI.
settings.register_profile("bezteach", parent=settings(), deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("bezteach")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    result = yield
    if item.path.suffix == ".ipynb":
        _compare(item)
    return result


def _compare(item):
    """Fail where what nbval's cell gave is not what is stored, or a widget has no words."""
    from bezteach.lessons import difference, normalised_outputs, wordless  # only where there are notebooks

    assert not (poor := wordless(item.test_outputs)), f"a widget says no more in words than its traits: {poor}"
    given = copy.copy(item.cell)
    given.outputs = normalised_outputs(copy.deepcopy(item.test_outputs), item.cell.execution_count)
    assert not (lines := difference(item.cell, given)), f"run python -m bezteach.lessons: {lines}"


def _not_passed(config):
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if not os.environ.get("BEZTEACH_REQUIRE_ALL") or reporter is None:
        return []
    return [report for kind in ("skipped", "xfailed", "xpassed") for report in reporter.stats.get(kind, [])]


def pytest_sessionfinish(session, exitstatus):
    """Turn success into failure. Exit codes of their own (interrupted, no tests) stay as they are."""
    if exitstatus == 0 and _not_passed(session.config):
        session.exitstatus = 1


def pytest_terminal_summary(terminalreporter, exitstatus, config):
    """Say which tests it was."""
    for report in _not_passed(config):
        terminalreporter.write_line(f"BEZTEACH_REQUIRE_ALL: not passed but {report.outcome}: {report.nodeid}", red=True)
