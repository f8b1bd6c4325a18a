"""The benchmark's harness: who is timed, what the table says, and that all jobs run, at small sizes and by no clock."""

import json
import subprocess
import sys
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import pytest
from benchmarks import clock, command, growth, peers, plain, report
from benchmarks.job import Job, Row, near
from benchmarks.measuring import WrongAnswer, measured, timed

import bezteach as bz

COMMAND = Path(__file__).parent / "benchmarks"


class Clock:
    """A clock that moves by what each call says that it takes."""

    def __init__(self):
        self.now = 0.0
        self.calls = []

    def __call__(self):
        return self.now

    def taking(self, name, seconds, answer=7):
        def run():
            self.calls.append(name)
            self.now += seconds
            return answer

        return run


def job(clock, ours, bar=0.5, check=lambda answer: answer == 7, **peers):
    return Job("seven", bar, ours, peers, check, clock=clock)


def test_the_ratio_is_that_of_the_medians_to_the_best_peer():
    clock = Clock()
    row = measured(job(clock, clock.taking("ours", 1), quick=clock.taking("quick", 4), slow=clock.taking("slow", 5)))
    assert (row.ours, row.best, row.rival, row.ratio, row.holds) == (1, "quick", "quick", 0.25, True)
    assert row.others == {"quick": 4, "slow": 5}


def test_a_missed_bar_is_said():
    clock = Clock()
    row = measured(job(clock, clock.taking("ours", 3), peer=clock.taking("peer", 4)))
    assert row.holds is False
    assert report.line(row)[-1] == "MISSED"
    assert report.table([row])[-1] == "0 of 1 bars hold"


def test_a_wrong_answer_is_refused_before_anything_is_timed():
    clock = Clock()
    given = job(clock, clock.taking("ours", 1), right=clock.taking("right", 2), wrong=clock.taking("wrong", 0.1, 8))
    row = measured(given)
    assert row.refused == ("wrong",) and set(row.others) == {"right"}
    assert clock.calls.count("wrong") == 1 and clock.calls.index("wrong") < 3
    assert "refused, the answer is wrong: wrong at seven" in report.table([row])


def test_a_peer_that_raises_is_refused_too():
    clock = Clock()
    row = measured(job(clock, clock.taking("ours", 1), broken=lambda: 1 / 0))
    assert row.refused == ("broken",) and row.ratio is None and row.holds is None


def test_our_own_wrong_answer_ends_it():
    clock = Clock()
    with pytest.raises(WrongAnswer, match="seven: our own answer is wrong"):
        measured(job(clock, clock.taking("ours", 1, 8), peer=clock.taking("peer", 1)))


def test_contenders_take_turns_and_a_hopeless_one_is_timed_once():
    clock = Clock()
    runs = {name: clock.taking(name, seconds) for name, seconds in (("ours", 1), ("near", 2), ("far", 100))}
    assert timed(runs, 7, clock) == {"ours": 1, "near": 2, "far": 100}
    assert clock.calls == ["ours", "near", "far", *["near", "ours", "ours", "near"] * 3, "near", "ours"]


def test_a_short_call_is_repeated_in_each_run():
    clock = Clock()
    assert timed({"ours": clock.taking("ours", 0.001)}, 7, clock)["ours"] == pytest.approx(0.001)
    assert len(clock.calls) == 1 + 7 * 4


def test_the_median_does_not_mind_one_disturbed_run():
    clock, turn = Clock(), count()

    def run():
        clock.now += 100 if next(turn) == 3 else 1

    assert timed({"ours": run}, 7, clock) == {"ours": 1}


def test_a_bar_may_be_against_one_peer_and_another_be_the_best():
    row = Row("x", 3.0, {"a": 4.0, "b": 10.0}, ("b",), bar=0.5)
    assert (row.best, row.rival, row.ratio, row.holds) == ("a", "b", 0.3, True)
    assert report.line(row)[3] == "0.30 of b"


def test_where_the_peer_of_the_bar_is_missing_nothing_is_claimed():
    row = Row("x", 3.0, {"a": 4.0}, ("b",), bar=0.5)
    assert row.ratio is None and row.holds is None
    assert report.line(row)[-1] == "? b is not there"


def test_an_absolute_bar_is_for_ours():
    assert Row("x", 0.002, bar=0.001, absolute=True).holds is False
    assert report.line(Row("x", 0.0005, bar=0.001, absolute=True)) == ["x", "500 µs", "", "", "1 ms", "holds"]


