"""Entry of the interpreter that runs pytest, so that a Ctrl-C while pytest loads is one line too."""

import sys

from bezteach.setup.processes import let_through


def main(arguments):
    """Run pytest with these arguments and return its exit code."""
    try:
        let_through()
        import pytest
    except KeyboardInterrupt:
        print("bezteach: stopped", file=sys.stderr)
        return 130
    return pytest.main(arguments)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
