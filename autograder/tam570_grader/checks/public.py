"""The names that hidden checks import from `tam570_grader`."""

from tam570_grader.checks.assignment import Assignment
from tam570_grader.checks.case import Case
from tam570_grader.checks.check import check, once
from tam570_grader.checks.compare import (
    Column,
    absolute,
    check_domain,
    check_raises,
    compare,
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
