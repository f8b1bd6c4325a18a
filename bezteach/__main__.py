"""Entry of ``python3 -m bezteach`` and of the console script: looks at Python's version, then hands over.

Only this file and ``bezteach/__init__.py`` have to be readable for an old Python (3.6 and later), so that a newcomer
reads one line instead of a syntax error from the middle of the package.
"""

import sys

NEEDED = (3, 11)


def too_old(version):
    """Say in one line that this version is too old, or return the empty string.

    >>> too_old((3, 13, 0))
    ''
    >>> too_old((3, 6, 15))
    'bezteach needs Python 3.11 or newer, and this is Python 3.6.15: install a newer one from python.org'
    """
    if tuple(version[:2]) >= NEEDED:
        return ""
    return "bezteach needs Python {}.{} or newer, and this is Python {}.{}.{}: {}".format(
        *NEEDED, *version[:3], "install a newer one from python.org"
    )


def main():
    """Run the command line; returns the exit code."""
    message = too_old(sys.version_info)
    if message:
        sys.stderr.write(message + "\n")
        return 1
    try:
        from bezteach.cli import main as run

        return run()
    except KeyboardInterrupt:
        # Only what comes before or after the command line's own handling ends up here.
        sys.stderr.write("bezteach: stopped\n")
        return 130


if __name__ == "__main__":
    sys.exit(main())
