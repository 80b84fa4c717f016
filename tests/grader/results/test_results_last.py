"""Results that last: over runs, kills, full disks and faults of the grader."""

import csv
import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from tam570_grader import cli
from tam570_grader.results import records, tables

SLUG = "hw08_axis_angle"
NOTHING = "def skew(v): return None\n"


def test_scores_do_not_depend_on_jobs_and_runs(run, tree, monkeypatch):
    monkeypatch.setattr("tam570_grader.grading.batch.FEW", 1)  # a process each

    def stable(lines):
        return sorted(json.dumps({k: v for k, v in line.items() if k != "seconds"}) for line in lines)

    first = stable(run(tree, "--seed", 3, "--jobs", 1)[1])
    assert first == stable(run(tree, "--seed", 3, "--jobs", 3)[1]) == stable(run(tree, "--seed", 3, "--jobs", 3)[1])


def test_results_are_written_and_found_again(run, tree, tmp_path, monkeypatch):
    out = tmp_path / "out"
    _, first, _ = run(tree, "--out", out)
    monkeypatch.setattr("tam570_grader.grading.supervisor.graded", None)  # nothing may be graded again
    _, second, _ = run(tree, "--out", out)
    assert sorted(map(json.dumps, first)) == sorted(map(json.dumps, second))
    assert len((out / "results.jsonl").read_text().splitlines()) == 3
    table = csv.DictReader((out / "grades.csv").read_text().splitlines())
    assert [(row["student"], row["score"]) for row in table] == [("ada", "10.0"), ("ben", "0.0"), ("cora", "0.0")]
    assert "10 of 10" in (out / "feedback" / "ada" / f"{SLUG}.html").read_text()


def test_a_changed_submission_is_graded_again_with_the_same_seed(run, tree, tmp_path, solution_text, scores):
    _, first, _ = run(tree, "--out", tmp_path / "out")
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    _, second, _ = run(tree, "--out", tmp_path / "out")
    assert scores(second) == {"ada": 10.0, "ben": 10.0, "cora": 0.0}
    assert {line["seed"] for line in first + second} == {first[0]["seed"]}
    assert len((tmp_path / "out" / "results.jsonl").read_text().splitlines()) == 3


def test_a_line_cut_short_by_a_kill_is_graded_again(run, tree, tmp_path, scores):
    _, first, _ = run(tree, "--out", tmp_path / "out")
    path = tmp_path / "out" / "results.jsonl"
    path.write_bytes(path.read_bytes()[:-20])
    _, again, _ = run(tree, "--out", tmp_path / "out")
    assert scores(first) == scores(again)
    assert len(path.read_text().splitlines()) == 3


def test_a_foreign_results_file_is_not_overwritten(run, tree, tmp_path):
    path = tmp_path / "results.jsonl"
    path.write_text("my notes\n")
    assert run(tree, "--out", tmp_path)[0] == 2
    assert path.read_text() == "my notes\n"


@pytest.mark.parametrize("format", [None, 1, records.FORMAT + 1])
def test_results_of_another_format_are_refused_and_stay(run, tree, tmp_path, capsys, format):
    run(tree, "--out", tmp_path / "old")
    path = tmp_path / "old" / "results.jsonl"
    first, *rest = path.read_text().splitlines()
    changed = {**json.loads(first), "format": format}
    path.write_text("\n".join([*rest, json.dumps(changed)]) + "\n")
    before = path.read_bytes()
    assert run(tree, "--out", tmp_path / "old")[0] == run(tree, "--join", tmp_path / "old")[0] == 2
    capsys.readouterr()
    assert cli.main(["report", str(tmp_path / "old")]) == 2
    *_, line = capsys.readouterr().err.splitlines()
    assert f"{path} holds a result of another version of the grader (line 3); grade again, into a new folder" in line
    assert path.read_bytes() == before


def strict(text):
    def check_raises(word):
        raise AssertionError(word)

    return json.loads(text, parse_constant=check_raises)


def test_what_is_not_finite_is_strict_json_and_read_back(run, tree, tmp_path):
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text(
        "def skew(v): return [[0, float('inf'), 1]] * 2 + [[float('nan')] * 3]\n"
    )
    run(tree, "--out", tmp_path / "out")
    lines = (tmp_path / "out" / "results.jsonl").read_text().splitlines()
    (ben,) = (records.read(line) for line in map(strict, lines) if line["student"] == "ben")
    actual = next(mark.failure.actual for mark in ben.checks if mark.failure and mark.failure.actual is not None)
    np.testing.assert_array_equal(actual, [[0, np.inf, 1]] * 2 + [[np.nan] * 3])
    assert cli.main(["report", str(tmp_path / "out")]) == 0


@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan, np.float64("nan"), [1.0, np.inf], np.array([np.nan, 2.0])])
def test_any_number_of_a_failure_is_read_back(value):
    why = records.Failure(error=value, at={"args": [value]}, limit=0.1)
    mark = records.CheckResult("a", "a", 0.0, 1.0, "failed", "", failure=why)
    result = records.Result("ann", SLUG, "graded", 0.0, 1.0, 1, 0.1, "", (mark,))
    (again,) = records.read(strict(json.dumps(result.record()))).checks
    np.testing.assert_equal(again.failure.error, value)
    np.testing.assert_equal(again.failure.at["args"], [value])


def test_random_seeds_differ(run, tree):
    assert run(tree / "ben")[1][0]["seed"] != run(tree / "ben")[1][0]["seed"]


