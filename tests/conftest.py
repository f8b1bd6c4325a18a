"""With BEZTEACH_REQUIRE_ALL set, as in CI, a test that did not simply pass makes the run fail.

A skipped test proves nothing, and on a machine that has everything there is no reason to skip one.
"""

import os


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