def test_a_long_command_counts_by_the_clock_on_the_wall(monkeypatch):
    commands = {"idle": "import time; time.sleep(0.2)", "failing": "raise SystemExit(3)"}
    monkeypatch.setattr(clock, "LONG", {name: (("-c", code), "auto", 60) for name, code in commands.items()})
    idle, failing = map(clock.whole, commands)
    assert (idle.name, idle.holds) == ("idle", True) and idle.ours >= 0.2
    assert (failing.name, failing.holds) == ("failing (exit code 3)", None)


def test_without_python_flint_nothing_is_called_by_its_name(monkeypatch):
    monkeypatch.setattr(peers, "found", {"python-flint": None})
    assert clock.long_commands() == list(clock.LONG)
    monkeypatch.setattr(peers, "found", {})
    assert clock.long_commands() == ["whole ledger", "whole test command"]


def test_a_missing_peer_is_named_with_the_reason():
    def load(module):
        if module == "gone":
            raise ImportError("no module named gone\nand more")
        return module

    found, missing = peers.tried({"here": "here", "lost": "gone"}, load)
    assert found == {"here": "here"}
    lines = report.head(found, missing)
    assert lines[1:] == ["NOT INSTALLED, so not compared: lost (ImportError: no module named gone)"]


def test_an_answer_is_near_only_with_its_shape_and_all_of_it_finite():
    check = near([[1.0], [3.0]], (3, 1), [0, 2])
    assert check([[1.0], [2.0], [3.0]]) and check([[1.0], [2.5], [3.0]])
    assert not check([[1.0], [float("nan")], [3.0]])
    assert not check([[1.0], [2.0], [3.1]])
    assert not check([[1.0], [3.0]])


def test_the_plain_answers_agree_with_exact_ones():
    points, knots = [[0, 0], [2, 1], [4, 5], [0, 2], [4, 4], [2, 0]], [0, 0, 0, 1, 2, 3, 4, 4, 4]
    t = [0, 0.5, 1, 1.75, 4]
    assert abs(plain.spline(points, knots, 2, t) - bz.bspline.evaluate(points, knots, t)).max() < 1e-14
    assert abs(plain.curve(points, t[:3]) - bz.evaluate(points, t[:3])).max() < 1e-14


def test_the_exponent_is_the_slope_at_the_end():
    assert growth.exponent({1: 50.0, 10: 5.0, 100: 500.0, 1000: 50000.0}) == pytest.approx(2)


def test_all_jobs_run_and_the_json_is_read_back(tmp_path, capsys):
    file, picture = tmp_path / "report.json", tmp_path / "growth.png"
    code = command.main(["--small", "--runs", "1", "--json", str(file), "--plot", str(picture)])
    record, said = json.loads(file.read_text(encoding="utf-8")), capsys.readouterr().out
    assert code == 0
    names = [row["name"] for row in record["rows"]]
    assert len(names) > 60 and all(name in said for name in names)
    assert set(record["peers"]) | set(record["missing"]) == set(peers.MODULES)
    errors = [row for row in record["rows"] if row["unit"] == "u"]
    assert errors and all(row["holds"] in (True, None) for row in errors)
    assert all(row["bar"] is None for row in record["rows"] if row["unit"] != "u")
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_our_wrong_answer_is_told_beside_the_other_jobs(monkeypatch, capsys):
    clock = Clock()
    jobs = [job(clock, clock.taking("ours", 1, answer)) for answer in (7, 8)]
    monkeypatch.setattr(command, "SUBJECTS", {"seven": SimpleNamespace(jobs=lambda small: jobs)})
    assert command.main(["seven"]) == 2
    assert capsys.readouterr().out.endswith("seven: our own answer is wrong\n")


def test_without_peers_every_job_still_runs_and_nothing_is_claimed(monkeypatch, capsys):
    monkeypatch.setattr(peers, "found", {})
    monkeypatch.setattr(peers, "missing", {name: "ImportError: gone" for name in peers.MODULES})
    assert command.main(["--small", "--runs", "1", "n=3|of cubics|B-spline|to_bezier|exact"]) == 0
    said = capsys.readouterr().out
    assert said.count("NOT INSTALLED") == len(peers.MODULES)
    assert "bezier" not in said.partition("job ")[2].replace("to_bezier", "")


def test_a_median_of_few_runs_is_refused(capsys):
    with pytest.raises(SystemExit):
        command.main(["--runs", "3"])
    assert "at least 7" in capsys.readouterr().err


def test_the_command_of_the_readme_runs():
    arguments = [sys.executable, str(COMMAND), "--small", "--runs", "1", "--json", "-", "exact power"]
    done = subprocess.run(arguments, check=True, capture_output=True, text=True)
    (row,) = json.loads(done.stdout)["rows"]
    assert row["name"] == "exact power matrix n=4" and row["ours"] > 0
