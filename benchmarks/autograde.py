"""Measure the time of a submission in `nbgrader autograde`: with our preprocessors, and with nbgrader's own.

    python benchmarks/autograde.py [--submissions 20]

The same class in the same course, with the same notebooks and modules: our preprocessors run the hidden checks on the
module, nbgrader's own run each notebook with its visible tests. All submissions are right, or one has an endless loop:
then our limit is 10 s or 2 s a call, and nbgrader's 30 s a cell. Prints the time of one more submission, from classes
of one and of N, without start-up. Writes results/autograde.json.
"""

import argparse
import shutil
import tempfile
import time
from pathlib import Path

import record
from grading import COURSE, _nbgrader, class_of
from tqdm import tqdm

from tam570_grader.nbgrader.course import run as make_course

STEPS = ("Execute", "IgnorePattern", "LimitOutput", "SaveAutoGrades", "AssignLatePenalties", "CheckCellMetadata")
HANGS = """

def _for_ever(*args, **kwargs):
    while True:
        pass


globals()[__all__[0]] = _for_ever
"""
WAYS = {  # by name, more lines of the course's nbgrader_config.py
    "our preprocessors": "",
    "our preprocessors, 2 s a call": "c.SandboxGrades.call = 2",
    "nbgrader's own, the same notebooks": "c.Autograde.autograde_preprocessors = "
    f"{[f'nbgrader.preprocessors.{name}' for name in STEPS]}",
}
OURS, TIGHTER, PEER = WAYS
RUNS = [(slug, way, False) for slug in ("hw08_axis_angle", "hw07_double_pendulum") for way in (OURS, PEER)]
RUNS += [("hw08_axis_angle", way, True) for way in WAYS]


def prepare(folder, slug, way, hang, count):
    """Make a course with a class of `count` submissions, the last of them with an endless loop if `hang`."""
    make_course(COURSE, folder, [slug])
    _nbgrader(folder, "generate_assignment", slug)
    class_of(slug, count, folder / "submitted")
    works = sorted((folder / "submitted").glob(f"*/{slug}"))
    for work in works:
        for name in (f"{slug}.ipynb", f"test_{slug}.py", "lab.py"):
            shutil.copy(folder / "release" / slug / name, work)
    if hang:
        with open(works[-1] / f"{slug}.py", "a") as module:
            module.write(HANGS)
    with open(folder / "nbgrader_config.py", "a") as config:
        config.write(f"\n{WAYS[way]}\n")


def seconds(slug, way, hang, count):
    """Return the wall time of `nbgrader autograde` on a class of `count` submissions, s."""
    with tempfile.TemporaryDirectory() as folder:
        prepare(Path(folder), slug, way, hang, count)
        started = time.perf_counter()
        _nbgrader(Path(folder), "autograde", slug)
        return time.perf_counter() - started


def measured(slug, way, hang, count):
    single, everyone = seconds(slug, way, False, 1), seconds(slug, way, hang, count)
    row = {"assignment": slug, "way": way, "endless_loop": hang, "submissions": count, "seconds": everyone}
    return row | {"one_more": (everyone - single) / (count - 1)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--submissions", type=int, default=20, metavar="N")
    count = parser.parse_args().submissions
    rows = [measured(*run, count) for run in tqdm(RUNS, leave=False, disable=None)]
    for row in rows:
        state = "one hangs" if row["endless_loop"] else "all right"
        print(f"{row['assignment']:22} {state} {row['way']:35} {1000 * row['one_more']:7.0f} ms one more")
    record.write(record.FOLDER / "autograde.json", rows=rows)


if __name__ == "__main__":
    main()
