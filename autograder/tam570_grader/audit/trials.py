"""Gradings by the thousand, to judge the grader: on several processes, each with warm workers of its own."""

import multiprocessing
import signal
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

from tam570_grader.grading.one import Recorder, Result, graded
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.worker import Allowance, Worker, WorkerLost
from tam570_grader.writing import assignments

__all__ = ["Trial", "done", "progress", "sandboxes", "submissions", "tried"]

Task = TypeVar("Task")
Outcome = TypeVar("Outcome")
TRIES = 3  # workers that a submission may see die under it
_warm: dict[tuple[Any, ...], Worker] = {}  # of this process


@dataclass(frozen=True)
class Trial:
    """One grading: a source, by some of the checks, with one seed."""

    course: Path
    slug: str
    name: str
    text: str
    seed: int
    allowance: Allowance = Allowance()
    checks: frozenset[str] | None = None  # None: all
    enough: int | None = None  # failed checks after which the rest is not run


def tried(trial: Trial, recorder: Recorder | None = None) -> Result:
    """The result of a trial, on a worker of this process."""
    assignment = assignments.assignment(trial.course, trial.slug)
    if trial.checks is not None:
        kept = [check for check in assignment.checks if check.name in trial.checks]
        free = (replace(check, after=tuple(set(check.after) & trial.checks)) for check in kept)
        assignment = replace(assignment, checks=tuple(free))
    source = Source(trial.text.encode())
    needs = sorted({*assignment.needs, *imported(source.text)})
    for last in (False,) * (TRIES - 1) + (True,):
        worker = _worker(needs, trial)
        try:
            return graded(trial.name, source, assignment, worker, trial.seed, enough=trial.enough, recorder=recorder)
        except WorkerLost:
            _warm.pop(_key(needs, trial)).close()
            if last:
                raise
    raise AssertionError("the last try returns or raises")


def _key(needs: Sequence[str], trial: Trial) -> tuple[Any, ...]:
    return (*needs, trial.allowance, trial.course)


def _worker(needs: Sequence[str], trial: Trial) -> Worker:
    key = _key(needs, trial)
    if key not in _warm:
        _warm[key] = Worker(list(needs), trial.allowance, [trial.course])
    return _warm[key]


@contextmanager
def sandboxes() -> Iterator[None]:
    """Ends the workers of this process."""
    try:
        yield
    finally:
        while _warm:
            _warm.popitem()[1].close()


def done(work: Callable[[Task], Outcome], tasks: Iterable[Task], jobs: int) -> Iterator[Outcome]:
    """What the work makes of each task, in the tasks' order; an interrupt ends all processes."""
    with ExitStack() as stack:
        stack.enter_context(sandboxes())
        if jobs == 1:
            yield from map(work, tasks)
            return
        pool = stack.enter_context(multiprocessing.get_context("spawn").Pool(jobs, _deaf))
        yield from pool.imap(work, tasks)


def _deaf() -> None:
    """Interrupts are the parent's to hear."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def progress(outcomes: Iterable[Outcome], total: int, unit: str) -> Iterator[Outcome]:
    """The outcomes, with a bar on a terminal."""
    from tqdm import tqdm

    yield from tqdm(outcomes, total=total, unit=unit, leave=False, disable=None)


def submissions(course: Path, slug: str, kind: str) -> dict[str, str]:
    """The texts of the alternatives or mistakes of an assignment, by name."""
    paths = sorted((assignments.checks_folder(course, slug) / kind).glob("*.py"))
    return {path.stem: path.read_text(encoding="utf-8") for path in paths}
