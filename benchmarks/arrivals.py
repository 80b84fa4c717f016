"""How `tam570-grader watch` keeps up with a class, and what it loses when it is killed.

    python benchmarks/arrivals.py [--submissions 500] [--seconds 60] [--kills 20] [--users TEACHER STUDENT]

First, so many students hand in during a minute, evenly, into a folder. Then, with two Unix users (this needs root),
the student hands in with nbgrader through its exchange, twice between two starts of the teacher's `watch`, which is
killed at a random moment each time; `nbgrader fetch_feedback` gets the student's pages. Prints how many hand-ins were
graded, twice, or out of order, and the longest wait. Writes results/arrivals.json.
"""

import argparse
import contextlib
import json
import os
import pwd
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record
from grading import COURSE

SLUG, NAME = "hw08_axis_angle", "tam570"
TEXT = (COURSE / "solutions" / f"{SLUG}.py").read_text()
HALF = "\n\ndef rotate(r, axis, angle):\n    return np.asarray(r, float)\n"
CONFIG = 'c = get_config()\nc.CourseDirectory.course_id = "{name}"\nc.Exchange.root = "{exchange}"\n'
NBGRADER = """
import os, sys
from nbgrader.apps import NbGraderApp
for line in sys.stdin:
    child = os.fork()
    if child == 0:
        for stream in (1, 2):
            os.dup2(os.open("log.txt", os.O_WRONLY | os.O_CREAT | os.O_APPEND), stream)
        NbGraderApp.launch_instance(line.split())
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


def watch(source, out, *more, user=None):
    """Start to watch a folder."""
    command = [sys.executable, "-m", "tam570_grader", "watch", source, "--out", out, "--jobs", "2", *more]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "start_new_session": True}
    return subprocess.Popen([*map(str, command)], **quiet, **(_as(user) if user else {}))


def _as(name):
    """Options of a process of a Unix user."""
    person = pwd.getpwnam(name)
    variables = {**os.environ, "HOME": person.pw_dir, "JUPYTER_DATA_DIR": person.pw_dir, "USER": name}
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    return {"user": name, "group": person.pw_gid, "extra_groups": [], "env": {**variables, "PATH": path}}


def graded(out):
    """The graded attempts in the journal, in their order."""
    path = out / "watch.jsonl"
    lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
    events = [json.loads(line) for line in lines if line.endswith(b"\n")]
    return [event for event in events if event["event"] == "graded"]


def in_a_minute(root, count, seconds):
    """So many students hand in, evenly."""
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


def made_exchange(folder, teacher, student):
    """A course that the teacher has released, and the student's folder with the assignment."""
    (exchange := folder / "exchange").mkdir()
    exchange.chmod(0o777)
    homes = {}
    for user in (teacher, student):
        homes[user] = folder / user
        homes[user].mkdir()
        shutil.chown(homes[user], user)
    course, config = homes[teacher] / "course", CONFIG.format(name=NAME, exchange=exchange)
    (homes[student] / "nbgrader_config.py").write_text(config)
    _must([sys.executable, "-m", "tam570_grader", "course", course, SLUG], homes[teacher], teacher)
    with open(course / "nbgrader_config.py", "a") as file:
        file.write(config.replace("c = get_config()", ""))
    for command in ("generate_assignment", "release_assignment"):
        _must(["nbgrader", command, SLUG], course, teacher)
    _must(["nbgrader", "fetch_assignment", SLUG], homes[student], student)
    return exchange / NAME, homes


def _must(command, folder, user):
    done = subprocess.run([*map(str, command)], cwd=folder, capture_output=True, text=True, **_as(user))
    if done.returncode:
        raise SystemExit(f"{command}: {done.stderr}")


def through_the_exchange(folder, kills, rng, teacher, student):
    """The student hands in while the teacher's command is killed again and again."""
    exchange, homes = made_exchange(folder, teacher, student)
    out, pipe = homes[teacher] / "results", {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    nbgrader = subprocess.Popen([sys.executable, "-c", NBGRADER], cwd=homes[student], **pipe, **_as(student))

    def nbgrader_does(*command):
        nbgrader.stdin.write(" ".join(command) + "\n")
        nbgrader.stdin.flush()
        if int(nbgrader.stdout.readline()):
            raise SystemExit((homes[student] / "log.txt").read_text())

    handed_in = 0
    for _ in range(kills):
        process = watch(exchange, out, user=teacher)
        for _ in range(2):
            (homes[student] / SLUG / f"{SLUG}.py").write_text(f"{TEXT}\n# {handed_in}\n{HALF if handed_in % 2 else ''}")
            nbgrader_does("submit", SLUG)
            handed_in += 1
        time.sleep(rng.uniform(0.0, 8.0))
        with contextlib.suppress(ProcessLookupError):
            os.kill(process.pid, signal.SIGKILL)
        process.wait()
    if watch(exchange, out, "--once", user=teacher).wait():
        raise SystemExit("watch --once failed")
    nbgrader_does("fetch_feedback", SLUG)
    nbgrader.stdin.close()
    nbgrader.wait()
    done = graded(out)
    times = [Path(event["origin"]).parent.name for event in done]
    right = [event["record"]["score"] == 10 for event in done]
    return {
        "hand-ins": handed_in,
        "kills": kills,
        "graded": len({*times}),
        "graded twice": len(times) - len({*times}),
        "out of order": sum(a > b for a, b in zip(times, times[1:], strict=False)),
        "with another's score": sum(is_right != (n % 2 == 0) for n, is_right in enumerate(right)),
        "pages that the student fetched": len(list((homes[student] / SLUG / "feedback").rglob("*.html"))),
        "rows of grades": (out / "grades.csv").read_text().splitlines()[1:],
    }


def main():
    parser = argparse.ArgumentParser(description="Let a class hand in while `watch` grades, and kill it.")
    for name, default in (("--submissions", 500), ("--seconds", 60), ("--kills", 20), ("--seed", 1)):
        parser.add_argument(name, type=int, default=default)
    parser.add_argument("--users", nargs=2, metavar=("TEACHER", "STUDENT"), help="two Unix users; this needs root")
    options = parser.parse_args()
    outcomes = {}
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        if options.submissions:
            outcomes["in a folder"] = in_a_minute(Path(folder), options.submissions, options.seconds)
        if options.users:
            rng = random.Random(options.seed)
            outcomes["in nbgrader's exchange"] = through_the_exchange(Path(folder), options.kills, rng, *options.users)
    print(json.dumps(outcomes, indent=1))
    record.write(record.RESULTS / "arrivals.json", **outcomes)


if __name__ == "__main__":
    main()
