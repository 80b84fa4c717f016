"""Results survive repeated runs, kills, full disks and faults of the grader."""

import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from classes import HW08, check_result, hand_in, result, results, rows

from tam570_grader import cli
from tam570_grader.results import records

NOTHING = "def skew(v): return None\n"
OTHERS = [json.dumps({**result("ada").record(), "format": form}) for form in (None, 1, records.FORMAT + 1)]


def test_results_are_written_and_found_again(run, tree, tmp_path, monkeypatch, solution_text, scores):
    out = tmp_path / "out"
    _, first, _ = run(tree, "--out", out)
    with monkeypatch.context() as patch:
        patch.setattr("tam570_grader.grading.supervisor.graded", None)  # raises if anything is graded again
        _, second, _ = run(tree, "--out", out)
    assert sorted(map(json.dumps, first)) == sorted(map(json.dumps, second)) and len(results(out)) == 3
    grades = {row["student"]: row["score"] for row in rows(out / "grades.csv")}
    assert grades == {"ada": "10.0", "ben": "0.0", "cora": "0.0"}
    assert "10 of 10" in (out / "feedback" / "ada" / f"{HW08}.html").read_text()
    text = (out / "results.jsonl").read_bytes()
    (out / "results.jsonl").write_bytes(text[:-20])  # as after a kill
    hand_in(tree, {"ben": solution_text(HW08)})
    _, third, _ = run(tree, "--out", out)
    assert scores(third) == {"ada": 10.0, "ben": 10.0, "cora": 0.0} and len(results(out)) == 3
    assert {line["seed"] for line in first + third} == {first[0]["seed"]}


@pytest.mark.parametrize("line", ["my notes", *OTHERS])
def test_results_of_another_format_are_refused_and_stay(run, tree, tmp_path, capsys, line):
    path = tmp_path / "old" / "results.jsonl"
    hand_in(tmp_path, {"old": f"{line}\n"}, file=path.name)
    assert run(tree, "--out", tmp_path / "old")[0] == run(tree, "--join", tmp_path / "old")[0] == 2
    assert cli.main(["report", str(tmp_path / "old")]) == 2
    assert ("another version of the grader (line 1)" in capsys.readouterr().err) == (line in OTHERS)
    assert path.read_text() == f"{line}\n"


@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan, np.float64("nan"), [1.0, np.inf], np.array([np.nan, 2.0])])
def test_what_is_not_finite_is_strict_json_and_read_back(value):
    why = records.Failure(error=value, at={"args": [value]}, limit=0.1)
    text = json.dumps(result("ann", check_result(failure=why)).record())
    (check,) = records.read(json.loads(text, parse_constant=pytest.fail)).checks
    np.testing.assert_equal(check.failure.error, value)
    np.testing.assert_equal(check.failure.at["args"], [value])


def command(*arguments):
    words = [sys.executable, "-m", "tam570_grader", *map(str, arguments)]
    return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


@pytest.mark.parametrize(("how", "code"), [(signal.SIGINT, 130), (signal.SIGHUP, 130), (signal.SIGKILL, -9)])
def test_what_was_finished_survives_an_interrupt(tree, tmp_path, how, code):
    hand_in(tree, {"zoe": "def skew(v):\n    while True: pass\n"})
    process = command("grade", tree, "--out", tmp_path / "out", "--jobs", 1, "--seed", 1, "--call", 50)
    path = tmp_path / "out" / "results.jsonl"
    while process.poll() is None and (not path.exists() or path.read_text().count("\n") < 3):
        time.sleep(0.05)
    process.send_signal(how)
    _, err = process.communicate()
    assert process.returncode == code and "Traceback" not in err
    assert ("interrupted; 3 results kept" in err) == (code == 130)
    assert path.read_text().count("\n") == 3


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
    assert len(results(tmp_path / "out")) == len(rows(tmp_path / "out" / "grades.csv")) == call


@pytest.mark.skipif(os.geteuid() != 0 or sys.platform != "linux", reason="mounts a small disk")
def test_a_full_disk_keeps_what_was_finished(tree, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "none", disk], check=True)
    try:
        hand_in(tree, {f"s{n}": NOTHING for n in range(20)})
        process = command("grade", tree, "--out", disk, "--seed", 1)
        _, err = process.communicate()
        assert process.returncode == 1
        assert "make room on the disk" in err and "Traceback" not in err
        lines = (disk / "results.jsonl").read_text().split("\n")[:-1]
        assert lines and all(json.loads(line)["student"] for line in lines)
        assert f"{len(lines)} results kept in {disk}" in err
        process = command("watch", tree, "--out", disk / "watch", "--once")
        assert "make room on the disk" in process.communicate()[1] and process.returncode == 1
    finally:
        subprocess.run(["umount", disk], check=True)


@pytest.mark.parametrize("part", ["sandbox.function.SandboxFunction.many", "grading.run_checks.Student.load"])
def test_a_fault_of_the_grader_is_no_score_exits_1_and_is_tried_again(part, run, tree, tmp_path, monkeypatch, scores):
    """After a fault in any part of the grader, the rest of the class is graded."""

    def broken(*_):
        fault.undo()  # only one submission meets the fault
        raise RecursionError("a fault of ours")

    where = "--out", tmp_path / "out", "--jobs", 1
    with monkeypatch.context() as fault:
        fault.setattr(f"tam570_grader.{part}", broken)
        code, lines, err = run(tree, *where)
    assert code == 1 and scores(lines) == {"ada": None, "ben": 0.0, "cora": 0.0} and "a fault of ours" in err
    assert {check["outcome"] for line in lines for check in line["checks"]} >= {"grader_error"}
    code, lines, _ = run(tree, *where)
    assert code == 0 and scores(lines) == {"ada": 10.0, "ben": 0.0, "cora": 0.0}
