"""What faults of the machine do to results: processes that are killed, a full disk, a folder that is read only.

    python benchmarks/faults.py [--submissions 500] [--kills 50] [--seed 1]

A class is graded undisturbed. Then it is graded again while a process of the run, drawn at random from the command
down to the submissions, is killed so many times; a run that ends is started again. Then it is graded into a disk that
is full half way, then read only, then has room (this needs root, for a tmpfs). Prints how many results, grades and
pages are lost or changed, which must be none. Writes results/faults.json.
"""

import argparse
import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import record
from grading import COURSE

SLUG = "hw08_axis_angle"
VARIANTS = ("", "def skew(v): return v\n", "def rotate(r, axis, angle):\n    raise ValueError\n")
WHO = ("command", "supervisor", "bubblewrap", "zygote", "monitor", "submission")  # by depth
STARTED = 3  # levels of processes, from which on a run grades
ROOM = 2**28  # bytes
HALF = 2  # of the room that the results take


def hand_in(folder, count):
    """Hand in right modules, wrong ones and refusals in turn, no two of them alike."""
    text = (COURSE / "solutions" / f"{SLUG}.py").read_text()
    for n in range(count):
        path = folder / f"s{n:03}" / SLUG / f"{SLUG}.py"
        path.parent.mkdir(parents=True)
        path.write_text(f"{text}\n# {n}\n{VARIANTS[n % len(VARIANTS)]}")
    return folder


def start(tree, out):
    """Start to grade a tree."""
    command = [sys.executable, "-m", "tam570_grader", "grade", tree, "--out", out, "--seed", "5", "--jobs", "2"]
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    return subprocess.Popen([*map(str, command)], **streams, text=True, start_new_session=True)


def grade(tree, out):
    """Grade a tree to the end; the exit code, and what was said."""
    process = start(tree, out)
    _, said = process.communicate()
    return process.returncode, said


def outcome(out):
    """Return what must stay: results without their seconds, rows of grades, pages."""
    lines = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    results = {f"result of {line['student']}": {**line, "seconds": 0} for line in lines}
    grades = {f"row {row.split(',')[0]}": row for row in (out / "grades.csv").read_text().splitlines()}
    return (
        results | grades | {f"page {path.parts[-2]}": path.read_text() for path in (out / "feedback").rglob("*.html")}
    )


def compared(out, calm):
    """How much of an undisturbed run's outcome is lost, changed, or too much."""
    here = outcome(out)
    changed = [key for key in calm.keys() & here.keys() if calm[key] != here[key]]
    return {"lost": len(calm.keys() - here.keys()), "changed": len(changed), "too much": len(here.keys() - calm.keys())}


def processes(pid):
    """Processes of a run, with their depth."""
    parents = {}
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            parents[int(folder.name)] = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
    depths, count = {pid: 0}, 0
    while len(depths) > count:
        count = len(depths)
        depths.update({child: depths[parent] + 1 for child, parent in parents.items() if parent in depths})
    return depths


def with_kills(tree, out, kills, span, rng):
    """Grade while processes are killed; how many of which kind, and how often the command had to be given."""
    killed, runs, left = Counter(), 0, kills
    while True:
        process, runs = start(tree, out), runs + 1
        while left and process.poll() is None:
            time.sleep(rng.uniform(0.1, span / kills))
            if process.poll() is not None:
                break
            depths = processes(process.pid)
            if len({*depths.values()}) < STARTED:
                continue
            depth = rng.choice(sorted({*depths.values()}))
            victim = rng.choice([pid for pid, level in depths.items() if level == depth])
            with contextlib.suppress(ProcessLookupError):
                os.kill(victim, signal.SIGKILL)
                killed[WHO[min(depth, len(WHO) - 1)]] += 1
                left -= 1
        process.communicate()
        if process.returncode == 0:
            return {"kills": killed.total(), "of": dict(killed), "runs": runs}


@contextlib.contextmanager
def disk(folder, size):
    """A disk of so many bytes at a folder."""
    folder.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder], check=True)
    try:
        yield lambda options: subprocess.run(["mount", "-o", f"remount,{options}", folder], check=True)
    finally:
        subprocess.run(["umount", folder], check=True)


def on_bad_disks(tree, folder, calm, size):
    """Grade into a disk that is full, then read only, then well."""
    with disk(folder, size // HALF) as remount:
        code, said = grade(tree, out := folder / "results")
        full = {"exit code": code, "says": said.splitlines()[-1]}
        remount("ro")
        code, said = grade(tree, out)
        closed = {"exit code": code, "says": said.splitlines()[-1]}
        remount(f"rw,size={ROOM}")
        grade(tree, out)
        return {"full disk": full, "read only": closed, "then": compared(out, calm)}


def main():
    parser = argparse.ArgumentParser(description="Grade while processes are killed, the disk is full, or read only.")
    for name, default in (("--submissions", 500), ("--kills", 50), ("--seed", 1)):
        parser.add_argument(name, type=int, default=default)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder)
        tree, began = hand_in(path / "submitted", options.submissions), time.monotonic()
        grade(tree, path / "calm")
        span, calm = time.monotonic() - began, outcome(path / "calm")
        kills = with_kills(tree, path / "killed", options.kills, span, random.Random(options.seed))
        outcomes = {"killed": {**kills, **compared(path / "killed", calm)}}
        if os.geteuid() == 0:
            size = (path / "calm" / "results.jsonl").stat().st_size
            outcomes |= on_bad_disks(tree, path / "disk", calm, size)
    print(json.dumps(outcomes, indent=1))
    record.write(record.RESULTS / "faults.json", submissions=options.submissions, **outcomes)


if __name__ == "__main__":
    main()
