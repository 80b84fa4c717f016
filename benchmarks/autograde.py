"""What a submission costs in `nbgrader autograde`: graded by our preprocessor, or run as a notebook by nbgrader's own.

    python benchmarks/autograde.py [--assignment SLUG] [--ours 40] [--theirs 6]

The same class in the same course is graded by our preprocessor, which runs the hidden checks, and by nbgrader's own,
which run each notebook with its visible tests; then the same functions as a smaller notebook, with nothing but them
and the visible tests in it, as in grading.py. A command's time for one submission is taken from that for many, so
that starting nbgrader counts for none. Prints a line for each and writes results/autograde.json.
"""

import argparse
import json
import tempfile
import time
from pathlib import Path

from grading import COURSE, _nbgrader, _notebook, class_of

from tam570_grader.course import run as make_course

RESULTS = Path(__file__).parent / "results" / "autograde.json"


def ours(slug, folder, count):
    """Our course with a class of so many."""
    make_course(COURSE, folder, [slug])
    _nbgrader(folder, "generate_assignment", slug)
    class_of(slug, count, folder / "submitted")
    for work in (folder / "submitted").glob(f"*/{slug}"):
        notebook = folder / "release" / slug / f"{slug}.ipynb"
        (work / notebook.name).write_text(notebook.read_text())


def executed(slug, folder, count):
    """The same course and class, with nbgrader's own preprocessors."""
    ours(slug, folder, count)
    names = (
        "Execute",
        "IgnorePattern",
        "LimitOutput",
        "SaveAutoGrades",
        "AssignLatePenalties",
        "CheckCellMetadata",
    )
    listed = [f"nbgrader.preprocessors.{name}" for name in names]
    with open(folder / "nbgrader_config.py", "a") as config:
        config.write(f"\nc.Autograde.autograde_preprocessors = {listed}\n")


def small(slug, folder, count):
    """nbgrader with nothing of ours, and notebooks that hold the solution and the visible tests."""
    config = f'c = get_config()\nc.CourseDirectory.course_id = "c"\nc.CourseDirectory.root = "{folder}"\n'
    (folder / "nbgrader_config.py").write_text(config)
    _notebook(folder / "source" / slug / "work.ipynb", slug)
    _nbgrader(folder, "generate_assignment", slug)
    for n in range(count):
        _notebook(folder / "submitted" / f"s{n:03}" / slug / "work.ipynb", slug)


def seconds(prepare, slug, count):
    """Of `nbgrader autograde` on a class of so many."""
    with tempfile.TemporaryDirectory() as folder:
        prepare(slug, Path(folder), count)
        started = time.perf_counter()
        _nbgrader(Path(folder), "autograde", slug)
        return time.perf_counter() - started


def each(prepare, slug, count):
    """Seconds for one more submission."""
    return (seconds(prepare, slug, 1 + count) - seconds(prepare, slug, 1)) / count


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--assignment", default="hw08_axis_angle")
    parser.add_argument("--ours", type=int, default=40, metavar="N", help="submissions beyond the first")
    parser.add_argument("--theirs", type=int, default=6, metavar="N")
    options = parser.parse_args()
    rows = {
        "tam570-grader's preprocessor": each(ours, options.assignment, options.ours),
        "nbgrader's own, the same notebooks": each(executed, options.assignment, options.theirs),
        "nbgrader's own, small notebooks": each(small, options.assignment, options.theirs),
    }
    first = next(iter(rows.values()))
    for name, each_more in rows.items():
        print(
            f"{name:36} {each_more * 1000:8.0f} ms for a submission more, {each_more / first:5.1f} times ours"
        )
    RESULTS.parent.mkdir(exist_ok=True)
    RESULTS.write_text(json.dumps({"assignment": options.assignment, "seconds_each": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
