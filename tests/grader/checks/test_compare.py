"""`compare`: labels and units from RETURNS in messages, results of any length, hints, and arguments of calls."""

from types import SimpleNamespace

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.checks.check import once
from tam570_grader.checks.compare import Column, compare
from tam570_grader.checks.expect import Failed, check_context, expect
from tam570_grader.checks.returns import array, group, number, rows
from tam570_grader.reports.sentences import describe_failure

HEIGHT = number.described("the height", "m", lambda case, _: 1e3)


def student(returns, result, name="height"):
    """Return a stand-in for a student's function that always returns `result`."""
    return SimpleNamespace(name=name, returns=returns, many=lambda cases: [result for _ in cases])


def said(compare, *args, **fields):
    with check_context(), pytest.raises(Failed) as failed:
        compare(*args, tolerance=1e-9, **fields)
    return describe_failure(failed.value.failure)


def test_each_member_of_a_tuple_has_words_of_its_own():
    item = student(group(array(2).described("the place", "m"), HEIGHT), (np.ones(2), 3.0))
    message = said(compare, item, lambda: (np.ones(2), 2.0), [Case()], hint=lambda *of: f"Is it {of[2][1]} m?")
    assert "height is wrong by 1 m" in message and "Is it 2.0 m?" in message
    assert "place is wrong by 5 m" in said(compare, item, lambda: (np.full(2, 6.0), 3.0), [Case()])


@pytest.mark.parametrize("count", [1, 3])
def test_a_result_of_any_length_with_another_length_is_wrong(count):
    roots = array(None).described("the roots", "m")
    with check_context(), pytest.raises(Failed):
        compare(student(roots, np.ones(count)), lambda: np.ones(2), [Case()], tolerance=1e-9, hint=max)


def test_rows_are_judged_by_the_columns_of_results_and_tell_the_time():
    motion = rows(2, columns=(Column("x", "m", [0]), Column("v", "m/s", [1])))
    t, actual = np.array([0.0, 1.0, 2.5]), np.array([[1.0, 2.0], [1.0, 2.0], [1.0, 9.0]])
    message = said(compare, student(motion, actual), lambda t: np.tile([1.0, 2.0], (3, 1)), [Case(t)])
    assert "v is wrong by 7 m/s (limit 2e-9) at t = 2.5 s" in message


def test_a_hint_is_asked_for_the_one_failure_that_is_told():
    call_cases = []
    with pytest.raises(Failed) as failed, check_context():
        for error in (2.0, 3.0):  # both leave a share of the points, so the check continues
            expect(error, 0.0, tolerance=1.0, hint=lambda error=error: call_cases.append(error) or f"by {error:g}")
    assert call_cases == [2.0] and failed.value.failure.hint == "by 2"


def test_a_call_is_cut_to_what_the_reference_takes():
    seen = []
    item = SimpleNamespace(name="root", returns=number, many=lambda cases: seen.extend(cases) or [2.0])
    compare(item, lambda x: x**0.5, [Case(4.0, 7.0, mass=2.0).labelled("more than it takes")], tolerance=1e-9)
    assert seen == [Case(4.0).labelled("more than it takes")]


@pytest.mark.parametrize(("mine", "said"), [("", "Look at y^2."), ("Is it positive?", "Is it positive?")])
def test_the_hint_of_a_case_goes_before_that_of_the_check(mine, said):
    with check_context(), pytest.raises(Failed) as failed:
        calls = [Case(4.0).labelled("a root of 4", mine)]
        compare(student(number, -2.0), lambda x: x**0.5, calls, tolerance=1e-9, hint="Look at y^2.")
    assert failed.value.failure.hint == said


def test_an_array_that_is_drawn_once_a_run_may_be_changed_in_place():
    axis = once(lambda rng: rng.normal(size=3))
    drawn, changed = (axis(np.random.default_rng(5)) for _ in range(2))
    changed[0] = 7.0
    assert (axis(np.random.default_rng(5)) == drawn).all() and drawn[0] != 7.0
