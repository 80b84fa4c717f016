"""Faults of the machine: kills at any moment, of any process, and a clock that jumps, change no result."""

import contextlib
import fcntl
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tam570_grader.errors import UsageError
from tam570_grader.results import store
from tam570_grader.results.records import FORMAT
from tam570_grader.sandbox.launch import isolation

SLUG = "hw08_axis_angle"
SHARES = ("", "def skew(v): return v\n", "def rotate(r, axis, angle):\n    raise ValueError\n")  # of the class
linux = pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")


def class_of(count, folder, text):
    """Submissions that differ, right ones, wrong ones and refusals in turn."""
    for i in range(count):
        place = folder / f"s{i:03}" / SLUG
        place.mkdir(parents=True)
        (place / f"{SLUG}.py").write_text(f"{text}\n# {i}\n{SHARES[i % len(SHARES)]}")
    return folder


def grading(tree, out):
    command = [sys.executable, "-m", "tam570_grader.cli", "grade", tree, "--out", out, "--seed", "5", "--jobs", "2"]
    return subprocess.Popen(
        list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True
    )


def finished(process):
    _, err = process.communicate(timeout=600)
    assert process.returncode == 0, err


def outcome(out):
    """What must be the same: the results but for their seconds, the grades, the pages."""
    lines = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    results = sorted(json.dumps({**line, "seconds": None}) for line in lines)
    pages = {path.relative_to(out): path.read_text() for path in sorted((out / "feedback").rglob("*.*"))}
    return results, (out / "grades.csv").read_text(), pages


def descendants(pid):
    """Processes below this one, with their depth."""
    parents = {}
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            parents[int(folder.name)] = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
    found, depth = {pid: 0}, 0
    while len(found) > depth:
        depth = len(found)
        found.update({child: found[parent] + 1 for child, parent in parents.items() if parent in found})
    return {child: level for child, level in found.items() if level}


def gone(pids):
    deadline = time.monotonic() + 10
    while any(Path(f"/proc/{pid}").exists() and not zombie(pid) for pid in pids):
        assert time.monotonic() < deadline, "a process outlives the grader"
        time.sleep(0.05)


def zombie(pid):
    with contextlib.suppress(OSError):
        return ") Z" in Path(f"/proc/{pid}/stat").read_text()
    return True


@pytest.mark.slow
@linux
@pytest.mark.parametrize(("students", "kills"), [(60, 6), pytest.param(500, 50, marks=pytest.mark.slow)])
def test_a_run_killed_at_random_moments_ends_as_an_undisturbed_one(tmp_path, solution_text, students, kills):
    tree = class_of(students, tmp_path / "submitted", solution_text(SLUG))
    began = time.monotonic()
    finished(grading(tree, tmp_path / "calm"))
    span = time.monotonic() - began
    moments = random.Random(students)
    for kill in (os.kill, os.killpg) * (kills // 2):
        process = grading(tree, tmp_path / "killed")
        # the start takes its share each time; what is left over is spread over the kills
        time.sleep(moments.uniform(0.2, 0.8 + 2 * span / kills))
        below = descendants(process.pid)
        kill(process.pid, signal.SIGKILL)
        process.communicate()
        gone(below)
    finished(grading(tree, tmp_path / "killed"))
    assert outcome(tmp_path / "killed") == outcome(tmp_path / "calm")


@pytest.mark.slow
@linux
@pytest.mark.skipif(isolation() != "bubblewrap", reason="processes of another depth")
def test_no_process_that_dies_changes_a_result(tmp_path, solution_text):
    """The sandbox, the worker in it, a guard, a submission: whichever is killed, its submission is graded again."""
    tree = class_of(40, tmp_path / "submitted", solution_text(SLUG) + "import time\ntime.sleep(0.05)\n")
    finished(grading(tree, tmp_path / "calm"))
    process = grading(tree, tmp_path / "killed")
    moments, killed = random.Random(1), set()
    results = tmp_path / "killed" / "results.jsonl"
    while process.poll() is None and len(killed) < 4:
        below = descendants(process.pid)
        fresh = [(pid, level) for pid, level in below.items() if level not in killed]
        if fresh and results.exists() and results.read_text().count("\n") > 5 * len(killed):
            pid, level = moments.choice(fresh)
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
                killed.add(level)
        time.sleep(0.02)
    finished(process)
    assert len(killed) >= 3
    assert outcome(tmp_path / "killed") == outcome(tmp_path / "calm")


def result(student, score=1.0):
    return {
        **dict.fromkeys(store.RESULT_FIELDS),
        "format": FORMAT,
        "student": student,
        "assignment": SLUG,
        "score": score,
        "checks": [],
    }


def test_who_opens_results_that_another_run_is_replacing_writes_into_the_new_ones(tmp_path, monkeypatch):
    first = store.ResultStore(tmp_path)
    for score in (1.0, 2.0):
        first.add(result("ada", score))
    real, calls = fcntl.flock, []

    def late(file, how):
        """The other run ends between the opening of the file and its lock."""
        calls.append(file)
        if len(calls) == 1:
            first.close()
        real(file, how)

    monkeypatch.setattr(fcntl, "flock", late)
    second = store.ResultStore(tmp_path)
    second.add(result("ben"))
    assert [one["student"] for one in store.read(tmp_path)] == ["ada", "ben"]
    second.close()


def test_a_run_that_ends_leaves_nothing_unlocked_before_it_is_done(tmp_path, monkeypatch):
    """What replaces the results is the last that it writes."""
    replaced, real = [], os.replace
    monkeypatch.setattr(os, "replace", lambda draft, path: replaced.append(path.name) or real(draft, path))
    with contextlib.closing(store.ResultStore(tmp_path)) as one:
        for score in (1.0, 2.0):
            one.add(result("ada", score))
    assert replaced == ["grades.csv", "results.jsonl"]


@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir])
def test_results_are_written_into_a_regular_file_alone(tmp_path, make):
    make(tmp_path / "results.jsonl")
    with pytest.raises(UsageError, match="results.jsonl is not a regular file"):
        store.ResultStore(tmp_path)


def test_a_clock_that_jumps_changes_no_result(tmp_path, solution_text, monkeypatch):
    """An hour forwards, then a day back, at every look at it: durations are of the clock that only runs on."""
    from tam570_grader import cli

    tree = class_of(6, tmp_path / "submitted", solution_text(SLUG))
    command = ["grade", str(tree), "--seed", "5", "--jobs", "2", "--out"]
    assert cli.main([*command, str(tmp_path / "calm")]) == 0
    real, jumps = time.time, iter(range(10**6))
    monkeypatch.setattr(time, "time", lambda: real() + (3600 if next(jumps) % 2 else -86400))
    assert cli.main([*command, str(tmp_path / "jumped")]) == 0
    assert outcome(tmp_path / "jumped") == outcome(tmp_path / "calm")
