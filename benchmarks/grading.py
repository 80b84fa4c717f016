"""How fast submissions are graded, and what of the time is the students' own; beside nbgrader where it is asked for.

    python benchmarks/grading.py                    200 submissions of each assignment named, on all cores
    python benchmarks/grading.py --quick            20 of each
    python benchmarks/grading.py --peers nbgrader   the same functions and tests as a notebook, graded by nbgrader

Prints a table and, with --peers, writes results/grading.json. Times of one run on one machine; compare them with each
other.
"""

import argparse
import contextlib
import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import record
from tqdm import tqdm

from tam570_grader.checks import assignments
from tam570_grader.grading.batch import RunConfig, records
from tam570_grader.grading.submissions import submissions
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.process import SandboxProcess
from tam570_grader.sandbox.replies import imported
from tam570_grader.sandbox.zygote import ResourceLimits

RESULTS = record.RESULTS / "grading.json"
COURSE = assignments.find(Path(__file__).parents[1])
CLASSES = {  # what everybody in the class hands in
    "hw08_axis_angle": "solutions/hw08_axis_angle.py",
    "hw07_double_pendulum": "autograder/checks/hw07_double_pendulum/alternatives/rk45_and_lists.py",
    "hw14_rolling_disk": "solutions/hw14_rolling_disk.py",
}


def class_of(slug, count, folder):
    """A class that hands in the same work, with a number in it so that no two are alike."""
    text = (COURSE / CLASSES[slug]).read_text()
    for n in range(count):
        path = folder / f"s{n:03}" / slug / f"{slug}.py"
        path.parent.mkdir(parents=True)
        path.write_text(f"{text}\n# {n}\n")
    return folder


class Stopwatch:
    """Time that the grader waits for the replies to calls, the students' own; and the most memory at any look."""

    def __init__(self):
        self.waited, self.memory = 0.0, 0.0
        self._over = threading.Event()
        self._receive = SandboxProcess.receive

    def __enter__(self):
        def receive(process, form):
            started = time.perf_counter()
            reply = self._receive(process, form)
            if form is not imported:  # the import, which we count as ours
                self.waited += time.perf_counter() - started
            return reply

        SandboxProcess.receive = receive
        threading.Thread(target=self._look).start()
        return self

    def __exit__(self, *exception):
        SandboxProcess.receive = self._receive
        self._over.set()

    def _look(self):
        while not self._over.wait(0.5):
            self.memory = max(self.memory, memory())


def graded(slug, count, jobs):
    """Seconds, students' share and peak memory of grading a class."""
    watch = Stopwatch() if jobs == 1 else contextlib.nullcontext()  # its looks would be the head's own time
    with tempfile.TemporaryDirectory() as folder, watch:
        found = submissions([class_of(slug, count, Path(folder))], [slug])
        config = RunConfig(COURSE, found, 570, jobs, ResourceLimits(), [COURSE])
        started, head = time.perf_counter(), head_seconds()
        done = list(tqdm(records(config), total=count, desc=slug, leave=False, disable=None))
        seconds, head = time.perf_counter() - started, head_seconds() - head
    assert all(record["score"] == record["max_score"] for record in done)
    if jobs == 1:  # all in this process
        spent = sum(record["seconds"] for record in done)
        more = {"ours": 1 - watch.waited / spent, "mib_a_job": watch.memory}
    else:
        more = {"head_seconds_each": head / count}
    return {
        "grader": f"tam570-grader, {isolation()}, {jobs} jobs",
        "assignment": slug,
        "submissions": count,
        "seconds": seconds,
        "seconds_each": seconds / count,
        **more,
    }


