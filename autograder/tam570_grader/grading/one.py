"""Grades one submission: runs the checks of its assignment in order and makes the result line."""

import time
import zlib
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

import numpy as np

from tam570_grader.grading.speed import Speed, Yardstick
from tam570_grader.sandbox.inside.wire import packed
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.replies import sent
from tam570_grader.sandbox.student import BudgetSpent, Call, NotLoaded, NotWritten, Source, Student
from tam570_grader.sandbox.worker import Worker, WorkerLost
from tam570_grader.writing.assignments import Assignment
from tam570_grader.writing.check import Check, Failure, Suspect
from tam570_grader.writing.curves import Curve

__all__ = ["Mark", "Result", "failed_by_us", "generator", "graded", "not_graded"]

OUR_FAULT = "the grader failed here, not you; your teacher has been told"
CANCELLED = 1e-14  # what rounding leaves where numbers of order one cancel, and a suspect is exactly zero
LONGEST_DETAIL = 400  # characters of an expected or actual value


@dataclass(frozen=True)
class Mark:
    """The outcome of one check. `detail` is the instructor's: expected, actual, and the very input."""

    name: str
    part: str
    points: float | None
    max_points: float
    outcome: str  # passed, failed, not_run, grader_error
    message: str
    suspect: str | None = None
    detail: dict[str, str] = field(default_factory=dict)
    picture: Curve | None = None


@dataclass(frozen=True)
class Result:
    """The outcome of one submission."""

    student: str
    assignment: str
    status: str  # graded, missing, unreadable, timeout, crashed
    score: float | None
    max_score: float
    seed: int
    seconds: float
    isolation: str
    checks: tuple[Mark, ...]
    message: str = ""
    speed: Speed | None = None

    def record(self) -> dict[str, Any]:
        """The result line as plain data; a message or a speed that there is not is left out."""
        optional = {"message": "", "speed": None}
        return {key: value for key, value in asdict(self).items() if key not in optional or value != optional[key]}


def graded(
    name: str,
    source: Source,
    assignment: Assignment,
    worker: Worker,
    seed: int,
    yardstick: Yardstick | None = None,
    enough: int | None = None,
    forgiving: bool = False,
    again: bool = False,
) -> Result:
    """Grade one submission of the student `name`; the same submission and seed give the same score.

    yardstick : measures the speed of the simulation too, when all is graded
    enough    : failed checks after which the rest is not run
    forgiving : raise WorkerLost where the submission was killed by a stranger, instead of failing it
    again     : an earlier try may have told it hidden inputs
    """
    started = time.perf_counter()
    student = Student(source, assignment, worker, forgiving, again)
    marks: dict[str, Mark] = {}
    status, message, speed = "graded", "", None
    try:
        student.load()
        for check in assignment.checks:
            marks[check.name] = _mark(check, student, assignment, seed, marks)
            if enough and sum(mark.outcome == "failed" for mark in marks.values()) >= enough:
                break
        message = _skipped(student.skipped)
        speed = yardstick.speed(student, assignment, worker) if yardstick else None
    except NotLoaded as failure:
        status, message = failure.status, str(failure)
    except BudgetSpent as spent:
        status, message = "timeout", str(spent)
    finally:
        student.leave()
    rest = tuple(marks.get(check.name) or _not_run(check, message) for check in assignment.checks)
    seconds = time.perf_counter() - started
    return replace(_result(name, assignment, status, seed, seconds, rest, message), speed=speed)


def not_graded(name: str, assignment: Assignment, status: str, message: str, seed: int) -> Result:
    """The result of a submission that is missing or cannot be read: score 0, no check run."""
    return _result(name, assignment, status, seed, 0.0, tuple(_not_run(c, message) for c in assignment.checks), message)


def failed_by_us(name: str, assignment: Assignment, error: str, seed: int) -> Result:
    """The result where the grader could not do its work: no score."""
    marks = tuple(_grader_error(check, error) for check in assignment.checks)
    return _result(name, assignment, "graded", seed, 0.0, marks, OUR_FAULT)


def _grader_error(check: Check, error: str) -> Mark:
    detail = {"error": error[:LONGEST_DETAIL]}
    return Mark(check.name, check.part, None, check.points, "grader_error", OUR_FAULT, detail=detail)


