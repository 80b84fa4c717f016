"""The tests that a change affects, points by the visible tests, and the function to work on next."""

import itertools

import pytest

from tam570.checking.changes import ANY, by_parameters, calls, keys
from tam570.progress import progress, rows
from tam570_grader.checks import assignments

CODE = '''
import numpy as np
RATE = 2.0  # 1/s

def helper(x):
    """Says what it does."""
    return RATE * x
def first(x):
    return helper(x)
def second(x):
    return x


def third(x):
    return np.sin(x)
'''
TESTS = """
import code_of_mine as hw
import pytest
from code_of_mine import third as another
POINT = 1.0

@pytest.fixture
def value():
    return hw.second(POINT)
def apart(f):
    return f(POINT)
def test_first():
    assert hw.first(POINT) == 2.0
def test_second(value):
    assert value == POINT
def test_third():
    assert apart(another) < POINT
def test_all():
    assert callable(getattr(hw, "first"))
"""
EVERY = {"test_first", "test_second", "test_third", "test_all"}
SLUG = "hw08_axis_angle"


def concerned(code=None, tests=None):
    """Return the tests whose key changes."""
    before, after = (keys(TESTS, CODE, "code_of_mine"), keys(tests or TESTS, code or CODE, "code_of_mine"))
    return {test for test in before | after if before.get(test) != after.get(test)}


def test_the_functions_that_a_test_calls_are_found_in_helpers_and_fixtures():
    assert calls(TESTS, "code_of_mine") == {
        "test_first": {"first"},
        "test_second": {"second"},
        "test_third": {"third"},
        "test_all": {"first", ANY},
    }


@pytest.mark.parametrize(
    ("old", "new", "which"),
    [
        ("return x\n", "return 1 * x\n", {"test_second", "test_all"}),
        ("return RATE * x", "return x * RATE", {"test_first", "test_all"}),
        ("RATE = 2.0", "RATE = 3.0", {"test_first", "test_all"}),
        ("import numpy as np", "import math as np", {"test_third", "test_all"}),
        ("def second(x)", "def second(x, y=0)", {"test_second", "test_all"}),
        ("RATE = 2.0", "if 1 < 2:\n    RATE = 2.0", EVERY),
        ("# 1/s", "# per second", set()),
        ("Says what it does.", "Says it better.", set()),
        ("\n\n\ndef third", "\n\n\n\n\ndef third", set()),
        ("def third(x):\n    return np.sin(x)\n", "", {"test_third", "test_all"}),
    ],
)
def test_a_change_concerns_the_tests_that_see_it(old, new, which):
    assert old in CODE
    assert concerned(code=CODE.replace(old, new)) == which


@pytest.mark.parametrize(
    ("old", "new", "which"),
    [("POINT = 1.0", "POINT = 1.5", EVERY - {"test_all"}), ("return f(POINT)", "return f(2)", {"test_third"})],
)
def test_a_change_of_the_tests_concerns_those_that_it_changes(old, new, which):
    assert concerned(tests=TESTS.replace(old, new)) == which


def test_a_parameter_that_names_a_function_tells_which_one_is_meant():
    called_by = {"test_all": {"first", "second", ANY}, "test_one": {"first"}}
    used = by_parameters(called_by, ["test_all[first]", "test_all[x-second]", "test_all[3]", "test_one[second]"])
    assert list(used.values()) == [{"first"}, {"second"}, {"first", "second"}, {"first"}]


def test_all_tests_passed_are_all_points_and_mending_one_never_takes_points(slug, course):
    """The points never fall as the tests pass one after the other, in either order, and end at 10."""
    called_by = calls((course / "assignments" / slug / f"test_{slug}.py").read_text(), slug)
    assert set.union(*called_by.values()) >= set(assignments.assignment(course, slug).returns)
    for order in (list(called_by), list(called_by)[::-1]):
        come = [progress(slug, dict.fromkeys(order[:n], "passed"), called_by) for n in range(len(order) + 1)]
        assert all(before["points"] <= after["points"] for before, after in itertools.pairwise(come))
        assert (come[-1]["points"], come[-1]["most"], come[-1]["next"]) == (10, 10, None)
    come = progress(slug, dict.fromkeys(called_by, "failed"), called_by)
    assert come["points"] == come["passed"] == 0 and come["next"] == next(iter(rows(slug)))


@pytest.mark.parametrize(
    ("outcomes", "at_fault", "following"),
    [
        (("passed", "failed", "passed"), {}, "rotation_matrix"),  # no test has proven it
        (("failed", "passed", "passed"), {}, "skew"),
        (("failed", "failed", "failed"), {}, "skew"),
        (("failed", "failed", "failed"), {"test_a": "rotate"}, "rotate"),
        (("failed", "failed", "failed"), {"test_a": "rotation_matrix"}, "rotate"),
        (("passed", "failed", "passed"), {"test_b": "skew"}, "rotation_matrix"),
        (("failed", "failed", "passed"), {"test_b": "skew"}, "skew"),  # rotate is proven
    ],
)
def test_what_is_at_fault_for_certain_and_what_no_test_has_proven_is_next(outcomes, at_fault, following):
    called_by = {"test_a": {"skew"}, "test_b": {"skew", "rotation_matrix", "rotate"}, "test_c": {"rotate"}}
    come = progress(SLUG, dict(zip(called_by, outcomes, strict=True)), called_by, at_fault)
    assert come["next"] == following and (come["points"] > 0) == ("passed" in outcomes)
