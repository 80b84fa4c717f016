"""How fast submissions are graded; beside nbgrader where it is asked for.

    python benchmarks/grading.py                    60 submissions of each assignment, on all cores
    python benchmarks/grading.py --quick            20 of each
    python benchmarks/grading.py --peers nbgrader   the same functions and tests as a notebook, graded by nbgrader

Prints a table; --peers writes results/grading.json. Times of one run on one machine; compare them with each other.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record
from tqdm import tqdm

from tam570_grader.checks import assignments
from tam570_grader.sandbox.launch import isolation

OUTPUT = record.FOLDER / "grading.json"
COURSE = assignments.find(Path(__file__).parents[1])
SLUGS = assignments.slugs(COURSE)
TOGETHER = 2e-3  # s, in which results of one chunk are read
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def work(slug):
    """What everybody in a class hands in."""
    return COURSE / "solutions" / f"{slug}.py"


def class_of(slug, count, folder):
    """A class that hands in the same work, with a number in it so that no two are alike."""
    text = work(slug).read_text()
    for n in range(count):
        path = folder / f"s{n:03}" / slug / f"{slug}.py"
        path.parent.mkdir(parents=True)
        path.write_text(f"{text}\n# {n}\n")
    return folder


def graded(slug, count, jobs):
    """Seconds from the command to its end, for a class; and of each in its second half, when all processes work."""
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
    return {
        "grader": f"tam570-grader, {isolation()}, {jobs} jobs",
        "assignment": slug,
        "submissions": count,
        "seconds": seconds,
        "seconds_each": seconds / count,
        "steady_seconds_each": steady(arrivals),
    }


def steady(arrivals):
    """Seconds of each submission of the second half; those of a chunk arrive together."""
    half = arrivals[len(arrivals) // 2]
    return (arrivals[-1] - half) / (sum(arrival > half + TOGETHER for arrival in arrivals) or 1)


def print_peers(slug, run, peers):
    """How many times as fast as nbgrader the run is, its start included."""
    for peer in peers:
        ratio, steady = (peer["seconds_each"] / run[name] for name in ("seconds_each", "steady_seconds_each"))
        print(f"{slug:26} {ratio:.1f} times as fast as {peer['grader']}, {steady:.1f} times once all have started")


def one_file(slug):
    """Seconds from the command to the result of one file, the best of five."""
    command = [sys.executable, "-m", "tam570_grader", "grade", str(work(slug)), "--assignment", slug]
    times = []
    for _ in range(5):
        started = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True, env=ENVIRONMENT)
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
    subprocess.run(command, cwd=course, check=True, capture_output=True, env={**ENVIRONMENT, "PATH": path})


def _notebook(path, slug):
    import nbformat
    from nbformat.v4 import new_code_cell, new_notebook

    solution = work(slug).read_text()
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
    parser.add_argument("--assignments", nargs="+", choices=SLUGS, default=SLUGS)
    parser.add_argument("--submissions", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--quick", action="store_true", help="20 submissions")
    parser.add_argument("--peers", nargs="*", choices=["nbgrader"], default=[])
    options = parser.parse_args()
    count = 20 if options.quick else options.submissions
    rows = []
    for slug in options.assignments:
        run = graded(slug, count, options.jobs)
        peers = [nbgrader(slug, 10) for _ in options.peers]
        rows += (new := [one_file(slug), run, *peers])
        for row in new:
            print_row(row)
        print_peers(slug, run, peers)
        if options.peers and not options.quick:
            record.write(OUTPUT, rows=rows)  # a run takes an hour


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
