"""Gradings by the thousand, to judge the grader: on several processes, each with warm workers of its own."""

from dataclasses import dataclass, replace
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading.run_checks import CheckOptions, Recorder, graded
from tam570_grader.results.records import Result
from tam570_grader.sandbox import pool
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source
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
    source, options = Source(grading.text.encode()), CheckOptions(grading.enough, recorder, grading.naming)
    return pool.tried(
        lambda zygote, _: graded(grading.name, source, assignment, zygote, grading.seed, options=options),
        sorted({*assignment.needs, *imported(source.text)}),
        grading.limits,
        [grading.course],
    )


def submissions(course: Path, slug: str, folder: str) -> dict[str, str]:
    """Return the texts of the alternatives or mistakes of an assignment, by name."""
    if folder == "mistakes":
        return overlays(assignments.checks_folder(course, slug))
    paths = sorted((assignments.checks_folder(course, slug) / folder).glob("*.py"))
    return {path.stem: path.read_text(encoding="utf-8") for path in paths}
