"""``bezteach grade``: verdicts on the homework of many students, from the syntax trees of their notebooks."""

import csv
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from io import StringIO
from pathlib import Path
from typing import NamedTuple

from bezteach.setup.progress import Problem, say, teller
from bezteach.setup.writing import write

from .homework.kinds import judged
from .homework.sets import QUESTIONS, SETS, data_of
from .homework.student import student_of
from .homework.submission import LARGEST, NotRead, submission
from .homework.verdict import INVALID, UNATTEMPTED, Verdict

UNREAD = "UNREAD"  # a file that is no notebook
SUFFIX = ".ipynb"


class Grade(NamedTuple):
    """One line of the result."""

    file: str
    student: str
    question: str
    status: str
    note: str


def graded(path):
    """The ``Grade`` of each question of the sets that a notebook has answers to; one line if it cannot be read."""
    path = Path(path)
    try:
        if path.stat().st_size > LARGEST:
            raise NotRead(f"the file has {path.stat().st_size / 1e6:.0f} MB: clear its outputs")
        found = submission(path.read_bytes())
    except OSError as problem:
        return [Grade(path.name, "", "", UNREAD, f"it cannot be opened ({problem.strerror})")]
    except NotRead as problem:
        return [Grade(path.name, "", "", UNREAD, str(problem))]
    strange = [id for id in found.answers if id not in QUESTIONS]
    sets = {QUESTIONS[id][0] for id in found.answers if id in QUESTIONS}
    if not sets:
        return [Grade(path.name, found.student or "", "", UNREAD, "it has no answer to a question of the homework")]
    try:
        student = None if found.student is None else student_of(found.student)
    except ValueError as problem:
        return [Grade(path.name, "", "", UNREAD, str(problem))]
    wanted = [f"{name}/{short}" for name in SETS if name in sets for short in SETS[name].questions]
    grades = [Grade(path.name, student or "", id, *_verdict(id, student, found.answers)) for id in wanted]
    return grades + [
        Grade(path.name, student or "", str(id)[:80], INVALID, "there is no such question") for id in strange
    ]


def _verdict(id, student, answers):
    answer = answers.get(id, ...)
    if isinstance(answer, NotRead):
        return Verdict(INVALID, str(answer))
    if id not in answers:
        return Verdict(UNATTEMPTED, "its check is not in the notebook")
    name, question = QUESTIONS[id]
    return judged(question, data_of(name, student), answer)


def notebooks(paths):
    """The notebooks among paths and in folders, sorted; ``Problem`` names a path that is not there."""
    found = []
    for path in map(Path, paths):
        if path.is_dir():
            found += sorted(one for one in path.rglob(f"*{SUFFIX}") if ".ipynb_checkpoints" not in one.parts)
        elif path.exists():
            found.append(path)
        else:
            raise Problem(f"there is no {path}")
    if not found:
        raise Problem(f"there is no notebook (*{SUFFIX}) in {', '.join(map(str, paths))}")
    return found


def run_grade(arguments):
    """Grade notebooks and print the table; 0 if every file could be read, else 1."""
    files = notebooks(arguments.paths)
    grades = [grade for several in _all(files, arguments.jobs or os.cpu_count() or 1) for grade in several]
    if arguments.csv:
        write(arguments.csv.absolute(), _as_csv(grades).encode())
        say(f"wrote {arguments.csv}")
    else:
        for grade in grades:
            print(line(grade))
    unread = [grade for grade in grades if grade.status == UNREAD]
    say(f"{len(files)} notebooks, {len(files) - len(unread)} graded, {len(unread)} not read")
    return 1 if unread else 0


def _all(files, jobs):
    """The grades of each file, in order; a terminal shows how many are done."""
    tell = teller(sys.stderr) if sys.stderr.isatty() else lambda *words: None
    with ProcessPoolExecutor(min(jobs, len(files))) as pool:
        for number, (file, several) in enumerate(zip(files, pool.map(graded, files, chunksize=1), strict=True), 1):
            tell(f"{number} of {len(files)} graded", file.name)
            yield several
    tell(None)


def line(grade):
    """One line of the table."""
    return f"{grade.file}  {grade.student or '-'}  {grade.question or '-'}  {grade.status}  {grade.note}"


def _as_csv(grades):
    text = StringIO()
    table = csv.writer(text)
    table.writerows([Grade._fields, *(map(_harmless, grade) for grade in grades)])
    return text.getvalue()


def _harmless(cell):
    """A cell that no spreadsheet takes for a formula."""
    return f"'{cell}" if cell.startswith(("=", "+", "-", "@", "\t", "\r")) else cell
