"""What the grader spends on one submission has limits, and ends as that submission's result."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from tam570_grader.grading import budget, one
from tam570_grader.grading.one import graded
from tam570_grader.sandbox.student import BudgetSpent, Source
from tam570_grader.sandbox.worker import Allowance
from tam570_grader.writing import assignments

SLUG = "hw08_axis_angle"
BRIEF = 0.2  # s
LITTLE = 2**28  # bytes


def endless(*_):
    while True:
        pass


def grows(*_):
    return [np.empty(2**24) for _ in range(100)]


@pytest.fixture
def judged(course, workers, solution_text, monkeypatch):
    """`judged(judge, name)` -> the result where the check of this name does something else; right answers otherwise."""
    assignment = assignments.assignment(course, SLUG)
    monkeypatch.setattr(one, "budget", lambda: budget.budget(BRIEF, LITTLE))

    def judged(judge=None, name="", text=""):
        checks = [replace(check, judge=judge) if check.name == name else check for check in assignment.checks]
        source = Source((text or solution_text(SLUG)).encode())
        return graded("ada", source, replace(assignment, checks=tuple(checks)), workers(SLUG, Allowance()), 1)

    return judged


@pytest.mark.parametrize(("judge", "says"), [(endless, "processor time"), (grows, "memory")])
def test_a_check_that_does_not_end_is_one_submissions_result(judge, says, judged, course):
    names = [check.name for check in assignments.assignment(course, SLUG).checks]
    result = judged(judge, names[1])
    assert (result.status, result.checks[0].outcome) == ("timeout", "passed") and says in result.message
    assert result.score == result.checks[0].points
    assert judged().score == 10


def test_memory_is_limited_where_a_cluster_grades_in_a_thread_of_its_own(judged, course):
    assert judged().score == 10  # the worker has started, here: it ends with the thread that starts it
    name = assignments.assignment(course, SLUG).checks[1].name
    with ThreadPoolExecutor(1) as pool:
        result = pool.submit(judged, grows, name).result()
    assert result.status == "timeout" and "memory" in result.message
    assert judged().score == 10


def test_what_takes_an_error_and_goes_on_is_told_again():
    with pytest.raises(BudgetSpent), budget.budget(BRIEF):
        try:
            endless()
        except BudgetSpent:
            endless()


def test_to_look_for_a_mistake_is_part_of_it(judged, solution_text, monkeypatch):
    monkeypatch.setattr(one, "known", endless)
    result = judged(text=solution_text(SLUG) + "\n\ndef skew(v): return np.eye(3)")
    assert result.status == "timeout" and "to judge" in result.message


def test_nothing_of_it_stays_behind():
    """What is spent between two blocks, and what was spent in an earlier one, is not counted."""
    for _ in range(3):
        with budget.budget(1e9):
            sum(range(10**6))
    with pytest.raises(BudgetSpent), budget.budget(0.0):
        endless()
    assert sum(range(10**7))