def _result(
    name: str, assignment: Assignment, status: str, seed: int, seconds: float, marks: tuple[Mark, ...], message: str
) -> Result:
    points = [mark.points for mark in marks]
    score = None if None in points else round(sum(p for p in points if p is not None), 6)
    return Result(
        name, assignment.slug, status, score, assignment.max_score, seed, round(seconds, 3), isolation(), marks, message
    )


def _mark(check: Check, student: Student, assignment: Assignment, seed: int, marks: dict[str, Mark]) -> Mark:
    """Run one check, unless one that it builds on has not passed."""
    missing = [name for name in check.after if marks[name].outcome != "passed"]
    if missing:
        return _not_run(check, f"not run before this passes: {_line(assignment.checks, missing[0])}")
    student.calls.clear()
    draw = generator(seed, assignment.slug, check)
    try:
        with np.errstate(all="ignore"):
            check.judge(student, draw)
    except NotWritten as unwritten:
        return _not_run(check, f"{unwritten} is not written yet")
    except Failure as failure:
        return _failed(check, failure, student.calls)
    except (NotLoaded, BudgetSpent, WorkerLost):
        raise
    except Exception as error:
        return _grader_error(check, repr(error))
    return Mark(check.name, check.part, check.points, check.points, "passed", check.line)


def generator(seed: int, slug: str, check: Check) -> np.random.Generator:
    """What draws the hidden inputs of a check."""
    return np.random.default_rng([seed, zlib.crc32(f"{slug}.{check.name}".encode())])


def _failed(check: Check, failure: Failure, calls: Sequence[Call]) -> Mark:
    try:
        suspect, fault = next((one.says for one in check.suspects if agrees(one, calls)), None), None
    except Exception as error:  # a mistake without a name is no reason to lose a grade
        suspect, fault = None, error
    message = f"{failure}; it matches the result with {suspect}" if suspect else str(failure)
    points = round(failure.fraction * check.points, 6)
    detail = {"expected": failure.expected, "actual": failure.actual, "at": failure.at, "naming": fault}
    shown = {key: repr(value)[:LONGEST_DETAIL] for key, value in detail.items() if value is not None}
    return Mark(check.name, check.part, points, check.points, "failed", message, suspect, shown, failure.picture)


def _not_run(check: Check, message: str) -> Mark:
    return Mark(check.name, check.part, 0.0, check.points, "not_run", message)


def _line(checks: Sequence[Check], name: str) -> str:
    return next(check.line for check in checks if check.name == name)


def _skipped(cells: Sequence[str]) -> str:
    return f"notebook cells that raised were skipped: {'; '.join(cells)}" if cells else ""


def agrees(suspect: Suspect, calls: Sequence[Call]) -> bool:
    """Whether the student's results are the suspect's, in every call to the functions that it has variants of."""
    concerned = [call for call in calls if call.name in suspect.variants]
    returned = any(call.result is not None for call in concerned)
    return returned and all(_same(call, suspect) for call in concerned)


def _same(call: Call, suspect: Suspect) -> bool:
    try:
        with np.errstate(all="ignore"):
            wrong = _answer(suspect, call)
    except (ArithmeticError, ValueError):
        return call.result is None  # a wrong formula may have no value where the right one has one
    if call.result is None:
        return not all(np.all(np.isfinite(part)) for part in _parts(wrong))
    pairs = zip(_parts(call.result), _parts(wrong), strict=True)
    return all(_close(found, expected, suspect.within) for found, expected in pairs)


def _answer(suspect: Suspect, call: Call) -> Any:
    """The suspect's result of a call, computed a single time for all students who are given the same inputs."""
    variant, asked = suspect.variants[call.name], call.given
    key = packed([call.name, sent(asked)])
    return suspect.answers.value(key, lambda: variant(*asked.args, **asked.kwargs))


def _parts(result: Any) -> list[Any]:
    return list(result) if isinstance(result, tuple) else [result]


def _close(found: Any, expected: Any, within: float) -> bool:
    found, expected = np.asarray(found, float), np.asarray(expected, float)
    if found.shape != expected.shape:
        return False
    if not np.all(np.isfinite(expected)):
        return bool(np.array_equal(found, expected))
    with np.errstate(all="ignore"):
        return bool(np.max(np.abs(found - expected)) <= within * np.max(np.abs(expected)) + CANCELLED)
