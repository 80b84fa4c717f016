"""Supervisor processes: if one dies, only its task is tried again, and none outlives the run."""

import functools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from processes import await_end, descendants

from tam570_grader.checks import assignments, expected
from tam570_grader.checks.case import Case
from tam570_grader.grading.executor import WorkerLost, executor, in_order, run_tasks
from tam570_grader.grading.run_checks import rehearse
from tam570_grader.sandbox.pool import TRIES

linux = pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")
GRADES_A_CLASS = """
import sys
from tam570_grader.checks import assignments
from tam570_grader.grading import batch
from tam570_grader.grading.submissions import Submission
from tam570_grader.sandbox import pool

def tell(module, name):
    function = getattr(module, name)
    setattr(module, name, lambda *args: print(name, file=sys.stderr) or function(*args))

tell(pool, "Zygote"), tell(assignments, "_checks")
work = assignments.find() / "solutions" / "hw08_axis_angle.py"
config = batch.RunConfig(submissions=[Submission(f"s{n}", work.stem, work, work) for n in range(8)], jobs=2)
print(sum(record["score"] for record in batch.records(config)))
"""


def leave_trace(folder, task):
    """Create a file that records this try of a task; return the task."""
    (folder / f"{task}-{os.getpid()}-{time.monotonic_ns()}").touch()
    return task


def die(folder, tasks, times, task):
    """Kill this process in the first `times` tries of each task in `tasks`; return other tasks."""
    leave_trace(folder, task)
    if task in tasks and tries(folder, task) <= times:
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def tries(folder, task):
    return len(list(folder.glob(f"{task}-*")))


def test_a_task_whose_process_dies_is_done_by_another_and_no_other_task_twice(tmp_path):
    with executor(2) as us:
        assert list(in_order(us, functools.partial(die, tmp_path, (0, 5, 10), 1), range(12))) == [*range(12)]
    assert [tries(tmp_path, task) for task in range(12)] == [2 if task % 5 == 0 else 1 for task in range(12)]


def test_of_a_bunch_the_task_that_no_process_survives_is_given_up_alone(tmp_path):
    with executor(2) as us:
        work = functools.partial(die, tmp_path, (3,), 99)
        outcomes = {task: it for _, task, it in run_tasks(us, work, range(60), 60)}
    assert isinstance(outcomes.pop(3), WorkerLost) and outcomes == {task: task for task in range(60) if task != 3}
    assert tries(tmp_path, 3) == TRIES + 1


def fail(number):
    raise ValueError(number)


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_a_task_raises_is_raised_here(jobs):
    with pytest.raises(ValueError, match="7"), executor(jobs) as us:
        list(in_order(us, fail, [7]))


@linux
def test_an_interrupt_during_a_fork_is_heard():
    program = (
        "import os, signal, time; from tam570_grader.grading.executor import *\n"
        "os.register_at_fork(after_in_parent=lambda: os.kill(os.getpid(), signal.SIGINT))\n"
        "with executor(2) as us:\n"
        "    list(run_tasks(us, time.sleep, [1, 1]))\n"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert ended.returncode and ended.stderr.endswith("KeyboardInterrupt\n")


@linux
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGKILL])
def test_no_process_outlives_a_run_that_is_ended(end):
    program = (
        "import time; from tam570_grader.grading.executor import *\n"
        "with executor(2) as us:\n"
        "    print('on', flush=True); list(run_tasks(us, time.sleep, [60, 60]))\n"
    )
    command = [sys.executable, "-c", program]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as coordinator:
        coordinator.stdout.readline()
        while len(started := descendants(coordinator.pid)) < 2:
            time.sleep(0.05)
        coordinator.send_signal(end)
    assert coordinator.returncode
    await_end(started)


@linux
def test_all_jobs_share_a_sandbox_and_what_is_loaded():
    done = subprocess.run([sys.executable, "-c", GRADES_A_CLASS], capture_output=True, text=True, check=True)
    assert float(done.stdout) == 80
    assert done.stderr.split() == ["Zygote", "_checks"]


def motion(folder, seconds):
    """Return an expected result after `seconds` of processor time; create a file for each computation."""
    leave_trace(Path(folder), "motion")
    began = time.thread_time()
    while time.thread_time() - began < seconds:
        pass
    return np.array([1 / 3, np.nextafter(1, 2)]), np.eye(2)


@pytest.mark.parametrize(("rehearsed", "score"), [(True, 10.0), (False, None)])
def test_what_is_right_is_known_after_a_rehearsal(grade, course, solution_text, monkeypatch, rehearsed, score):
    slug, seed = "hw11_disk_steady", 5700 + rehearsed
    if rehearsed:
        rehearse(assignments.assignment(course, slug), seed)
    monkeypatch.setattr(expected, "shared", None)  # computing a result now raises
    assert grade(slug, solution_text(slug), seed).score == score


@pytest.mark.parametrize(("seconds", "computed"), [(0.1, 1), (0.0, 2)])
def test_what_is_expensive_is_computed_once_a_run_the_same_to_the_last_bit(tmp_path, monkeypatch, seconds, computed):
    (tmp_path / "shared").mkdir()
    actual = []
    with expected.sharing(tmp_path / "shared"):
        for _ in range(2):  # an empty cache stands for a new process
            monkeypatch.setattr(expected, "_known", expected.LruCache(5))
            actual.append(expected.expected_result(motion, Case(str(tmp_path), seconds)))
    assert tries(tmp_path, "motion") == computed
    assert {type(item) for item in actual} == {tuple}
    assert all(np.array_equal(*pair) for pair in zip(*actual, strict=True))
    actual[1][0][0] = 0.0  # raises if the memory is read-only
