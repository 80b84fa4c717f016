"""Grade submissions for audits, by the thousand, in the sandboxes of a worker process."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import NotWritten
from tam570_grader.grading.run_checks import CheckOptions, Recorder, graded
from tam570_grader.grading.seeds import generator
from tam570_grader.results.records import Result
from tam570_grader.sandbox import pool
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import ResourceLimits


@dataclass(frozen=True)
class Grading:
    """A submission to grade by some of the checks, with one seed."""

    course: Path
    slug: str
    name: str
    text: str
    seed: int
    limits: ResourceLimits = ResourceLimits()
    checks: frozenset[str] | None = None  # names; None: all
    enough: int | None = None  # number of failed checks after which the rest are not run
    naming: bool = False  # diagnose failed checks


def tried(grading: Grading, recorder: Recorder | None = None) -> Result:
    """Return the result of a grading in a sandbox of this process; prerequisites that are not chosen are ignored."""
    assignment = assignments.assignment(grading.course, grading.slug)
    if grading.checks is not None:
        chosen = tuple(check for check in assignment.checks if check.name in grading.checks)
        free = (replace(check, after=tuple(set(check.after) & set(chosen))) for check in chosen)
        assignment = replace(assignment, checks=tuple(free))
    return _graded(grading, assignment, CheckOptions(grading.enough, recorder, grading.naming))


def seeds_that_fail(grading: Grading, name: str, seeds: Sequence[int]) -> set[int]:
    """Return the seeds with which a submission fails a check; all seeds run in one sandbox process.

    A function that hangs or crashes fails at every later call, so the seeds after that are left out.
    """
    assignment = assignments.assignment(grading.course, grading.slug)
    check = next(check for check in assignment.checks if check.name == name)
    checks = tuple(_with_seed(check, grading.slug, seed) for seed in seeds)
    result = _graded(grading, replace(assignment, checks=checks), CheckOptions(naming=False))
    return {int(copy.name) for copy in result.checks if copy.outcome == "failed" and copy.points != copy.max_points}


def _with_seed(check: Check, slug: str, seed: int) -> Check:
    """Return a check that always uses this seed, without prerequisites; its name is the seed."""

    def run(student: Student, _: np.random.Generator) -> None:
        if student.broken:
            raise NotWritten(check.function)
        check.run(student, generator(seed, slug, check))

    run.__name__ = str(seed)
    return replace(check, run=run, after=())


def _graded(grading: Grading, assignment: LoadedAssignment, options: CheckOptions) -> Result:
    source = Source(grading.text.encode())
    needs = sorted({*assignment.needs, *imported(source.text)})
    return pool.tried(
        lambda zygote, _: graded(grading.name, source, assignment, zygote, grading.seed, options=options),
        needs,
        grading.limits,
        [grading.course],
    )
