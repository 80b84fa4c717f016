"""The command `tam570-grader watch`, which grades submissions when they arrive."""

import argparse
import contextlib
import math
import re
from pathlib import Path

from tam570.values import Json
from tam570_grader.cli.grade import warn_of_isolation
from tam570_grader.cli.options import positive
from tam570_grader.course import course_config
from tam570_grader.errors import UsageError, say, writing
from tam570_grader.grading import seeds
from tam570_grader.grading.executor import cores, executor
from tam570_grader.grading.watch import COPIES, KEY, Policy, Queue, Watcher
from tam570_grader.reports import feedback
from tam570_grader.results.store import ResultStore

UNITS = {"s": 1, "m": 60, "h": 3600, "d": 86400}


def add_watch(parser: argparse.ArgumentParser) -> None:
    """Add the options of `watch`."""
    parser.set_defaults(command=_watch)
    parser.description = (
        "Grade submissions when they arrive in a folder, or in a course of nbgrader's exchange, and put "
        "the page of feedback back: beside the work, or where `nbgrader fetch_feedback` finds it. Each attempt has "
        "hidden inputs of its own."
    )
    parser.epilog = (
        "DIR/status.html shows who waits and who has which score, and reloads itself. If the command ends, run "
        "it again; it continues from there."
    )
    add = parser.add_argument
    add("source", type=Path, metavar="SOURCE", help="a tree of submissions, or a course in nbgrader's exchange")
    add("--out", type=Path, metavar="DIR", required=True, help="write results, copies, the status page there")
    add("--attempts", type=positive, metavar="N", help="attempts of a student at an assignment (default: no limit)")
    add("--every", type=_duration, metavar="15m", default=0.0, help="time between two attempts: 30s, 15m, 2h, 1d")
    add("--count", choices=["best", "last"], default="best", help="the attempt that counts (default: %(default)s)")
    add("--assignment", metavar="SLUG", help="the assignment, if no name tells it")
    add("--jobs", type=positive, metavar="N", default=cores(), help="supervisors (default: %(default)s)")
    add("--once", action="store_true", help="grade what has arrived and may be graded, then end")


def _duration(text: str) -> float:
    if not (match := re.fullmatch(r"(\d{1,6})([smhd])", text)):
        raise argparse.ArgumentTypeError(f"{text!r} is not a time such as 30s, 15m, 2h or 1d")
    return float(match[1]) * UNITS[match[2]]


def _watch(arguments: argparse.Namespace) -> int:
    course = course_config.course_of(arguments.root, [arguments.source])
    feedback.must_write_pages()
    warn_of_isolation()
    if not arguments.source.is_dir():
        raise UsageError(f"{arguments.source} is not a folder: name the one into which work is handed in")
    with writing(arguments.out):
        (arguments.out / COPIES).mkdir(parents=True, exist_ok=True)
    with contextlib.closing(ResultStore(arguments.out)) as store, executor(arguments.jobs) as jobs:
        policy = Policy(arguments.attempts or math.inf, arguments.every, arguments.count)
        queue = Queue(arguments.out, policy)
        secret = seeds.key(arguments.out / KEY, bool(queue.graded))
        options: Json = {name: vars(arguments)[name] for name in ("assignment", "jobs", "once")}
        desk = Watcher(arguments.source, course, queue, store, jobs, secret, **options)
        try:
            desk.work()
        except KeyboardInterrupt:
            raise KeyboardInterrupt(desk.summary()) from None
        say(desk.summary())
    return 0
