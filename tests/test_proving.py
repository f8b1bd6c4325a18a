"""``bezteach prove`` and ``bezteach errata`` as a reader uses them."""

import json
import os
import subprocess
import sys

import pytest

from bezteach import cli


def run(capsys, *line):
    code = cli.main(list(line))
    said = capsys.readouterr()
    return code, said.out, said.err


def test_a_part_of_the_ledger(capsys):
    code, out, err = run(capsys, "prove", "basis/recursion")
    assert (code, err) == (0, "")
    assert out.startswith("✓ PROVED    basis/recursion ")
    assert "REFUTED" in out.splitlines()[-1]


def test_as_json(capsys):
    code, out, err = run(capsys, "prove", "basis/unity", "--json")
    assert (code, err) == (0, "")
    assert json.loads(out)[0]["id"] == "basis/unity"


def test_with_its_steps(capsys):
    code, out, _ = run(capsys, "prove", "basis/unity", "--steps")
    assert code == 0 and "the difference of both sides" in out


def test_in_the_order_of_a_source(capsys):
    code, out, _ = run(capsys, "prove", "basis/*", "--source", "notes")
    ids = [line.split()[2] for line in out.splitlines()[:-1]]
    assert code == 0 and ids and "basis/subdivision" not in ids


@pytest.mark.parametrize(
    ("line", "code", "said"),
    [
        (["--statement", "sum(B(i,n,t), i, 0, n) = 1", "--given", "n>=1"], 0, "PROVED (binomial theorem)"),
        (["--statement", "sum(B(i,n,t), i, 1, n) = 1"], 1, "REFUTED"),
        (["--statement", "t\n= 2t - t\n= 2t"], 1, "line 3 is the first wrong one"),
        (["--statement", "B(i,n,t) = B(n-i,n,1-t)", "--steps"], 0, "the difference of both sides"),
    ],
)
def test_a_statement_of_anyone(line, code, said, capsys):
    result, out, err = run(capsys, "prove", *line)
    assert (result, err) == (code, "") and said in out


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (["prove", "recursoin"], "no claim matches 'recursoin'"),
        (["prove", "--statement", "__import__('os')"], "character 1"),
        (["prove", "--statement", "t"], "this is no statement"),
        (["prove", "--given", "n>=1"], "--given says where the letters of a --statement range"),
        (["prove", "basis/unity", "--steps", "--json"], "--steps is for readers and --json for programs"),
        (["prove", "basis", "--statement", "t = t"], "--statement goes with --given and --steps only"),
    ],
)
def test_what_cannot_be_done_is_one_line(line, words, capsys):
    code, out, err = run(capsys, *line)
    assert (code, out) == (1, "") and words in err and err.count("\n") == 1


def test_a_source_that_is_none(capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(["prove", "--source", "book"])
    assert "invalid choice: 'book'" in capsys.readouterr().err


def test_errata(capsys):
    code, out, err = run(capsys, "errata")
    assert (code, err) == (0, "")
    assert "[refuted]" in out and "[amended]" in out and "basis/recursion/proof" in out


def test_errata_as_json(capsys):
    code, out, _ = run(capsys, "errata", "--json")
    assert code == 0 and {record["kind"] for record in json.loads(out)} == {"refuted", "amended"}


def test_the_sources_that_the_command_line_knows_are_those_of_the_ledger():
    from bezteach.ledger import READINGS

    assert list(cli.SOURCES) == list(READINGS)


@pytest.mark.skipif(os.name != "posix", reason="pipes are closed in another way")
@pytest.mark.parametrize("line", [["errata"], ["prove", "--statement", "t = t"]], ids=["long", "short"])
def test_a_reader_that_leaves_early_is_no_problem(line):
    """What fills the pipe's buffer fails at once, and what does not fails at the end: neither says so."""
    read, write = os.pipe()
    os.close(read)
    command = [sys.executable, "-m", "bezteach", *line]
    done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, text=True, timeout=120)
    os.close(write)
    assert (done.returncode, done.stderr) == (1, "")
