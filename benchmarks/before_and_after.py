"""Whether grading became slower: this checkout beside an earlier commit, on the same classes, in turn.

    python benchmarks/before_and_after.py b2e85ae
    python benchmarks/before_and_after.py HEAD~20 --assignments hw14_rolling_disk --submissions 60 --rounds 3

Each class is graded by the command as a teacher gives it, by the two checkouts in turn. A class of right work hands in
the solution; one of wrong work hands in the known mistakes, one each. Prints the least seconds of the rounds, and the
ratio after/before.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from itertools import cycle, islice
from pathlib import Path

from tam570_grader.diagnosis.mistakes import overlays

COURSE = Path(__file__).resolve().parents[1]
ASSIGNMENTS = "hw07_double_pendulum", "hw08_axis_angle", "hw14_rolling_disk"


def works(slug, kind):
    """What a class hands in, over and over."""
    solution = (COURSE / "solutions" / f"{slug}.py").read_text()
    mistakes = overlays(COURSE / "autograder" / "checks" / slug).values()
    slips = [f"\n\n{mistake}" for mistake in mistakes] if kind == "wrong" else [""]
    return cycle(solution + slip for slip in slips)


def hand_in(folder, slug, kind, count):
    for n, text in enumerate(islice(works(slug, kind), count)):
        path = folder / f"s{n:03}" / slug / f"{slug}.py"
        path.parent.mkdir(parents=True)
        path.write_text(f"{text}\n# {n}\n")  # no two are alike


@contextmanager
def checkout(revision):
    """A folder with the files of an earlier commit."""
    with tempfile.TemporaryDirectory() as folder:
        archive = subprocess.run(["git", "archive", revision], cwd=COURSE, check=True, capture_output=True)
        subprocess.run(["tar", "-x", "-C", folder], input=archive.stdout, check=True)
        yield Path(folder)


def graded(course, work, jobs):
    """Seconds of one run of the command."""
    command = [sys.executable, "-m", "tam570_grader", "--root", str(course), "grade", str(work)]
    path = os.pathsep.join([str(course / "shared"), str(course / "autograder")])
    started = time.perf_counter()
    subprocess.run(
        [*command, "--seed", "570", "--jobs", str(jobs), "--json"],
        env={**os.environ, "PYTHONPATH": path},
        check=True,
        capture_output=True,
    )
    return time.perf_counter() - started


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision", help="the earlier commit")
    parser.add_argument("--assignments", nargs="+", default=ASSIGNMENTS, metavar="SLUG")
    parser.add_argument("--submissions", type=int, default=200)
    parser.add_argument("--kinds", nargs="+", choices=["right", "wrong"], default=["right", "wrong"])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--rounds", type=int, default=2)
    options = parser.parse_args()
    with checkout(options.revision) as earlier:
        for slug in options.assignments:
            for kind in options.kinds:
                with tempfile.TemporaryDirectory() as work:
                    hand_in(Path(work), slug, kind, options.submissions)
                    rounds = [
                        (graded(earlier, work, options.jobs), graded(COURSE, work, options.jobs))
                        for _ in range(options.rounds)
                    ]
                before, after = map(min, zip(*rounds, strict=True))
                print(f"{slug:22} {kind:5} {before:7.2f} s -> {after:7.2f} s, {after / before:.2f}", flush=True)


if __name__ == "__main__":
    main()
