"""Measure how fast submissions are graded, and the students' share of the time; optionally compare with nbgrader.

    python benchmarks/grading.py                    60 submissions of each assignment, on all cores
    python benchmarks/grading.py --quick            20 of each
    python benchmarks/grading.py --peers nbgrader   the same functions and tests as a notebook, graded by nbgrader
    python benchmarks/grading.py --cost             time of one submission, ours and the student's, with one job
    python benchmarks/grading.py --wrong            the same for the known mistakes, the most expensive first

Prints a table; --peers writes results/grading.json. Times of one run on one machine; compare them with each other.
"""

import argparse
import collections
import contextlib
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from unittest import mock

import numpy as np
import record
from tqdm import tqdm

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading.supervisor import GradeTask, WorkerConfig, result
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.pool import sandboxes
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.process import SandboxProcess
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import ResourceLimits

OUTPUT = record.FOLDER / "grading.json"
COURSE = assignments.find()
SLUGS = assignments.slugs(COURSE)
TOGETHER = 2e-3  # s, in which results of one chunk are read
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
WORKS = {"stub": "assignments/{0}/{0}.py", "solution": "solutions/{0}.py"}  # the file that a class hands in


def work(slug, work_name="solution"):
    return COURSE / WORKS[work_name].format(slug)


def class_of(slug, count, folder):
    """Write a class of the same submission, with a number in each so that no two are equal; return the folder."""
    text = work(slug).read_text()
    for n in range(count):
        path = folder / f"s{n:03}" / slug / f"{slug}.py"
        path.parent.mkdir(parents=True)
        path.write_text(f"{text}\n# {n}\n")
    return folder


class Counter:
    """Counts what crosses the boundary of the sandbox (round trips, calls, simulations), and the time spent waiting."""

    def __init__(self):
        self.waited, self.count = 0.0, collections.Counter()

    @contextlib.contextmanager
    def watching(self):
        """Count what this process does in the block."""
        with contextlib.ExitStack() as patches:
            for owner, name in WATCHED:
                looking = _passing(getattr(self, f"_{name}"), getattr(owner, name))
                patches.enter_context(mock.patch.object(owner, name, looking))
            yield self

    def _send(self, process, method, request):
        self.count["round trips"] += 1
        return method(process, request)

    def _receive(self, process, method, form):
        started = time.perf_counter()
        try:
            return method(process, form)
        finally:
            self.waited += time.perf_counter() - started

    def _replies(self, student, method, name, calls, *args, **more):
        self.count["calls"] += len(calls)
        if name.startswith("simulate"):
            self.count["simulations"] += sum(np.ndim(call.args[0]) == 1 for call in calls)
        return method(student, name, calls, *args, **more)

    def _leave(self, student, method):
        self.student = student.seconds()
        return method(student)


def _passing(look, method):
    return lambda *args, **kwargs: look(args[0], method, *args[1:], **kwargs)


WATCHED = (SandboxProcess, "send"), (SandboxProcess, "receive"), (Student, "replies"), (Student, "leave")


def cost(slug, work_name, count):
    """Return the cost of a submission with cached references: the least of `count` times, ms, and counts of one run."""
    source = Source(work(slug, work_name).read_bytes())
    conditions = WorkerConfig(ResourceLimits(), (COURSE,), tuple(imported(source.text)))  # as for a class
    task = GradeTask(COURSE, work_name, slug, 570, source, conditions=conditions)
    with sandboxes():
        with Counter().watching() as counter:
            done = result(task)
        counts = {name: counter.count[name] for name in ("round trips", "calls", "simulations")}
        times = [_timed(task) for _ in range(count)]
    assert done.score == (done.max_score if work_name == "solution" else 0)
    wall, ours, waited = (1000 * min(column) for column in zip(*times, strict=True))
    student = 1000 * counter.student  # with its import
    times = {"wall": wall, "ours": ours, "waited": waited, "student": student}
    return {"assignment": slug, "work": work_name, **times, **counts}