def memory():
    """Return the MiB of this process and its descendants, what they share counted once (Linux)."""
    family, total = {os.getpid()}, 0
    for pid in sorted(int(path.name) for path in Path("/proc").glob("[0-9]*")):  # parents first
        with contextlib.suppress(OSError):
            parent = int(Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
            if pid in family or parent in family:
                family.add(pid)
                total += int(Path(f"/proc/{pid}/smaps_rollup").read_text().split("Pss:")[1].split()[0])
    return total / 1024


def head_seconds():
    """Processor time of this process, which hands out and writes; with one job it grades as well, and is not told."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def told_of_jobs(slug, runs):
    """How many times as fast several jobs are as one, and the most that any number can be: the head is one process."""
    if 1 not in runs:
        return
    for jobs, row in runs.items():
        if jobs > 1:
            faster, bound = runs[1]["seconds"] / row["seconds"], runs[1]["seconds_each"] / row["head_seconds_each"]
            print(f"{slug:22} {jobs} jobs: {faster:.2f} times as fast as 1 job; no number of jobs: {bound:.0f} times")


def one_file(slug):
    """Seconds from the command to the result of one file, the best of five."""
    work = str(COURSE / CLASSES[slug])
    command = [sys.executable, "-m", "tam570_grader.cli", "grade", work, "--assignment", slug]
    times = []
    for _ in range(5):
        started = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        times.append(time.perf_counter() - started)
    return {
        "grader": "tam570-grader, one file from the command line",
        "assignment": slug,
        "submissions": 1,
        "seconds": min(times),
        "seconds_each": min(times),
    }


def nbgrader(slug, count):
    """The same for nbgrader: the same work as a notebook with the visible tests in a locked cell."""
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
        seconds = time.perf_counter() - started
    return {
        "grader": "nbgrader",
        "assignment": slug,
        "submissions": count,
        "seconds": seconds,
        "seconds_each": seconds / count,
    }


def _nbgrader(course, *arguments):
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # nbgrader starts alembic and jupyter
    command = [sys.executable, "-m", "nbgrader", *arguments]
    subprocess.run(command, cwd=course, check=True, capture_output=True, env={**os.environ, "PATH": path})


def _notebook(path, slug):
    import nbformat
    from nbformat.v4 import new_code_cell, new_notebook

    solution = (COURSE / CLASSES[slug]).read_text()
    tests = (COURSE / "assignments" / slug / f"test_{slug}.py").read_text()
    plain = tests.replace(f"import {slug} as hw", "import types\nhw = types.SimpleNamespace(**globals())")
    calls = "\n".join(
        f"{line[4:].split('(')[0]}()" for line in tests.splitlines() if line.startswith("def test_") and "()" in line
    )
    meta = {"schema_version": 3, "grade": False, "locked": False, "solution": True, "task": False, "grade_id": "work"}
    lock = {**meta, "grade": True, "locked": True, "solution": False, "grade_id": "tests", "points": 10}
    cells = [
        new_code_cell(f"### BEGIN SOLUTION\n{solution}\n### END SOLUTION", metadata={"nbgrader": meta}),
        new_code_cell(f"{plain}\n{calls}", metadata={"nbgrader": lock}),
    ]
    path.parent.mkdir(parents=True)
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(new_notebook(cells=cells, metadata=kernel), path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--assignments", nargs="+", choices=list(CLASSES), default=list(CLASSES))
    parser.add_argument("--submissions", type=int, default=200)
    parser.add_argument("--jobs", type=int, nargs="+", default=[os.cpu_count()], help="one run for each, in turn")
    parser.add_argument("--quick", action="store_true", help="20 submissions")
    parser.add_argument("--peers", nargs="*", choices=["nbgrader"], default=[])
    options = parser.parse_args()
    count = 20 if options.quick else options.submissions
    rows, runs = [], {}
    for slug in options.assignments:
        runs[slug] = {jobs: graded(slug, count, jobs) for jobs in options.jobs}
        rows += [one_file(slug), *runs[slug].values()]
        rows += [nbgrader(slug, 10) for _ in options.peers]
    for row in rows:
        head = f"{row['head_seconds_each'] * 1000:.2f} ms of the head each" if "head_seconds_each" in row else ""
        ours = f"{row['ours']:6.0%} outside student code, {row['mib_a_job']:.0f} MiB a job" if "ours" in row else ""
        print(
            f"{row['assignment']:22} {row['grader']:46} {row['submissions']:4} in {row['seconds']:7.2f} s"
            f" {row['seconds_each'] * 1000:8.1f} ms each {head} {ours}"
        )
    for slug, its_runs in runs.items():
        told_of_jobs(slug, its_runs)
    if options.peers and not options.quick:
        record.write(RESULTS, rows=rows)


if __name__ == "__main__":
    main()
