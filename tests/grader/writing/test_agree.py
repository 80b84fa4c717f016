"""What messages call a result: RESULTS says it once, and a check may say it otherwise."""

from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from tam570_grader.pages.sentences import message
from tam570_grader.writing.agree import Column, agree, agree_by_columns
from tam570_grader.writing.check import given
from tam570_grader.writing.expect import Failed, expect, trial
from tam570_grader.writing.returns import array, group, number, rows


def student(promise, result, name="height"):
    """A student's function that always gives this result."""
    return SimpleNamespace(name=name, promise=promise, each=lambda cases: ((case, result) for case in cases))


def said(compare, *args, **known):
    with trial(), pytest.raises(Failed) as failed:
        compare(*args, within=1e-9, **known)
    return message(failed.value.failure)


def right(**functions):
    """A module of right functions."""
    module = ModuleType("right")
    vars(module).update(functions)
    return module


HEIGHT = number.called("the height", "m", lambda case, _: 1e3)


def test_results_and_the_module_of_what_is_right_say_what_is_compared():
    says = said(agree, student(HEIGHT, 3.0), right(height=lambda x: x), [given(1.0)])
    assert says == "The height is wrong by 2 m (limit 1e-6)."


def test_each_member_of_a_tuple_has_words_of_its_own():
    pair = group(array(2).called("the place", "m"), HEIGHT)
    one = student(pair, (np.ones(2), 3.0))
    assert "height is wrong by 1 m" in said(agree, one, lambda: (np.ones(2), 2.0), [given()])
    assert "place is wrong by 5 m" in said(agree, one, lambda: (np.full(2, 6.0), 3.0), [given()])


def test_a_check_may_use_other_words():
    says = said(agree, student(HEIGHT, 3.0), lambda: 1.0, [given()], of="a flight", unit="km", scale=lambda *_: 1.0)
    assert "flight is wrong by 2 km (limit 1e-9)" in says


def test_rows_are_judged_by_the_columns_of_results_and_tell_the_time():
    motion = rows(2, columns=(Column("x", "m", [0]), Column("v", "m/s", [1])))
    t, found = np.array([0.0, 1.0, 2.5]), np.array([[1.0, 2.0], [1.0, 2.0], [1.0, 9.0]])
    says = said(agree_by_columns, student(motion, found), lambda t: np.tile([1.0, 2.0], (3, 1)), [given(t)])
    assert "v is wrong by 7 m/s (limit 2e-9) at t = 2.5 s" in says


def test_a_hint_is_asked_for_the_one_failure_that_is_told():
    asked = []
    with pytest.raises(Failed) as failed, trial():
        for error in (2.0, 3.0):  # both keep a share
            expect(error, 0.0, within=1.0, hint=lambda error=error: asked.append(error) or f"by {error:g}")
    assert asked == [2.0] and failed.value.failure.hint == "by 2"