def wrong_costs(slug):
    """Yield for each known mistake ms of processor time, ours and the student's, with cached references; and calls."""
    conditions, solution = WorkerConfig(ResourceLimits(), (COURSE,)), work(slug).read_text()
    with sandboxes():
        for name, text in {"right": "", **overlays(assignments.checks_folder(COURSE, slug))}.items():
            source = Source(f"{solution}\n{text}".encode())
            task = GradeTask(COURSE, name, slug, 570, source, conditions=conditions)
            for _ in range(2 if name == "right" else 1):
                with Counter().watching() as counter:
                    _, ours, _ = _timed(task)
            yield 1000 * ours, 1000 * counter.student, counter.count["calls"], slug, name


def _timed(task):
    """Return seconds of wall time, of our processor time, and of waiting for the sandbox, of one submission."""
    with Counter().watching() as counter:
        wall, ours = time.perf_counter(), time.thread_time()
        result(task)
        return time.perf_counter() - wall, time.thread_time() - ours, counter.waited


def graded(slug, count, jobs):
    """Measure seconds of the command for a class, and per submission in its second half, when all processes work."""
    with tempfile.TemporaryDirectory() as folder:
        options = ["--seed", "570", "--jobs", str(jobs), "--json"]
        program = [sys.executable, "-m", "tam570_grader", "--root", COURSE, "grade"]
        command = [*program, class_of(slug, count, Path(folder)), *options]
        started, arrivals = time.perf_counter(), []
        with subprocess.Popen(command, stdout=subprocess.PIPE, env=ENVIRONMENT) as grader:
            for line in tqdm(grader.stdout, total=count, desc=slug, leave=False, disable=None):
                arrivals.append(time.perf_counter() - started)
                result = json.loads(line)
                assert result["score"] == result["max_score"]
        seconds = time.perf_counter() - started
    assert len(arrivals) == count
    row = row_of(f"tam570-grader, {isolation()}, {jobs} jobs", slug, count, seconds)
    return row | {"steady_seconds_each": steady(arrivals)}


def row_of(grader, slug, count, seconds):
    """Return a row of the table."""
    each = seconds / count
    return {"grader": grader, "assignment": slug, "submissions": count, "seconds": seconds, "seconds_each": each}


def steady(arrivals):
    """Return seconds of each submission in the second half; those of a chunk arrive together."""
    half = arrivals[len(arrivals) // 2]
    return (arrivals[-1] - half) / (sum(arrival > half + TOGETHER for arrival in arrivals) or 1)


def print_ratios(slug, runs, peers):
    """Print how many times as fast several jobs are as one, and the most jobs as nbgrader, its start included."""
    for jobs, row in runs.items() if 1 in runs else ():
        if jobs > 1:
            faster, late = (runs[1][name] / row[name] for name in ("seconds", "steady_seconds_each"))
            print(f"{slug:26} {jobs} jobs: {faster:.2f} times as fast as 1 job, {late:.2f} times once all have started")

    most = runs[max(runs)]
    for peer in peers:
        ratio, steady = (peer["seconds_each"] / most[name] for name in ("seconds_each", "steady_seconds_each"))
        print(f"{slug:26} {ratio:.1f} times as fast as {peer['grader']}, {steady:.1f} times once all have started")


def one_file(slug):
    """Measure seconds from the command to the result of one file, the best of five."""
    command = [sys.executable, "-m", "tam570_grader", "grade", str(work(slug)), "--assignment", slug]
    times = []
    for _ in range(5):
        started = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True, env=ENVIRONMENT)
        times.append(time.perf_counter() - started)
    return row_of("tam570-grader, one file from the command line", slug, 1, min(times))


def nbgrader(slug, count):
    """Measure nbgrader on a class: the same work as a notebook with the visible tests in a locked cell."""
    with tempfile.TemporaryDirectory() as folder:
        course = Path(folder)
        (course / "nbgrader_config.py").write_text(
            f'c = get_config()\nc.CourseDirectory.course_id = "c"\nc.CourseDirectory.root = "{folder}"\n'
        )
        _notebook(course / "source" / slug / "work.ipynb", slug)
        _nbgrader(course, "generate_assignment", slug, "--create")
        for n in range(count):
            _notebook(course / "submitted" / f"s{n:03}" / slug / "work.ipynb", slug)
        started = time.perf_counter()
        _nbgrader(course, "autograde", slug, "--create")
        return row_of("nbgrader", slug, count, time.perf_counter() - started)


