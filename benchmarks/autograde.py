"""What a submission costs in `nbgrader autograde`: graded by our preprocessors, or run as a notebook by nbgrader's own.

    python benchmarks/autograde.py [--assignments SLUG ...] [--classes right loop] [--submissions 20] [--repeats 1]

The same class in the same course, with the same notebooks and modules, by three commands: our preprocessors, which
run the hidden checks on the module; nbgrader's own, which run each notebook with its visible tests; and nbgrader's
own on the same functions as a smaller notebook, with nothing but them and the visible tests in it. The class is timed
twice, all of it right, and with one endless loop in it; that too with 2 s for a call in place of 10 (nbgrader's own
gives a cell 30 s). A submission's share of the command, start-up included, is printed, and what one more costs, from
classes of one and of all. Writes results/autograde.json.
"""

import argparse
import json
import shutil
import tempfile
import time
from pathlib import Path

import record
from grading import COURSE, SLUGS, _nbgrader, _notebook, class_of

from tam570_grader.nbgrader.course import run as make_course

RESULTS = record.RESULTS / "autograde.json"
OWN = ("Execute", "IgnorePattern", "LimitOutput", "SaveAutoGrades", "AssignLatePenalties", "CheckCellMetadata")
HANGS = """

def _for_ever(*args, **kwargs):
    while True:
        pass


globals()[__all__[0]] = _for_ever
"""


def ours(slug, folder, count, hang):
    """Our course with a class of so many, the last of them with an endless loop."""
    make_course(COURSE, folder, [slug])
    _nbgrader(folder, "generate_assignment", slug)
    class_of(slug, count, folder / "submitted")
    works = sorted((folder / "submitted").glob(f"*/{slug}"))
    for work in works:
        shutil.copy(folder / "release" / slug / f"{slug}.ipynb", work)
        for name in (f"test_{slug}.py", "lab.py"):
            shutil.copy(folder / "release" / slug / name, work)
    if hang:
        module = works[-1] / f"{slug}.py"
        module.write_text(f"{(COURSE / 'solutions' / f'{slug}.py').read_text()}{HANGS}")


def two_seconds(slug, folder, count, hang):
    """Our course with a tighter limit."""
    ours(slug, folder, count, hang)
    with open(folder / "nbgrader_config.py", "a") as config:
        config.write("\nc.SandboxGrades.call = 2\n")


def executed(slug, folder, count, hang):
    """The same course and class, with nbgrader's own preprocessors."""
    ours(slug, folder, count, hang)
    listed = [f"nbgrader.preprocessors.{name}" for name in OWN]
    with open(folder / "nbgrader_config.py", "a") as config:
        config.write(f"\nc.Autograde.autograde_preprocessors = {listed}\n")


def small(slug, folder, count, hang):
    """nbgrader with nothing of ours, and notebooks that hold the functions and the visible tests."""
    config = f'c = get_config()\nc.CourseDirectory.course_id = "c"\nc.CourseDirectory.root = "{folder}"\n'
    (folder / "nbgrader_config.py").write_text(config)
    _notebook(folder / "source" / slug / "work.ipynb", slug)
    _nbgrader(folder, "generate_assignment", slug)
    for n in range(count):
        path = folder / "submitted" / f"s{n:03}" / slug / "work.ipynb"
        _notebook(path, slug)
    if hang:
        notebook = json.loads(path.read_text())
        notebook["cells"][0]["source"] = "".join(notebook["cells"][0]["source"]) + HANGS
        path.write_text(json.dumps(notebook))


RIGHT = {
    "our preprocessors": ours,
    "nbgrader's own, the same notebooks": executed,
    "nbgrader's own, small notebooks": small,
}
LOOP = {
    "our preprocessors": ours,
    "our preprocessors, 2 s a call": two_seconds,
    "nbgrader's own, the same notebooks": executed,
}


def seconds(prepare, slug, count, hang=False):
    """Of `nbgrader autograde` on a class of so many."""
    with tempfile.TemporaryDirectory() as folder:
        prepare(slug, Path(folder), count, hang)
        started = time.perf_counter()
        _nbgrader(Path(folder), "autograde", slug)
        return time.perf_counter() - started


def measured(slug, hang, count, repeats):
    """Rows of one class; the ways take turns, and the best of each is taken."""
    ways = LOOP if hang else RIGHT
    turns = [
        {name: (seconds(way, slug, 1), seconds(way, slug, count, hang)) for name, way in ways.items()}
        for _ in range(repeats)
    ]
    rows = []
    for name in ways:
        single, everyone = (min(turn[name][k] for turn in turns) for k in (0, 1))
        rows.append(
            {
                "assignment": slug,
                "way": name,
                "endless_loop": hang,
                "submissions": count,
                "seconds": everyone,
                "seconds_each": everyone / count,
                "one_more": (everyone - single) / (count - 1),
            }
        )
    return rows


def shown(rows):
    """A line for each way, with its ratios to ours."""
    for row in rows:
        each, more = (row[key] / rows[0][key] for key in ("seconds_each", "one_more"))
        print(
            f"{row['assignment']:22} {'one hangs' if row['endless_loop'] else 'all right':9} {row['way']:35}"
            f" {1000 * row['seconds_each']:7.0f} ms each ({each:5.1f})"
            f" {1000 * row['one_more']:7.0f} ms one more ({more:5.1f})",
            flush=True,
        )


def kept(rows):
    """Put the rows into the file in place of those of the same class."""
    old = record.read(RESULTS).get("rows", [])
    new = {(row["assignment"], row["endless_loop"]) for row in rows}
    rest = [row for row in old if (row["assignment"], row["endless_loop"]) not in new]
    both = sorted(rest + rows, key=lambda row: (row["assignment"], row["endless_loop"]))
    record.write(RESULTS, rows=both)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--assignments",
        nargs="+",
        choices=SLUGS,
        default=["hw08_axis_angle", "hw07_double_pendulum", "hw14_rolling_disk"],
    )
    parser.add_argument("--classes", nargs="+", choices=["right", "loop"], default=["right", "loop"])
    parser.add_argument("--submissions", type=int, default=20, metavar="N")
    parser.add_argument("--repeats", type=int, default=1, metavar="N")
    options = parser.parse_args()
    for slug in options.assignments:
        for hang in options.classes:
            rows = measured(slug, hang == "loop", options.submissions, options.repeats)
            shown(rows)
            kept(rows)


if __name__ == "__main__":
    main()
