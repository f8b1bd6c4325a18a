"""``bezteach prove`` and ``bezteach errata``: the ledger in a terminal, and a verdict on what anyone states."""

import functools
import json
import os
import shutil
import sys

from bezteach import bench
from bezteach.ledger import READINGS, errata, judge, matching, places
from bezteach.ledger.report import claim_line, claim_record, count_line, erratum_lines, erratum_record
from bezteach.ledger.show import shown
from bezteach.parsing import InvalidAnswer
from bezteach.proof import PROVED, Verdict
from bezteach.setup.progress import Problem, say, teller


def _to_a_reader_who_may_leave(run):
    """The same command; a pipe that its reader closes, as ``head`` does, ends it without a word."""

    @functools.wraps(run)
    def until_closed(arguments):
        try:
            code = run(arguments)
            sys.stdout.flush()
        except BrokenPipeError:
            nowhere = os.open(os.devnull, os.O_WRONLY)  # for what Python flushes at its end
            os.dup2(nowhere, sys.stdout.fileno())
            os.close(nowhere)
            return 1
        return code

    return until_closed


@_to_a_reader_who_may_leave
def run_prove(arguments):
    """Judge the claims asked for, or a statement; 0 if all of it holds, else 1."""
    if arguments.statement is not None:
        return run_statement(arguments)
    if arguments.given is not None:
        raise Problem("--given says where the letters of a --statement range: the ledger's claims have their own")
    if arguments.steps and arguments.json:
        raise Problem("--steps is for readers and --json for programs: give one of them")
    ids = matching(arguments.pattern, arguments.source)
    if not ids:
        raise Problem(f"no claim matches {arguments.pattern!r}: bezteach prove lists them all")
    results = []
    width = shutil.get_terminal_size((140, 24)).columns
    for judged in _judged(ids):
        results.append(judged)
        if arguments.steps:
            print(f"{shown(judged, places(judged.claim.id))}\n")
        elif not arguments.json:
            print(claim_line(judged, width), flush=True)
    if arguments.json:
        records = [claim_record(judged, places(judged.claim.id)) for judged in results]
        print(json.dumps(records, ensure_ascii=False, indent=1))
    elif not arguments.steps:
        print(count_line(results))
    return 0 if all(judged.holds for judged in results) else 1


def _judged(ids):
    """The verdicts one by one; a terminal shows which claim is being judged."""
    tell = teller(sys.stderr) if sys.stderr.isatty() else lambda *words: None
    for number, id in enumerate(ids, 1):
        tell(f"{number} of {len(ids)}", id)
        judged = judge(id)
        tell(None)
        yield judged


def run_statement(arguments):
    """The verdict on a statement, or a derivation, typed by anyone; 0 if it is proved, else 1."""
    if arguments.pattern or arguments.source or arguments.json:
        raise Problem("--statement goes with --given and --steps only: it is not in the ledger")
    try:
        verdict = bench.judge(arguments.statement, arguments.given or "")
    except InvalidAnswer as error:
        raise Problem(str(error)) from None
    print(verdict)
    for step in verdict.steps if arguments.steps and isinstance(verdict, Verdict) else ():
        print(f"  {step!r}")
    return 0 if verdict.status == PROVED else 1


@_to_a_reader_who_may_leave
def run_errata(arguments):
    """Print what the sources get wrong; 1 if a slip is not what the ledger says it is."""
    slips = errata()
    if arguments.json:
        print(json.dumps([erratum_record(slip) for slip in slips], ensure_ascii=False, indent=1))
    else:
        for slip in slips:
            print("\n".join(erratum_lines(slip)) + "\n")
        refuted = sum(slip.slip.kind == "refuted" for slip in slips)
        say(f"{len(slips)} slips in {len(READINGS)} sources: {refuted} refuted, {len(slips) - refuted} amended")
    return 0 if all(slip.stands for slip in slips) else 1
