"""Chromium, and the windows in which tests open pages. On a machine without it, the tests that need it are skipped."""

import contextlib

import pytest
from browser_chromium import chromium_path, launched

pytest.register_assert_rewrite("browser_screen")  # so that its assertions say what they compared


# Playwright's own event loop counts as running in its thread as long as it is open: other files' tests, which may come
# in the same process, must not see it.
@pytest.fixture(scope="module")
def chromium():
    """The browser, started once for a file of tests."""
    if not chromium_path():
        pytest.skip("there is no Chromium on this machine")
    with launched() as browser:
        yield browser


class Window:
    """A page that may only load what begins with ``allowed``; it collects errors and requests for anything else.

    Requests whose address has ``stubbed``, a pattern, are answered with nothing.
    """

    def __init__(self, context, allowed, stubbed):
        self._complaints = []
        self._allowed, self._stubbed = (*allowed, "data:", "blob:"), stubbed
        if stubbed:
            context.route(stubbed, lambda route: route.fulfill(body=""))
        context.set_default_timeout(20_000)
        context.on("console", lambda told: told.type == "error" and self._complaints.append(told.text))
        context.on("weberror", lambda told: self._complaints.append(str(told.error)))
        context.on("request", self._look_at)
        self.page = context.new_page()

    def _look_at(self, request):
        if not request.url.startswith(self._allowed) and not (self._stubbed and self._stubbed.search(request.url)):
            self._complaints.append(f"asks for {request.url}")

    def complaints(self):
        """What was wrong since the last time, to be compared with []."""
        found, self._complaints = self._complaints, []
        return found


@pytest.fixture(scope="module")
def window(chromium):
    """A function that opens a window, a context manager; whatever is wrong in it at the end fails the test."""

    @contextlib.contextmanager
    def opened(*allowed, offline=False, stubbed=None, **options):
        with contextlib.closing(chromium.new_context(**options)) as context:
            context.set_offline(offline)
            window = Window(context, allowed, stubbed)
            yield window
            assert window.complaints() == []

    return opened
