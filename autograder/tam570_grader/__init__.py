"""The grading engine of tam570, and, for the checks files, all that hidden checks are written with."""

# ruff: noqa: E402  nothing below can be imported on Windows

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if os.name != "posix":
    raise SystemExit("tam570-grader: error: the grader needs Linux or macOS; on Windows, use WSL")
# before NumPy is there: a second thread for matrices this small costs more processor time than all the rest
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from tam570_grader.checks.assignment import Assignment
from tam570_grader.checks.case import Case
from tam570_grader.checks.check import check, once
from tam570_grader.checks.compare import (
    Column,
    absolute,
    check_domain,
    check_raises,
    compare,
    compare_columns,
    compare_with,
    first_wrong,
    largest,
)
from tam570_grader.checks.expect import Failed, expect, expect_that, fail, get_context
from tam570_grader.checks.formulas import from_own_lagrangian, in_symbols
from tam570_grader.checks.plots import curves_seen, distances, exchanged, judge_axes_of_lengths, judge_boxes, path_drawn
from tam570_grader.checks.returns import array, drawing, formula, group, number, rows
from tam570_grader.checks.times import KEPT, SOME_TIMES, repeated_calls, uneven
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_invariants, compare_trajectory

if TYPE_CHECKING:
    from tam570_grader.grading.batch import RunConfig
    from tam570_grader.results.records import Result

__all__ = [
    "Assignment",
    "absolute",
    "compare_columns",
    "compare_with",
    "compare_invariants",
    "get_context",
    "grade",
    "path_drawn",
    "in_symbols",
    "repeated_calls",
    "Column",
    "Invariant",
    "compare_trajectory",
    "check_conserved",
    "compare",
    "check_domain",
    "check_raises",
    "KEPT",
    "SOME_TIMES",
    "Failed",
    "fail",
    "first_wrong",
    "array",
    "check",
    "curves_seen",
    "distances",
    "drawing",
    "exchanged",
    "expect",
    "expect_that",
    "formula",
    "from_own_lagrangian",
    "OwnRates",
    "Case",
    "group",
    "judge_axes_of_lengths",
    "judge_boxes",
    "largest",
    "number",
    "once",
    "rows",
    "uneven",
]


def grade(submissions: "Iterable[str | Path]", config: "RunConfig | None" = None) -> "Iterator[Result]":
    """Grade submissions in the sandbox.

    Parameters
    ----------
    submissions : paths
        Modules, notebooks, their folders, or trees `<student>/<assignment>/`, as `tam570-grader grade` takes them.
    config : RunConfig, optional
        Course, seed, supervisors, limits. By default the installed course, a random seed, a supervisor a core.

    Yields
    ------
    Result
        Of each submission, as soon as it is graded: student, assignment, status, score, checks.

    Raises
    ------
    UsageError
        Where there is no submission at these paths, or no submission can be confined on this machine.

    Examples
    --------
    >>> from tam570_grader.checks import assignments
    >>> for result in grade([assignments.find() / "solutions" / "hw08_axis_angle.py"]):
    ...     print(result.assignment, result.score, [check.outcome for check in result.checks][:2])
    hw08_axis_angle 10.0 ['passed', 'passed']
    """
    from tam570_grader.grading import batch

    return batch.grade(submissions, config or batch.RunConfig())
