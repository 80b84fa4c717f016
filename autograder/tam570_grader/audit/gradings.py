"""Gradings by the thousand, to judge the grader: on several processes, each with warm workers of its own."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import NotWritten
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading.run_checks import CheckOptions, Recorder, generator, graded
from tam570_grader.results.records import Result
from tam570_grader.sandbox import pool
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import ResourceLimits


@dataclass(frozen=True)
class Grading:
    """One grading: a source, by some of the checks, with one seed."""

    course: Path
    slug: str
    name: str
    text: str
    seed: int
    limits: ResourceLimits = ResourceLimits()
    checks: frozenset[str] | None = None  # None: all
    enough: int | None = None  # failed checks after which the rest is not run
    naming: bool = False  # look for the mistakes behind failed checks


def tried(grading: Grading, recorder: Recorder | None = None) -> Result:
    """Return the result of a grading, on a worker of this process."""
    assignment = assignments.assignment(grading.course, grading.slug)
    if grading.checks is not None:
        chosen = tuple(check for check in assignment.checks if check.name in grading.checks)
        free = (replace(check, after=tuple(set(check.after) & set(chosen))) for check in chosen)
        assignment = replace(assignment, checks=tuple(free))
    return _graded(grading, assignment, CheckOptions(grading.enough, recorder, grading.naming))


def seeds_that_fail(grading: Grading, name: str, seeds: Sequence[int]) -> set[int]:
    """Return the seeds with which a submission fails a check, run with all of them in one sandbox.

    A function that hung or crashed fails from then on, whatever the seed: the seeds after it are left out.
    """
    assignment = assignments.assignment(grading.course, grading.slug)
    check = next(check for check in assignment.checks if check.name == name)
    checks = tuple(_with_seed(check, grading.slug, seed) for seed in seeds)
    result = _graded(grading, replace(assignment, checks=checks), CheckOptions(naming=False))
    return {int(copy.name) for copy in result.checks if copy.outcome == "failed" and copy.points != copy.max_points}


def _with_seed(check: Check, slug: str, seed: int) -> Check:
    """Return the check with the inputs that it draws with a seed, named by that."""

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


def submissions(course: Path, slug: str, folder: str) -> dict[str, str]:
    """Return the texts of the alternatives or mistakes of an assignment, by name."""
    if folder == "mistakes":
        return overlays(assignments.checks_folder(course, slug))
    paths = sorted((assignments.checks_folder(course, slug) / folder).glob("*.py"))
    return {path.stem: path.read_text(encoding="utf-8") for path in paths}
