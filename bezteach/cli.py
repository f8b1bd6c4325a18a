"""The command line: ``python3 -m bezteach COMMAND`` and ``bezteach COMMAND``.

A command is a function of the parsed arguments that returns the exit code, entered in ``COMMANDS`` beside its help
and the function that declares its arguments. What a user can put right is a ``Problem``: one line, exit code 1.
"""

import argparse
import contextlib
import os
import signal
import sys
import threading
from pathlib import Path
from typing import NamedTuple

from bezteach import __version__
from bezteach.setup import lab, processes, requirements, signing, virtualenv, workspace
from bezteach.setup.progress import Problem, say


class Command(NamedTuple):
    """One command: what it does, the function that runs it, and the one that declares its arguments.

    Without the latter, everything behind the command's name is handed on unread, as ``arguments.rest``.
    """

    help: str
    run: object
    declare: object = None


def lab_arguments(parser):
    """Declare what ``lab`` understands."""
    parser.add_argument(
        "--dir",
        type=_path,
        metavar="DIR",
        help="the folder to work in (default: bezteach-lessons in your home)",
    )
    parser.add_argument("--no-browser", action="store_true", help="print the address instead of opening it")
    parser.add_argument("--port", type=_port, metavar="N", help="the port to serve on (default: a free one from 8888)")


def run_lab(arguments):
    """Set up, copy the lessons, run JupyterLab in their folder until it is ended."""
    source = workspace.lessons_source()
    target = workspace.folder(arguments.dir)
    # What cannot work shows now, not after a minute of installing.
    workspace.plan(source, target)
    port = lab.free_port(arguments.port)
    virtualenv.ready("lab", arguments.all)
    report = workspace.copy_lessons(source, target)
    for line in workspace.summary(report, target):
        say(line)
    if failure := signing.sign(workspace.written(report, target)):
        say(f"could not sign the lessons ({failure}): pictures may show only after running a cell")
    return lab.serve(target, port, browser=not arguments.no_browser)


def run_test(arguments):
    """Set up, then run pytest in the checkout; its output and its exit code as they come."""
    root = requirements.checkout()
    if root is None:
        raise Problem("the tests come with a checkout of the project, and this is an installed package: clone it")
    virtualenv.ready("test", arguments.all)
    command = [sys.executable, "-m", "bezteach.setup.testing", *arguments.rest]
    return processes.attend(command, processes.child_environment(root), root)


def prove_arguments(parser):
    """Declare what ``prove`` understands."""
    parser.add_argument("pattern", nargs="?", metavar="PATTERN", help="a part of the claims' ids, or with wildcards *")
    parser.add_argument("--source", choices=SOURCES, help="only what this source states, in its order")
    parser.add_argument("--steps", action="store_true", help="show each proof, line by line")
    parser.add_argument("--json", action="store_true", help="print a list of objects")
    parser.add_argument("--statement", metavar="TEXT", help='judge this: "sum(B(i,n,t), i, 0, n) = 1"')
    parser.add_argument("--given", metavar="TEXT", help='where its letters range: "n >= 1, 0 <= t <= 1"')


def run_prove(arguments):
    """Set up what is lacking, then judge the claims of the ledger or a statement."""
    virtualenv.ready("", arguments.all)
    from bezteach.proving import run_prove

    return run_prove(arguments)


def errata_arguments(parser):
    """Declare what ``errata`` understands."""
    parser.add_argument("--json", action="store_true", help="print a list of objects")


def run_errata(arguments):
    """Set up what is lacking, then print what the sources get wrong."""
    virtualenv.ready("", arguments.all)
    from bezteach.proving import run_errata

    return run_errata(arguments)


def export_arguments(parser):
    """Declare what ``export`` understands."""
    parser.add_argument("file", type=_path, metavar="FILE.html", help="where the page goes")
    parser.add_argument(
        "--example",
        default="deck/split",
        metavar="NAME",
        help="the example that it starts from (default: deck/split)",
    )
    parser.add_argument("--force", action="store_true", help="overwrite a file that is there")


def run_export(arguments):
    """Set up what is lacking, then write a board as a page of its own."""
    virtualenv.ready("", arguments.all)
    from bezteach.exporting import run_export

    return run_export(arguments)


