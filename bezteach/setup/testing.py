"""Entry of the interpreter that runs pytest: on all cores, and with Ctrl-C dealt with from its first moment on."""

import sys

from bezteach.setup.processes import let_through

# The tests of a file, and the cells of a notebook, stay together and in order; "-n0" behind them switches it off.
# Files stay in order too: those with few tests, which are the slow ones, would else come last, on one core.
ON_ALL_CORES = ["-n", "auto", "--dist", "loadfile", "--no-loadscope-reorder"]


def main(arguments):
    """Run pytest with these arguments and return its exit code."""
    import pytest

    class Running:
        @pytest.hookimpl(tryfirst=True)
        def pytest_sessionstart(self):
            let_through()  # before this, pytest would answer with a traceback

    return pytest.main([*ON_ALL_CORES, *arguments], plugins=[Running()])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
