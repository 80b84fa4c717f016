"""Measure how `tam570-grader watch` keeps up with a class.

    python benchmarks/arrivals.py [--submissions 500] [--seconds 60]

Students hand in at even intervals during a minute, into a folder. Prints how many submissions were graded, graded
twice, or graded out of order, and the longest wait. Writes results/arrivals.json.
"""

import argparse
import json
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record
from grading import COURSE

SLUG = "hw08_axis_angle"
TEXT = (COURSE / "solutions" / f"{SLUG}.py").read_text()


def watch(source, out):
    """Start a process that watches a folder."""
    command = [sys.executable, "-m", "tam570_grader", "watch", source, "--out", out, "--jobs", "2"]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "start_new_session": True}
    return subprocess.Popen([*map(str, command)], **quiet)


def graded(out):
    """Return the graded attempts in the journal, in their order."""
    path = out / "watch.jsonl"
    lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
    events = [json.loads(line) for line in lines if line.endswith(b"\n")]
    return [event for event in events if event["event"] == "graded"]


def in_a_minute(root, count, seconds):
    """Let `count` students hand in at even intervals while `watch` grades; return the measurements."""
    source, out = root / "submitted", root / "results"
    source.mkdir()
    process = watch(source, out)
    while not (out / "watch.key").exists():
        time.sleep(0.1)
    began = time.time()
    for n in range(count):
        time.sleep(max(0.0, began + n * seconds / count - time.time()))
        folder = source / f"s{n:04}" / SLUG
        folder.mkdir(parents=True)
        (folder / f"{SLUG}.py").write_text(f"{TEXT}\n# {n}\n")
    last = time.time()
    while len(graded(out)) < count and process.poll() is None and time.time() < last + 20 * seconds:
        time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    process.wait()
    done = graded(out)
    students = [event["student"] for event in done]
    arrived = [event["student"] for event in sorted(done, key=lambda event: event["at"])]
    return {
        "hand-ins": count,
        "graded": len({*students}),
        "graded twice": len(students) - len({*students}),
        "taken out of order": sum(a > b for a, b in zip(arrived, arrived[1:], strict=False)),
        "full marks": sum(event["record"]["score"] == 10 for event in done),
        "handed in within (s)": last - began,
        "all graded after the last (s)": max(event["graded_at"] for event in done) - last,
        "longest wait (s)": max(event["waited"] for event in done),
    }


def main():
    parser = argparse.ArgumentParser(description="Let a class hand in while `watch` grades.")
    for name, default in (("--submissions", 500), ("--seconds", 60)):
        parser.add_argument(name, type=int, default=default)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        outcome = in_a_minute(Path(folder), options.submissions, options.seconds)
    print(json.dumps(outcome, indent=1))
    record.write(record.FOLDER / "arrivals.json", **outcome)


if __name__ == "__main__":
    main()