def grade_arguments(parser):
    """Declare what ``grade`` understands."""
    parser.add_argument("paths", nargs="+", type=_path, metavar="PATH", help="notebooks, or folders with notebooks")
    parser.add_argument("--csv", type=_path, metavar="FILE", help="write the table there, for a spreadsheet")
    parser.add_argument("--jobs", type=_count, metavar="N", help="so many notebooks at a time (default: one a core)")


def run_grade(arguments):
    """Set up what is lacking, then grade homework, of which nothing is run."""
    virtualenv.ready("", arguments.all)
    from bezteach.grading import run_grade

    return run_grade(arguments)


def homework_arguments(parser):
    """Declare what ``homework`` understands."""
    parser.add_argument("folder", nargs="?", type=_path, metavar="DIR", help="where the blank notebooks go")
    parser.add_argument("--name", metavar="NAME", help="with numbers of this student's own (default: the book's)")
    parser.add_argument("--key", metavar="SET", help="print the teacher's answers to a set instead")


def run_homework(arguments):
    """Set up what is lacking, then write blank homework, or print the answers to it."""
    virtualenv.ready("", arguments.all)
    from bezteach.handing_out import run_homework

    return run_homework(arguments)


SOURCES = ("deck", "games", "notes", "transcript")
COMMANDS = {
    "lab": Command("set up, and open the lessons in JupyterLab", run_lab, lab_arguments),
    "test": Command("set up, and run every test (arguments are pytest's)", run_test),
    "prove": Command("prove the formulas of the course, or one of your own", run_prove, prove_arguments),
    "errata": Command("what the sources print wrongly, with counterexamples", run_errata, errata_arguments),
    "export": Command("write a draggable board as one page that needs no Python", run_export, export_arguments),
    "homework": Command("write blank homework, or print the teacher's answers", run_homework, homework_arguments),
    "grade": Command("grade students' notebooks, of which nothing is run", run_grade, grade_arguments),
}


def _path(text):
    if not text.strip():
        raise argparse.ArgumentTypeError("the name is empty")
    return Path(text)


def _count(text):
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= 64):
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 1 to 64")
    return int(text)


def _port(text):
    if not (text.isascii() and text.isdigit() and int(text) <= 65535):
        raise argparse.ArgumentTypeError(f"{text!r} is no port: take a number from 1024 to 65535, or 0 for any free")
    return int(text)


def parser():
    """Return the parser of the whole command line."""
    result = argparse.ArgumentParser(
        prog="bezteach", description="Bézier curves, taught with exact numbers and draggable pictures."
    )
    result.add_argument("--version", action="version", version=f"bezteach {__version__}")
    commands = result.add_subparsers(dest="command", metavar="COMMAND")
    for name, command in COMMANDS.items():
        sub = commands.add_parser(name, help=command.help, description=command.help, add_help=bool(command.declare))
        if command.declare:
            command.declare(sub)
    return result


def parse(argv):
    """Parse the command line; ``all`` of the result is the line itself. Exits as argparse does if it is wrong."""
    command = COMMANDS.get(argv[0]) if argv else None
    # argparse would take -h and -k for its own, so it does not see what is handed on.
    handed_on = command is not None and command.declare is None
    arguments = parser().parse_args(argv[:1] if handed_on else argv)
    arguments.rest = argv[1:] if handed_on else []
    arguments.all = argv
    return arguments


def main(argv=None):
    """Run a command line (the process's own if none is given) and return its exit code."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            # A folder's name may hold letters that the terminal does not know.
            stream.reconfigure(errors="backslashreplace")
    arguments = parse(sys.argv[1:] if argv is None else list(argv))
    if arguments.command is None:
        parser().print_help()
        return 0
    try:
        with _orderly_end():
            processes.let_through()
            return COMMANDS[arguments.command].run(arguments)
    except (Problem, OSError) as problem:
        # An OSError that nobody foresaw is still about the user's machine, and its text says what and where.
        print(f"bezteach: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("bezteach: stopped", file=sys.stderr)
        return 130


@contextlib.contextmanager
def _orderly_end():
    """Make SIGTERM, and SIGHUP of a closed terminal, an exception like Ctrl-C, so that everything is put in order."""

    def leave(number, frame):
        sys.exit(128 + number)

    before = {}
    if os.name == "posix" and threading.current_thread() is threading.main_thread():
        for number in (signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) == signal.SIG_DFL:
                before[number] = signal.signal(number, leave)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
