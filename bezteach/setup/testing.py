"""Entry of the interpreter that runs pytest: on all cores, and a Ctrl-C while it loads is one line too."""

import sys

from bezteach.setup.processes import let_through

# The tests of a file, and the cells of a notebook, stay together and in order; "-n0" behind them switches it off.
ON_ALL_CORES = ["-n", "auto", "--dist", "loadfile"]


def main(arguments):
    """Run pytest with these arguments and return its exit code."""
    try:
        let_through()
        import pytest
    except KeyboardInterrupt:
        print("bezteach: stopped", file=sys.stderr)
        return 130
    return pytest.main([*ON_ALL_CORES, *arguments])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
