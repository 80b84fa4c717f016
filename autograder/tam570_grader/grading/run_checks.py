"""Grade one submission: run the checks of its assignment in order and return the result."""

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from types import SimpleNamespace

import numpy as np

from tam570.meter import Exhausted
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.check import Check
from tam570_grader.checks.expect import LONGEST_FAULT, Failed, NotWritten, check_context
from tam570_grader.grading.budget import budget
from tam570_grader.grading.consequences import Run, failure_result, judge_blocked, judge_failure, passed_result
from tam570_grader.grading.seeds import generator
from tam570_grader.grading.speed import speed_of
from tam570_grader.results.records import CheckResult, Result
from tam570_grader.sandbox.imports import NotLoaded
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.pool import ONLY, Attempt
from tam570_grader.sandbox.student import BudgetSpent, Source, Student
from tam570_grader.sandbox.zygote import Zygote

OUR_FAULT = "The grader failed here, not you; your teacher has been told."
TOO_MUCH = "what it returns takes the grader too much {} to judge"
Recorder = Callable[[str, float], None]


@dataclass(frozen=True)
class CheckOptions:
    """Options of a run of the checks; audits of the grader switch parts of it off.

    enough    : number of failed checks after which the rest are not run; None: run all
    recorder  : called with the name of the check and each error divided by its limit; then no comparison fails
    naming    : diagnose each failed check
    speed     : also measure the run time of the simulation, after the checks
    attempt   : which try of the submission this is
    """

    enough: int | None = None
    recorder: Recorder | None = None
    naming: bool = True
    speed: bool = False
    attempt: Attempt = ONLY


def graded(
    name: str,
    source: Source,
    assignment: LoadedAssignment,
    zygote: Zygote,
    seed: int,
    options: CheckOptions = CheckOptions(),  # noqa: B008  it is frozen
) -> Result:
    """Grade one submission of the student `name`; the same submission and seed give the same score."""
    started = time.perf_counter()
    student = Student(source, assignment, zygote, options.attempt)
    run = Run(student, assignment, seed)
    status, message, speed = "graded", "", None
    try:
        student.load()
        for check in assignment.checks:
            failed = sum(result.outcome == "failed" for result in run.results.values())
            if not options.enough or failed < options.enough:
                run.results[check.name] = _check_result(run, check, options)
        if student.skipped:
            message = f"Notebook cells that raised were skipped: {'; '.join(student.skipped)}"
        speed = speed_of(student, assignment, zygote) if options.speed else None
        if not options.enough:
            judge_blocked(run)
    except (NotLoaded, BudgetSpent) as ended:
        status, message = ended.status, str(ended)
    finally:
        student.leave()
    message = " ".join(filter(None, (source.remark, message)))
    rest = tuple(run.results.get(check.name) or _not_run(check, message) for check in assignment.checks)
    seconds = time.perf_counter() - started
    return replace(_result(name, assignment, status, message, seed, rest), seconds=round(seconds, 3), speed=speed)


@dataclass(frozen=True)
class _NoStudent:
    """Stand-in for a student in `rehearse`: its functions have only `name` and `returns`, which comparisons read."""

    assignment: LoadedAssignment

    def __getattr__(self, name: str) -> SimpleNamespace:
        return SimpleNamespace(name=name, returns=self.assignment.returns[name])


def rehearse(assignment: LoadedAssignment, seed: int) -> None:
    """Run all checks without a submission, so that this process caches their expected results.

    A check that needs more of a student than results to compare ends early. Errors are ignored here: they recur, and
    are reported, when a submission is graded.
    """
    with np.errstate(all="ignore"):
        for check in assignment.checks:
            with suppress(Exception), budget(), check_context(is_rehearsal=True):
                check.run(_NoStudent(assignment), generator(seed, assignment.slug, check))


def not_graded(name: str, assignment: LoadedAssignment, status: str, message: str, seed: int) -> Result:
    """Return the result of a missing or unreadable submission: score 0, no check run."""
    check_results = tuple(_not_run(check, message) for check in assignment.checks)
    return _result(name, assignment, status, message, seed, check_results)


def failed_by_us(name: str, assignment: LoadedAssignment, error: str, seed: int) -> Result:
    """Return the result if the grader failed: no score."""
    check_results = tuple(_grader_error(check, error) for check in assignment.checks)
    return _result(name, assignment, "graded", OUR_FAULT, seed, check_results)


def _result(
    name: str,
    assignment: LoadedAssignment,
    status: str,
    message: str,
    seed: int,
    check_results: tuple[CheckResult, ...],
) -> Result:
    points = [check_result.points for check_result in check_results]
    score = None if None in points else round(sum(p for p in points if p is not None), 6)
    most = assignment.max_score
    return Result(name, assignment.slug, status, score, most, seed, 0.0, isolation(), check_results, message)


def _check_result(run: Run, check: Check, options: CheckOptions) -> CheckResult:
    """Run one check and judge its failure; do not run it if a prerequisite is wrong or missing."""
    student = run.student
    for other in check.after:
        before = run.results[other.name]
        if not (before.unlocks_dependents or (check.refusals and other.function in student.worked)):
            return _not_run(check, f"Not run: it needs “{other.title.rstrip('.')}” to pass first.")
    try:
        run.perform(check, options.recorder and partial(options.recorder, check.name))
    except NotWritten as unwritten:
        return _not_run(check, student.describe_missing(str(unwritten)), unwritten=str(unwritten))
    except Failed as failed:
        return judge_failure(run, check, failed, naming=options.naming)
    except (Exhausted, MemoryError) as spent:
        message = TOO_MUCH.format("memory" if isinstance(spent, MemoryError) else "work")
        return failure_result(check, Failed(message, at=student.calls[-1].case if student.calls else None))
    except Exception as error:
        return _grader_error(check, repr(error))
    run.passing.extend(student.calls)
    return passed_result(check)


def _not_run(check: Check, message: str, unwritten: str = "") -> CheckResult:
    return CheckResult(check.name, check.part, 0.0, check.points, "not_run", message, unwritten=unwritten)


def _grader_error(check: Check, error: str) -> CheckResult:
    return CheckResult(
        check.name, check.part, None, check.points, "grader_error", OUR_FAULT, error=error[:LONGEST_FAULT]
    )
