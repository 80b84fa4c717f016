"""Supervisors as processes: one that dies costs a try and nothing else, and none outlives the run."""

import contextlib
import functools
import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tam570_grader.audit.gradings import submissions as submissions_of
from tam570_grader.checks import assignments, expected
from tam570_grader.checks.case import Case
from tam570_grader.grading import batch
from tam570_grader.grading.cluster import Cluster
from tam570_grader.grading.executor import TaskExecutor, WorkerLost, executor, finished, in_order
from tam570_grader.grading.submissions import submissions
from tam570_grader.results.store import ResultStore
from tam570_grader.sandbox.pool import TRIES
from tam570_grader.sandbox.zygote import ResourceLimits

SLUGS = ("hw08_axis_angle", "hw03_angular_momentum_rate")
linux = pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")


def mark(folder, task):
    """Leave a file for this try of a task."""
    (folder / f"{task}-{os.getpid()}-{time.monotonic_ns()}").touch()
    return task


def die_at_first(folder, task):
    mark(folder, task)
    if task % 5 == 0 and len(list(folder.glob(f"{task}-*"))) == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def die(folder, task):
    mark(folder, task)
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


def test_a_task_that_no_process_survives_is_given_up_alone(tmp_path):
    with executor(2) as us:
        outcomes = {task: it for _, task, it in finished(us, functools.partial(die, tmp_path), range(6))}
    assert isinstance(outcomes.pop(3), WorkerLost) and outcomes == {task: task for task in (0, 1, 2, 4, 5)}
    assert tries(tmp_path, 3) == TRIES


def test_of_a_bunch_the_task_that_no_process_survives_is_given_up_alone(tmp_path):
    with executor(2) as us:
        outcomes = {task: it for _, task, it in finished(us, functools.partial(die, tmp_path), range(60), 60)}
    assert isinstance(outcomes.pop(3), WorkerLost) and outcomes == {task: task for task in range(60) if task != 3}
    assert tries(tmp_path, 3) == TRIES + 1


def test_many_tasks_travel_in_bunches_and_the_last_alone():
    sizes = []

    class Counted(ThreadPoolExecutor):
        def submit(self, work, tasks):
            sizes.append(len(tasks))
            return super().submit(work, tasks)

    with Counted(2) as pool:
        assert {task for _, task, _ in finished(TaskExecutor(pool, lambda: 4), abs, range(100), 100)} == {*range(100)}
    assert sum(sizes) == 100 and sizes[0] == 8 and sizes[-4:] == [1] * 4 and sizes == sorted(sizes, reverse=True)


def test_no_more_tasks_are_taken_than_may_be_handed_out():
    taken, most = [], []
    tasks = (taken.append(number) or number for number in range(20))
    with executor(2) as us:
        for done, _ in enumerate(finished(us, abs, tasks)):
            most.append(len(taken) - done)
    assert max(most) <= 4


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
        while len(children := below(head.pid)) < 2:
            time.sleep(0.05)
        head.send_signal(end)
    assert head.returncode
    deadline = time.monotonic() + 10
    while any(Path(f"/proc/{child}").exists() for child in children):
        assert time.monotonic() < deadline, "a supervisor outlives its head"
        time.sleep(0.05)


def below(pid):
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            if int(stat.read_text().rpartition(")")[2].split()[1]) == pid:
                found.append(int(stat.parent.name))
    return found


def motion(folder, seconds):
    """A right answer that is dear, and leaves a file each time that it is computed."""
    mark(Path(folder), "motion")
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
def test_what_is_dear_is_computed_once_a_run_and_is_the_same_to_the_last_bit(place, monkeypatch, seconds, computed):
    case = Case(str(place), seconds)
    found = []
    for _ in range(2):  # two processes, as far as the memory of one is concerned
        monkeypatch.setattr(expected, "_known", expected.Memory(5))
        found.append(expected.expected_result(motion, case))
    assert tries(place, "motion") == computed
    assert all(type(one) is tuple and all(np.array_equal(*pair) for pair in zip(*found, strict=True)) for one in found)
    found[1][0][0] = 0.0  # no read-only memory


def test_a_function_without_a_name_of_its_own_shares_nothing(place, monkeypatch):
    found = []
    for factor in (1.0, 2.0):
        monkeypatch.setattr(expected, "_known", expected.Memory(5))

        def answer(seconds, factor=factor):
            return motion(place, seconds)[0] * factor

        found.append(expected.expected_result(answer, Case(0.06))[0])
    assert found[1] == 2 * found[0]


