"""The grading engine of tam570, and, for the checks files, all that hidden checks are written with."""

# ruff: noqa: E402  nothing below can be imported on Windows

import os

if os.name != "posix":
    raise SystemExit("tam570-grader: error: the grader needs Linux or macOS; on Windows, use WSL")
# before NumPy is there: a second thread for matrices this small costs more processor time than all the rest
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from tam570_grader.writing.agree import Column, absolute, agree, agree_by_columns, by_kind, largest, refuse
from tam570_grader.writing.check import check, given, once
from tam570_grader.writing.curves import kept
from tam570_grader.writing.drawings import (
    curves_seen,
    distances,
    exchanged,
    judge_axes_of_lengths,
    judge_boxes,
    path_drawn,
)
from tam570_grader.writing.expect import Failed, current, expect, expect_that, fail
from tam570_grader.writing.follow import Invariant, follow, stays
from tam570_grader.writing.formulas import from_own_lagrangian, in_symbols
from tam570_grader.writing.laws import law
from tam570_grader.writing.returns import array, drawing, formula, group, number, rows
from tam570_grader.writing.times import SOME_TIMES, in_turn, uneven

__all__ = [
    "absolute",
    "by_kind",
    "agree_by_columns",
    "current",
    "path_drawn",
    "in_symbols",
    "in_turn",
    "Column",
    "Invariant",
    "follow",
    "stays",
    "agree",
    "refuse",
    "SOME_TIMES",
    "Failed",
    "fail",
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
    "given",
    "group",
    "judge_axes_of_lengths",
    "judge_boxes",
    "kept",
    "largest",
    "law",
    "number",
    "once",
    "rows",
    "uneven",
]