def _nbgrader(course, *arguments):
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # nbgrader starts alembic and jupyter
    command = [sys.executable, "-m", "nbgrader", *arguments]
    subprocess.run(command, cwd=course, check=True, capture_output=True, env={**ENVIRONMENT, "PATH": path})


def _notebook(path, slug):
    import nbformat
    from nbformat.v4 import new_code_cell, new_notebook

    solution = work(slug).read_text()
    tests = (COURSE / "assignments" / slug / f"test_{slug}.py").read_text()
    plain = tests.replace(f"import {slug} as hw", "import types\nhw = types.SimpleNamespace(**globals())")
    calls = "\n".join(re.findall(r"^def (test_\w+\(\))", tests, re.MULTILINE))
    meta = {"schema_version": 3, "grade": False, "locked": False, "solution": True, "task": False, "grade_id": "work"}
    lock = {**meta, "grade": True, "locked": True, "solution": False, "grade_id": "tests", "points": 10}
    cells = [
        new_code_cell(f"### BEGIN SOLUTION\n{solution}\n### END SOLUTION", metadata={"nbgrader": meta}),
        new_code_cell(f"{plain}\n{calls}", metadata={"nbgrader": lock}),
    ]
    path.parent.mkdir(parents=True)
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(new_notebook(cells=cells, metadata=kernel), path)


def costs(slugs, count):
    """Print what submissions cost."""
    rows = [cost(slug, work_name, count) for slug in tqdm(slugs, leave=False, disable=None) for work_name in WORKS]
    print("ms a submission: on the wall, ours (processor), waited; student (processor, import too); then counts")
    for row in rows:
        times = "".join(f"{row[name]:9.1f}" for name in ("wall", "ours", "waited", "student"))
        counts = "".join(f"{row[name]:6}" for name in ("round trips", "calls", "simulations"))
        print(f"{row['assignment']:26} {row['work']:9}{times}{counts}")


def print_wrong(slugs):
    """Print the most expensive wrong submissions, and the medians of wrong and of right ones."""
    rows = sorted((row for slug in tqdm(slugs, leave=False, disable=None) for row in wrong_costs(slug)), reverse=True)
    print("processor ms of a submission: ours, the student's; calls")
    for ours, student, calls, slug, name in rows[:40]:
        print(f"{slug:26} {name:40}{ours:9.1f}{student:9.1f}{calls:6}")
    wrong, correct = ([row[0] for row in rows if (row[-1] == "right") == is_right] for is_right in (False, True))
    print(f"medians: {np.median(wrong):.1f} of {len(wrong)} wrong ones, {np.median(correct):.1f} of right ones")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--assignments", nargs="+", choices=SLUGS, default=SLUGS)
    parser.add_argument("--submissions", type=int, default=60)
    parser.add_argument("--jobs", type=int, nargs="+", default=[os.cpu_count()], help="one run for each, in turn")
    parser.add_argument("--quick", action="store_true", help="20 submissions")
    parser.add_argument("--peers", nargs="*", choices=["nbgrader"], default=[])
    parser.add_argument("--cost", action="store_true", help="what one submission costs")
    parser.add_argument("--wrong", action="store_true", help="what each known mistake costs")
    options = parser.parse_args()
    count = 20 if options.quick else options.submissions
    if options.wrong:
        print_wrong(options.assignments)
        return
    if options.cost:
        costs(options.assignments, min(count, 5))
        return
    rows = []
    for slug in options.assignments:
        runs = {jobs: graded(slug, count, jobs) for jobs in options.jobs}
        peers = [nbgrader(slug, 10) for _ in options.peers]
        rows += (new := [one_file(slug), *runs.values(), *peers])
        for row in new:
            print_row(row)
        print_ratios(slug, runs, peers)
        if options.peers and not options.quick:
            record.write(OUTPUT, rows=rows)  # each time, as a run takes an hour


def print_row(row):
    """Print a row of the table."""
    later = f"{row['steady_seconds_each'] * 1000:8.1f} later" if "steady_seconds_each" in row else ""
    print(
        f"{row['assignment']:26} {row['grader']:46} {row['submissions']:4} in {row['seconds']:7.2f} s"
        f" {row['seconds_each'] * 1000:8.1f} ms each {later}",
        flush=True,
    )


if __name__ == "__main__":
    main()
