"""Processes killed at any moment, a clock that jumps, and a busy machine change no result."""

import contextlib
import fcntl
import os
import random
import subprocess
import sys
import time

import psutil
import pytest
from classes import HW08, hand_in, outcome, result
from processes import await_end, descendants

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading import batch
from tam570_grader.results import store

SHARES = ("", "def skew(v): return v\n", "def rotate(r, axis, angle):\n    raise ValueError\n")  # used in turn
BUSY = 2  # busy loops on the same processor as the two jobs: each job has a quarter of it


def class_of(count, folder, text):
    """Write `count` different submissions, in turn correct, wrong and raising; return their folder."""
    return hand_in(folder, {f"s{i:03}": f"{text}\n# {i}\n{SHARES[i % len(SHARES)]}" for i in range(count)})


def grading(tree, out, jobs="2"):
    command = [sys.executable, "-m", "tam570_grader", "grade", tree, "--out", out, "--seed", "5", "--jobs", jobs]
    pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
    return subprocess.Popen(list(map(str, command)), start_new_session=True, **pipes)


def run_to_end(process):
    _, err = process.communicate()
    assert process.returncode == 0, err


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")
def test_a_run_killed_at_random_moments_ends_as_an_undisturbed_one(tmp_path, solution_text, students=60, runs=7):
    """Kill two random processes of each run, then the command: a submission has three tries in a run."""
    tree = class_of(students, tmp_path / "submitted", solution_text(HW08))
    began = time.monotonic()
    run_to_end(grading(tree, tmp_path / "calm"))
    span, rng = time.monotonic() - began, random.Random(students)
    for _ in range(runs):
        process = grading(tree, tmp_path / "killed")
        for is_last in (False, False, True):
            time.sleep(rng.uniform(0.2, 0.5 + span / runs))
            started = [psutil.Process(process.pid), *descendants(process.pid)]
            with contextlib.suppress(psutil.NoSuchProcess):
                (started[0] if is_last else rng.choice(started)).kill()
        process.communicate()
        await_end(started)
    run_to_end(grading(tree, tmp_path / "killed"))
    assert outcome(tmp_path / "killed") == outcome(tmp_path / "calm")


def test_who_opens_results_that_another_run_is_replacing_writes_into_the_new_ones(tmp_path, monkeypatch):
    first = store.ResultStore(tmp_path)
    for score in (1.0, 2.0):
        first.add(result("ada", score=score).record())
    real, calls = fcntl.flock, []

    def late(file, how):
        """End the other run after this run has opened the file and before it locks it."""
        calls.append(file)
        if len(calls) == 1:
            first.close()
        real(file, how)

    monkeypatch.setattr(fcntl, "flock", late)
    second = store.ResultStore(tmp_path)
    second.add(result("ben").record())
    with contextlib.closing(store.results(tmp_path)) as results:
        assert [student for student, _ in results] == ["ada", "ben"]
    second.close()


def test_a_run_that_ends_leaves_nothing_unlocked_before_it_is_done(tmp_path, monkeypatch):
    """The last file that a run replaces is its results."""
    replaced, real = [], os.replace
    monkeypatch.setattr(os, "replace", lambda draft, path: replaced.append(path.name) or real(draft, path))
    with contextlib.closing(store.ResultStore(tmp_path)) as book:
        for score in (1.0, 2.0):
            book.add(result("ada", score=score).record())
    assert replaced == ["grades.csv", "results.jsonl"]


def test_neither_a_clock_that_jumps_nor_more_processes_change_a_result(tmp_path, solution_text, monkeypatch):
    """The clock jumps a day back or an hour forward at each reading, in one process instead of two."""
    tree = class_of(2, tmp_path / "submitted", solution_text(HW08))
    monkeypatch.setattr(batch, "FEW", 1)  # a process for each submission
    command = ["grade", str(tree), "--seed", "5", "--out"]
    assert cli.main([*command, str(tmp_path / "calm"), "--jobs", "2"]) == 0
    real, jumps = time.time, iter(range(10**6))
    monkeypatch.setattr(time, "time", lambda: real() + (3600 if next(jumps) % 2 else -86400))
    assert cli.main([*command, str(tmp_path / "jumped"), "--jobs", "1"]) == 0
    assert outcome(tmp_path / "jumped") == outcome(tmp_path / "calm")


@contextlib.contextmanager
def busy_machine():
    """Bind this process and those that it starts to one processor with busy loops; leave the others to other tests."""
    processors = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {processors[os.getpid() % len(processors)]})
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(BUSY)]
    try:
        yield
    finally:
        os.sched_setaffinity(0, processors)
        for loop in loops:
            loop.kill()
            loop.wait()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="chooses a processor")
def test_every_mistake_is_told_in_the_same_words_on_a_busy_machine(slug, course, solution_text, tmp_path):
    wrong = overlays(assignments.checks_folder(course, slug))
    texts = {name: f"{solution_text(slug)}\n\n{text}" for name, text in wrong.items()}
    tree = hand_in(tmp_path / "submitted", {**texts, **assignments.alternatives(course, slug)}, slug)
    run_to_end(grading(tree, tmp_path / "calm", jobs="1"))
    with busy_machine():
        run_to_end(grading(tree, tmp_path / "busy"))
    assert outcome(tmp_path / "busy") == outcome(tmp_path / "calm")
