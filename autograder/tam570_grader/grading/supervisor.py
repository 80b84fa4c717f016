"""Grade single submissions in a supervisor, each to a complete result line."""

import json
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from tam570_grader.checks import assignments, expected
from tam570_grader.errors import UsageError
from tam570_grader.grading.run_checks import CheckOptions, failed_by_us, graded, not_graded, rehearse
from tam570_grader.grading.submissions import CannotRead
from tam570_grader.results.records import Result
from tam570_grader.sandbox.launch import write_bytecode
from tam570_grader.sandbox.pool import Attempt, start, tried, zygote
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.zygote import NotConfined, ResourceLimits, Zygote, ZygoteLost


@dataclass(frozen=True)
class WorkerConfig:
    """Configuration that all submissions of a run share."""

    limits: ResourceLimits
    hidden: tuple[Path, ...] = ()
    preload: tuple[str, ...] = ()  # packages, besides those that the assignment needs
    speed: bool = False
    shared: Path | None = None  # folder in which this machine's supervisors share expensive expected results


@dataclass(frozen=True)
class GradeTask:
    """A submission to grade; `source` contains its bytes, or says why there are none."""

    course: Path
    student: str
    slug: str
    seed: int
    source: Source | CannotRead
    digest: str = ""
    missing: bool = False
    conditions: WorkerConfig = WorkerConfig(ResourceLimits())


def prepare(course: Path, slugs: Sequence[str], conditions: WorkerConfig, seed: int | None) -> None:
    """Start the zygotes of assignments and load their checks while these start; processes forked later inherit both.

    Only the first zygote is tried out: waiting for the others may take longer than grading the first submissions. The
    loss of a zygote is ignored here; it recurs when a submission needs it.

    seed : the class's seed, for which the checks are rehearsed; None if each student has another
    """
    for slug in slugs:
        start(*_sandbox(course, slug, conditions))
    write_bytecode()
    for slug in slugs:
        assignment = assignments.assignment(course, slug)
        zygote(*_sandbox(course, slug, conditions)).compile_steps(assignment.states)
        if seed is not None:
            rehearse(assignment, seed)
    for slug in slugs[:1]:
        with suppress(ZygoteLost):
            zygote(*_sandbox(course, slug, conditions)).try_out()


def _sandbox(course: Path, slug: str, conditions: WorkerConfig) -> tuple[list[str], ResourceLimits, list[Path]]:
    """Return the packages that an assignment's zygote imports, the limits, and the folders that it must not see."""
    needs, forbidden = assignments.sandbox_imports(course, slug)
    preload = sorted({*needs, *conditions.preload}.difference(forbidden))
    return preload, conditions.limits, [*dict.fromkeys([course, *conditions.hidden])]


def line(task: GradeTask) -> bytes:
    """Return the result line of a submission."""
    return _line(task, result(task))


def lost(task: GradeTask, error: str) -> bytes:
    """Return the result line of a submission on which every supervisor died: a grader error."""
    return _line(task, failed_by_us(task.student, assignments.assignment(task.course, task.slug), error, task.seed))


def _line(task: GradeTask, result: Result) -> bytes:
    notebook = isinstance(task.source, Source) and task.source.notebook
    complete = replace(result, digest=task.digest, notebook=notebook)
    return json.dumps(complete.record(), allow_nan=False).encode() + b"\n"


def result(task: GradeTask) -> Result:
    """Return the result of a submission, without a score if the grader failed; UsageError if it cannot be confined."""
    assignment, source = assignments.assignment(task.course, task.slug), task.source
    if isinstance(source, CannotRead):
        status = "missing" if task.missing else "unreadable"
        return not_graded(task.student, assignment, status, str(source), task.seed)

    def grade(zygote: Zygote, attempt: Attempt) -> Result:
        options = CheckOptions(speed=task.conditions.speed, attempt=attempt)
        return graded(task.student, source, assignment, zygote, task.seed, options)

    try:
        with expected.sharing(task.conditions.shared):
            return tried(grade, *_sandbox(task.course, task.slug, task.conditions))
    except NotConfined as why:
        message = f"submissions cannot be confined on this machine, and without that none is graded: {why}"
        raise UsageError(message) from None
    except UsageError:
        raise
    except ZygoteLost as lost:
        return failed_by_us(task.student, assignment, str(lost), task.seed)
    except Exception as fault:
        return failed_by_us(task.student, assignment, repr(fault), task.seed)
