"""The command `tam570-grader replay RESULTS STUDENT CHECK [FILE]`, which shows all data of a failure."""

import argparse
import contextlib
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from tam570.values import Json, Numbers
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import match_slugs
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, NotWritten
from tam570_grader.checks.failure import Failure
from tam570_grader.checks.returns import Drawing, Formula
from tam570_grader.course import course_config
from tam570_grader.errors import Over, UsageError, say
from tam570_grader.grading.submissions import CannotRead, Submission, read
from tam570_grader.reports.sentences import describe_failure
from tam570_grader.results import store
from tam570_grader.sandbox import pool
from tam570_grader.sandbox.function import SandboxFunction
from tam570_grader.sandbox.student import Student
from tam570_grader.sandbox.zygote import ResourceLimits


def add_replay(parser: argparse.ArgumentParser) -> None:
    """Add the options of `replay`."""
    parser.set_defaults(command=_replay)
    parser.description = "Print the very call that failed a check, with all digits. With FILE, make that call again."
    add = parser.add_argument
    add("results", type=Path, metavar="RESULTS", help="what `grade --out` wrote")
    add("student", metavar="STUDENT")
    add("check", metavar="CHECK", help="the name of the check, as in results.jsonl")
    add("file", nargs="?", type=Path, metavar="FILE", help="a module or notebook, to make the call again")
    add("--assignment", metavar="SLUG", help="the assignment, if two have a check of this name")


def _replay(arguments: argparse.Namespace) -> int:
    slug, why = _failure(arguments.results, arguments.student, arguments.check, arguments.assignment)
    say(f"{arguments.student}, {slug}, {arguments.check}: {describe_failure(why)}")
    if why.function:
        case = _case(why.at)
        keywords = [f"{name}={_digits(value)}" for name, value in case.kwargs.items()]
        say(f"\n{why.function}({', '.join([*map(_digits, case.args), *keywords])})")
    say(f"\nexpected: {_digits(why.expected)}\nactual:   {_digits(why.actual)}")
    if arguments.file:
        say(f"now:      {_again(arguments, slug, why)}")
    return 0


def _failure(results: Path, student: str, check: str, assignment: str | None) -> tuple[str, Failure]:
    """Return the assignment and the failure of a student's check; raise UsageError if there is none, or several."""
    with contextlib.closing(store.results(results)) as graded:
        mine = [graded.result(key) for key in graded if key[0] == student]
    if not mine:
        raise UsageError(f"{results} has no result of {student}")
    slugs = match_slugs([assignment] if assignment else [], [result.assignment for result in mine])
    checks = {(result.assignment, each.name): each for result in mine for each in result.checks}
    failures = {key: each.failure for key, each in checks.items() if key[0] in slugs and each.failure}
    same = [(key, failure) for key, failure in failures.items() if key[1] == check]
    if len(same) == 1:
        return same[0][0][0], same[0][1]
    if same:
        both = _listed(key for key, _ in same)
        raise UsageError(f"{student} failed {check} of several assignments: {both}; choose one with --assignment")
    here = [checks[slug, check] for slug in slugs if (slug, check) in checks]
    why = f" ({here[0].outcome}: {here[0].message})" if here else ""
    raise UsageError(f"{student} did not fail {check}{why}; failed checks: {_listed(failures) or 'none'}")


def _listed(failed: Iterable[tuple[str, str]]) -> str:
    """Return checks with the numbers of their assignments as text: `hw12: name, ...`."""
    return ", ".join(f"{slug.partition('_')[0]}: {name}" for slug, name in failed)


def _again(arguments: argparse.Namespace, slug: str, why: Failure) -> str:
    """Return the result of the file's function for this input, computed in the sandbox, or why there is none."""
    root = course_config.course_of(arguments.root, [arguments.file])
    assignment = assignments.assignment(root, slug)
    try:
        source = read(Submission(arguments.student, slug, arguments.file, arguments.file))
    except CannotRead as unread:
        raise UsageError(str(unread)) from None
    with pool.sandboxes():
        student = Student(source, assignment, pool.zygote(sorted(assignment.needs), ResourceLimits(), [root]))
        try:
            student.load()
            return _result(getattr(student, why.function), _case(why.at)) if why.function else "the check names no call"
        except Failed as failed:
            return describe_failure(failed.failure)
        except NotWritten as unwritten:
            return student.describe_missing(str(unwritten))
        except Over as over:
            return f"{over}."
        finally:
            student.leave()


def _result(function: SandboxFunction, case: Case) -> str:
    """Return a function's result as text: numbers, the values of a formula, or the curves of a drawing."""
    if isinstance(function.returns, Formula):
        return _digits(function.at(case.args[0] if case.args else [case.kwargs]))
    if isinstance(function.returns, Drawing):
        curves = [f"{line.label or 'a curve'}: {_digits(line.points)}" for line in function.drawn(case).lines]
        return "\n".join(curves) or "no curve of ten points"
    return _digits(function(*case.args, **case.kwargs))


def _case(at: Json) -> Case:
    return Case(*map(_numbers, at["args"]), **{name: _numbers(value) for name, value in at["kwargs"].items()})


def _numbers(value: object) -> Numbers:
    """Return a list of numbers as an array, other values unchanged."""
    try:
        return np.array(value) if isinstance(value, list) and np.array(value).dtype.kind in "fi" else value
    except ValueError:  # lists of different lengths
        return value


def _digits(value: object) -> str:
    """Return a value as Python code, with all digits."""
    if isinstance(value, np.ndarray):
        return f"np.array({value.tolist()})"
    return repr(value)
