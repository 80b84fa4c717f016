"""Points by the visible tests, and what is next."""

import itertools

import pytest

from tam570.checking.changes import calls
from tam570.progress import progress, rows
from tam570_grader.checks import assignments

SLUG = "hw08_axis_angle"


@pytest.fixture
def called_by(slug, course):
    """The functions that each visible test calls."""
    return calls((course / "assignments" / slug / f"test_{slug}.py").read_text(), slug)


def test_all_tests_passed_are_all_points_and_mending_one_never_takes_points(slug, course, called_by):
    """From every test failed to every test passed, one after the other, in either order."""
    assert set.union(*called_by.values()) >= set(assignments.assignment(course, slug).results)
    for order in (list(called_by), list(called_by)[::-1]):
        come = [progress(slug, dict.fromkeys(order[:n], "passed"), called_by) for n in range(len(order) + 1)]
        assert all(before["points"] <= after["points"] for before, after in itertools.pairwise(come))
        assert (come[-1]["points"], come[-1]["most"], come[-1]["next"]) == (10, 10, None)
    come = progress(slug, dict.fromkeys(called_by, "failed"), called_by)
    assert come["points"] == come["passed"] == 0 and come["next"] == next(iter(rows(slug)))


def test_a_failure_is_charged_to_what_no_test_has_proven():
    called_by = {"test_a": {"skew"}, "test_b": {"skew", "rotate"}}
    come = progress(SLUG, {"test_a": "passed", "test_b": "failed"}, called_by)
    assert come["next"] == "rotate" and come["points"] > 0
    come = progress(SLUG, {"test_a": "failed", "test_b": "passed"}, called_by)
    assert come["next"] == "skew"


def test_what_is_at_fault_for_certain_is_next():
    called_by = {"test_a": {"skew"}, "test_b": {"skew", "rotation_matrix", "rotate"}}
    outcomes = {"test_a": "failed", "test_b": "failed"}
    assert progress(SLUG, outcomes, called_by)["next"] == "skew"
    assert progress(SLUG, outcomes, called_by, {"test_a": "rotate"})["next"] == "rotate"
    assert progress(SLUG, outcomes | {"test_a": "passed"}, called_by, {"test_b": "skew"})["next"] == "rotation_matrix"
