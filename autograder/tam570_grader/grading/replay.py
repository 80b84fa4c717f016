"""The command that shows a failure whole: `tam570-grader replay RESULTS STUDENT CHECK [FILE]`."""

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from tam570_grader.errors import UsageError
from tam570_grader.options import Commands

__all__ = ["add_replay"]


def add_replay(commands: Commands) -> argparse.ArgumentParser:
    replay: argparse.ArgumentParser = commands.add_parser(
        "replay",
        help="show the input, the expected and the actual value of a failed check",
        description="Print the very call that failed a check, with all digits. With FILE, make that call again.",
    )
    replay.set_defaults(command=_replay)
    add = replay.add_argument
    add("results", type=Path, metavar="RESULTS", help="what `grade --out` wrote")
    add("student", metavar="STUDENT")
    add("check", metavar="CHECK", help="the name of the check, as in results.jsonl")
    add("file", nargs="?", type=Path, metavar="FILE", help="a module of the student's, to make the call again")
    return replay


def _replay(arguments: argparse.Namespace) -> int:
    from tam570_grader.pages.sentences import message

    slug, why = _failure(arguments.results, arguments.student, arguments.check)
    print(f"{arguments.student}, {slug}, {arguments.check}: {message(why)}")
    given: dict[str, Any] = why.at if isinstance(why.at, dict) else {"args": [why.at], "kwargs": {}}
    told = [*map(_digits, given["args"]), *(f"{name}={_digits(value)}" for name, value in given["kwargs"].items())]
    print(f"\n{why.function}({', '.join(told)})")
    print(f"\nexpected: {_digits(why.expected)}\nactual:   {_digits(why.actual)}")
    if arguments.file:
        print(f"now:      {_digits(_again(arguments, slug, why.function, given))}")
    return 0


def _failure(results: Path, student: str, check: str) -> tuple[str, Any]:
    """The assignment and the failure; UsageError where there is none."""
    from tam570_grader.results import journal, records

    lines = [line for line in journal.read(results) if line["student"] == student]
    if not lines:
        raise UsageError(f"{results} has no result of {student}")
    marks = [(one.assignment, mark) for one in map(records.read, lines) for mark in one.checks if mark.failure]
    for slug, mark in marks:
        if mark.name == check and mark.failure:
            return slug, mark.failure
    failed = ", ".join(mark.name for _, mark in marks) or "none"
    raise UsageError(f"{student} did not fail {check}; failed checks: {failed}")


def _again(arguments: argparse.Namespace, slug: str, function: str, given: dict[str, Any]) -> Any:
    """What the function of the file gives at this input, in the sandbox."""
    from tam570_grader.delivery import own
    from tam570_grader.sandbox.student import Source, Student
    from tam570_grader.sandbox.worker import Allowance, Worker
    from tam570_grader.writing import assignments
    from tam570_grader.writing.expect import Failed

    root = own.course(arguments.root)
    assignment = assignments.assignment(root, slug)
    worker = Worker(sorted(assignment.needs), Allowance(), [root])
    student = Student(Source(arguments.file.read_bytes()), assignment, worker)
    try:
        student.load()
        return getattr(student, function)(*map(_numbers, given["args"]), **_named(given["kwargs"]))
    except Failed as failed:
        return failed.failure.says
    finally:
        student.leave()
        worker.close()


def _named(values: dict[str, Any]) -> dict[str, Any]:
    return {name: _numbers(value) for name, value in values.items()}


def _numbers(value: Any) -> Any:
    """A list of numbers as the array that it was."""
    return np.array(value) if isinstance(value, list) and np.array(value).dtype.kind in "fi" else value


def _digits(value: Any) -> str:
    """A value as Python, with all digits."""
    if isinstance(value, np.ndarray):
        return f"np.array({value.tolist()})"
    return repr(value)