def command(*arguments, **options):
    return subprocess.Popen(
        [sys.executable, "-m", "tam570_grader.cli", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **options,
    )


@pytest.mark.parametrize(("how", "code"), [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_what_was_finished_survives_an_interrupt(tree, tmp_path, how, code):
    (tree / "zoe" / SLUG).mkdir(parents=True)
    (tree / "zoe" / SLUG / f"{SLUG}.py").write_text("def skew(v):\n    while True: pass\n")
    process = command("grade", tree, "--out", tmp_path / "out", "--jobs", 1, "--seed", 1, "--call", 50)
    results = tmp_path / "out" / "results.jsonl"
    while not results.exists() or results.read_text().count("\n") < 3:
        time.sleep(0.05)
    process.send_signal(how)
    _, err = process.communicate(timeout=60)
    assert process.returncode == code
    assert "Traceback" not in err
    if how == signal.SIGINT:
        said = f"interrupted; 3 results kept in {tmp_path / 'out'}; the same command goes on from there"
        assert err.strip().splitlines()[-1] == f"tam570-grader: {said}"
    assert results.read_text().count("\n") == 3


@pytest.mark.parametrize("call", [1, 2])
def test_an_interrupt_while_a_line_is_written_loses_none(tree, tmp_path, monkeypatch, call):
    real, calls = os.fsync, []

    def interrupted(file):
        real(file)
        calls.append(file)
        if len(calls) == call:
            raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    assert cli.main(["grade", str(tree), "--out", str(tmp_path / "out"), "--seed", "1"]) == 130
    assert (tmp_path / "out" / "results.jsonl").read_text().count("\n") == call
    assert (tmp_path / "out" / "grades.csv").read_text().count("\n") == call + 1


def test_a_table_that_cannot_be_written_leaves_no_draft_and_the_old_one(tmp_path, monkeypatch):
    def full(file):
        raise OSError("No space left on device")

    tables.written(tmp_path / "grades.csv", "old")
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        tables.written(tmp_path / "grades.csv", "new")
    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]


@pytest.mark.parametrize(("fault", "code"), [(KeyboardInterrupt, 130), (OSError("the disk is gone"), 1)])
def test_without_a_folder_nothing_is_said_to_be_kept(tree, monkeypatch, capsys, fault, code):
    def broken(*_):
        raise fault

    monkeypatch.setattr("tam570_grader.reports.feedback.row", broken)
    assert cli.main(["grade", str(tree), "--seed", "1"]) == code
    assert capsys.readouterr().err.strip().endswith("; nothing is kept without --out")


@pytest.mark.parametrize("command", ["report", "lms"])
def test_other_commands_claim_nothing_when_interrupted(tmp_path, monkeypatch, capsys, command):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(f"tam570_grader.cli.exchange._{command}", interrupted)
    more = ["--to", "moodle"] if command == "lms" else []
    assert cli.main([command, str(tmp_path), *more]) == 130
    assert capsys.readouterr().err == "\ntam570-grader: interrupted\n"


@pytest.mark.skipif(os.geteuid() != 0 or sys.platform != "linux", reason="mounts a small disk")
def test_a_full_disk_keeps_what_was_finished(tree, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "none", disk], check=True)
    try:
        for n in range(20):
            folder = tree / f"s{n}" / SLUG
            folder.mkdir(parents=True)
            (folder / f"{SLUG}.py").write_text(NOTHING)
        process = command("grade", tree, "--out", disk, "--seed", 1)
        _, err = process.communicate(timeout=60)
        assert process.returncode == 1
        assert "No space left" in err and "Traceback" not in err
        lines = (disk / "results.jsonl").read_text().split("\n")[:-1]
        assert lines and all(json.loads(line)["student"] for line in lines)
        assert f"{len(lines)} results kept in {disk}" in err
    finally:
        subprocess.run(["umount", disk], check=True)


def test_a_fault_of_the_grader_is_no_score_and_exits_1(run, tree, monkeypatch):
    def broken(function, calls):
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr("tam570_grader.sandbox.function.Function.many", broken)
    code, (line,), err = run(tree / "ada")
    assert code == 1 and line["score"] is None and "a fault of ours" in err
    assert {mark["outcome"] for mark in line["checks"]} >= {"grader_error"}


def test_where_the_grader_failed_it_tries_again(run, tree, tmp_path, monkeypatch):
    def broken(function, calls):
        raise RuntimeError("a fault of ours")

    with monkeypatch.context() as fault:
        fault.setattr("tam570_grader.sandbox.function.Function.many", broken)
        run(tree / "ada", "--out", tmp_path / "out")
    code, (line,), _ = run(tree / "ada", "--out", tmp_path / "out")
    assert code == 0 and line["score"] == 10.0
    assert "10" in (tmp_path / "out" / "grades.csv").read_text()


def test_a_suspect_that_raises_costs_no_grade(run, tree, monkeypatch):
    def broken(solution, suspects, calls):
        raise IndexError("a fault of ours")

    monkeypatch.setattr("tam570_grader.diagnosis.diagnose.known", broken)
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text("def rotate(axis, angle, r):\n    return r\n")
    code, (line,), _ = run(tree / "ben", "--seed", 1)
    failed = [mark for mark in line["checks"] if mark["outcome"] == "failed"]
    assert code == 0 and line["score"] is not None and failed
    assert any("a fault of ours" in mark["failure"].get("fault", "") for mark in failed)