def class_of(folder, count, solution_text):
    """Right and wrong submissions, and one that cannot be read."""
    for number in range(count):
        for slug in SLUGS:
            place = folder / f"s{number:02}" / slug
            place.mkdir(parents=True)
            end = ("", "def skew(v): return v\n", "def (")[number % 3]
            (place / f"{slug}.py").write_text(f"{solution_text(slug)}\n# {number}\n{end}")
    return submissions([folder], SLUGS)


def config_of(course, found, jobs):
    return batch.RunConfig(course, found, 570, jobs, ResourceLimits(), [course])


def same(records):
    return sorted(json.dumps({**record, "seconds": 0}) for record in records)


def differences(records, others):
    """The students whose results differ in two runs, seconds apart, with the marks that do."""
    for one, other in zip(same(records), same(others), strict=True):
        first, second = json.loads(one), json.loads(other)
        if one != other:
            yield (
                first["student"],
                [pair for pair in zip(first["checks"], second["checks"], strict=True) if pair[0] != pair[1]],
            )


def kill_at_random(over, kills, killed):
    """Kill supervisors of ours, one at a time."""
    moments = random.Random(570)
    while not over.wait(moments.uniform(0.2, 0.8)) and len(killed) < kills:
        for child in below(os.getpid()):
            with contextlib.suppress(OSError):
                if b"import serve" in Path(f"/proc/{child}/cmdline").read_bytes():
                    os.kill(child, signal.SIGKILL)
                    killed.append(child)
                    break


@pytest.mark.slow
@linux
def test_scores_are_the_same_for_one_job_for_two_and_where_supervisors_are_killed(tmp_path, course, solution_text):
    found = class_of(tmp_path, 10, solution_text)
    alone = same(batch.records(config_of(course, found, 1)))
    over, killed = threading.Event(), []
    hand = threading.Thread(target=kill_at_random, args=(over, 3, killed))
    hand.start()
    records = list(batch.records(config_of(course, found, 2)))
    over.set()
    hand.join()
    assert killed and same(records) == alone


KILLS = 50


@pytest.fixture(scope="module")
def everything(tmp_path_factory, course, solution_text):
    """All that the tree holds of right and wrong work."""
    folder = tmp_path_factory.mktemp("everything")
    for slug in assignments.slugs(course):
        texts = {
            name: f"{solution_text(slug)}\n\n{text}" for name, text in submissions_of(course, slug, "mistakes").items()
        }
        texts |= submissions_of(course, slug, "alternatives")
        for name, text in texts.items():
            place = folder / name / slug
            place.mkdir(parents=True)
            (place / f"{slug}.py").write_text(text)
    return submissions([folder], assignments.slugs(course))


@pytest.fixture(scope="module")
def by_one_job(course, everything):
    return list(batch.records(config_of(course, everything, 1)))


@pytest.mark.slow
@pytest.mark.parametrize("cluster", [False, True])
def test_two_jobs_and_a_cluster_give_what_one_job_gives_and_nothing_twice(course, everything, by_one_job, cluster):
    config = replace(config_of(course, everything, 2), cluster=Cluster("local") if cluster else None)
    assert not list(differences(batch.records(config), by_one_job)) and len(by_one_job) == len(everything)


@linux
@pytest.mark.slow
def test_fifty_kills_change_nothing(tmp_path, course, everything, by_one_job):
    """After results that a seed chooses a supervisor is killed, or the sandbox below it: each time another's.

    A submission that sees three of them die has no score, and gets it from the same command run again.
    """
    chance, config, hit = random.Random(570), config_of(course, everything, 2), [0]
    moments = set(chance.sample(range(len(everything) - 2), KILLS))
    with contextlib.closing(ResultStore(tmp_path)) as book:
        for number, _ in enumerate(batch.records(config, book)):
            if number in moments:
                time.sleep(chance.uniform(0, 0.1))
                hit.append(kill_another(hit[-1], is_sandbox=chance.random() < 0.5))
        scored = [record for record in book.values() if record["score"] is not None]
    assert len(hit) == 1 + KILLS and set(same(scored)) <= set(same(by_one_job)) and number + 1 == len(everything)
    with contextlib.closing(ResultStore(tmp_path)) as book:
        assert not list(differences(batch.records(config, book), by_one_job))


def kill_another(last, is_sandbox):
    """Kill a supervisor that was not hit last, or its sandbox, as soon as there is one; the supervisor's number."""
    while True:
        supervisors = sorted(child for child in below(os.getpid()) if b"import serve" in command_of(child))
        for supervisor in supervisors:
            victim = next(iter(below(supervisor) if is_sandbox else [supervisor]), None)
            if victim and supervisor != last:
                os.kill(victim, signal.SIGKILL)
                return supervisor
        time.sleep(0.02)


def command_of(process):
    with contextlib.suppress(OSError):
        return Path(f"/proc/{process}/cmdline").read_bytes()
    return b""
