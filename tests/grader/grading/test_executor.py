"""Supervisors as processes: one that dies costs a try and nothing else, and none outlives the run."""

import functools
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from classes import hand_in
from parameters import SLUGS
from processes import await_end, children

from tam570_grader.audit.gradings import submissions as submissions_of
from tam570_grader.checks import expected
from tam570_grader.checks.case import Case
from tam570_grader.grading import batch
from tam570_grader.grading.cluster import Cluster
from tam570_grader.grading.executor import WorkerLost, executor, finished, in_order
from tam570_grader.grading.submissions import submissions
from tam570_grader.sandbox.pool import TRIES
from tam570_grader.sandbox.zygote import ResourceLimits

linux = pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")


def check(folder, task):
    """Leave a file for this try of a task."""
    (folder / f"{task}-{os.getpid()}-{time.monotonic_ns()}").touch()
    return task


def die_at_first(folder, task):
    check(folder, task)
    if task % 5 == 0 and len(list(folder.glob(f"{task}-*"))) == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def die(folder, task):
    check(folder, task)
    if task == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def tries(folder, task):
    return len(list(folder.glob(f"{task}-*")))


def run(work, count, jobs=2):
    with executor(jobs) as us:
        return list(in_order(us, work, range(count)))


def test_a_task_whose_process_dies_is_done_by_another_and_no_other_task_twice(tmp_path):
    assert run(functools.partial(die_at_first, tmp_path), 12) == [*range(12)]
    assert [tries(tmp_path, task) for task in range(12)] == [2 if task % 5 == 0 else 1 for task in range(12)]


def test_of_a_bunch_the_task_that_no_process_survives_is_given_up_alone(tmp_path):
    with executor(2) as us:
        outcomes = {task: it for _, task, it in finished(us, functools.partial(die, tmp_path), range(60), 60)}
    assert isinstance(outcomes.pop(3), WorkerLost) and outcomes == {task: task for task in range(60) if task != 3}
    assert tries(tmp_path, 3) == TRIES + 1


def check_raises(number):
    raise ValueError(number)


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_a_task_raises_is_raised_here(jobs):
    with pytest.raises(ValueError, match="7"), executor(jobs) as us:
        list(in_order(us, check_raises, [7]))


@linux
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGKILL])
def test_no_process_outlives_a_run_that_is_ended(tmp_path, end):
    program = (
        "import time; from tam570_grader.grading.executor import *\n"
        "with executor(2) as us:\n"
        "    print('on', flush=True); list(finished(us, time.sleep, [60, 60]))\n"
    )
    command = [sys.executable, "-c", program]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as head:
        head.stdout.readline()
        while len(started := children(head.pid)) < 2:
            time.sleep(0.05)
        head.send_signal(end)
    assert head.returncode
    await_end(started)


def motion(folder, seconds):
    """A right answer that is expensive, and leaves a file each time that it is computed."""
    check(Path(folder), "motion")
    began = time.thread_time()
    while time.thread_time() - began < seconds:
        pass
    return np.array([1 / 3, np.nextafter(1, 2)]), np.eye(2)


@pytest.fixture
def place(tmp_path):
    (tmp_path / "shared").mkdir()
    with expected.sharing(tmp_path / "shared"):
        yield tmp_path


@pytest.mark.parametrize(("seconds", "computed"), [(0.1, 1), (0.0, 2)])
def test_what_is_expensive_is_computed_once_a_run_the_same_to_the_last_bit(place, monkeypatch, seconds, computed):
    case = Case(str(place), seconds)
    actual = []
    for _ in range(2):  # two processes, as far as the memory of one is concerned
        monkeypatch.setattr(expected, "_known", expected.Memory(5))
        actual.append(expected.expected_result(motion, case))
    assert tries(place, "motion") == computed
    assert all(
        type(item) is tuple and all(np.array_equal(*pair) for pair in zip(*actual, strict=True)) for item in actual
    )
    actual[1][0][0] = 0.0  # no read-only memory


def config_of(course, actual, jobs):
    return batch.RunConfig(course, actual, 570, jobs, ResourceLimits(), [course])


def same(records):
    return sorted(json.dumps({**record, "seconds": 0}) for record in records)


@pytest.fixture(scope="module")
def everything(tmp_path_factory, course, solution_text):
    """All that the tree holds of right and wrong work."""
    folder = tmp_path_factory.mktemp("everything")
    for slug in SLUGS:
        wrong = submissions_of(course, slug, "mistakes")
        hand_in(folder, {name: f"{solution_text(slug)}\n\n{text}" for name, text in wrong.items()}, slug)
        hand_in(folder, submissions_of(course, slug, "alternatives"), slug)
    return submissions([folder], SLUGS)


@pytest.fixture(scope="module")
def by_one_job(course, everything):
    return same(batch.records(config_of(course, everything, 1)))


@pytest.mark.slow
@pytest.mark.parametrize("cluster", [False, True])
def test_two_jobs_and_a_cluster_give_what_one_job_gives_and_nothing_twice(course, everything, by_one_job, cluster):
    config = replace(config_of(course, everything, 2), cluster=Cluster("local") if cluster else None)
    assert same(batch.records(config)) == by_one_job and len(by_one_job) == len(everything)
