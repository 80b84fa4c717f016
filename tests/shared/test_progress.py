"""Points by the visible tests, and what is next."""

import itertools

from tam570.checking.changes import calls
from tam570.progress import progress, rows
from tam570_grader.checks import assignments

SLUG = "hw08_axis_angle"


def test_every_visible_test_says_which_functions_it_calls(slug, course):
    """So that the points by visible tests are whole."""
    text = (course / "assignments" / slug / f"test_{slug}.py").read_text()
    found = calls(text, slug)
    assert set.union(*found.values()) >= set(assignments.assignment(course, slug).results)


def test_all_tests_passed_are_all_points(slug, course):
    found = calls((course / "assignments" / slug / f"test_{slug}.py").read_text(), slug)
    come = progress(slug, dict.fromkeys(found, "passed"), found)
    assert (come["points"], come["most"], come["next"]) == (10, 10, None)
    come = progress(slug, dict.fromkeys(found, "failed"), found)
    assert come["points"] == come["passed"] == 0 and come["next"] == next(iter(rows(slug)))


def test_a_failure_is_charged_to_what_no_test_has_proven():
    found = {"test_a": {"skew"}, "test_b": {"skew", "rotate"}}
    come = progress(SLUG, {"test_a": "passed", "test_b": "failed"}, found)
    assert come["next"] == "rotate" and come["points"] > 0
    come = progress(SLUG, {"test_a": "failed", "test_b": "passed"}, found)
    assert come["next"] == "skew"


def test_mending_a_test_never_takes_points(slug, course):
    """From every test failed to every test passed, one after the other, in either order."""
    found = calls((course / "assignments" / slug / f"test_{slug}.py").read_text(), slug)
    for order in (list(found), list(found)[::-1]):
        passed = [progress(slug, dict.fromkeys(order[:n], "passed"), found)["points"] for n in range(len(order) + 1)]
        assert all(before <= after for before, after in itertools.pairwise(passed))


def test_what_is_at_fault_for_certain_is_next():
    found = {"test_a": {"skew"}, "test_b": {"skew", "rotation_matrix", "rotate"}}
    outcomes = {"test_a": "failed", "test_b": "failed"}
    assert progress(SLUG, outcomes, found)["next"] == "skew"
    assert progress(SLUG, outcomes, found, {"test_a": "rotate"})["next"] == "rotate"
    assert progress(SLUG, outcomes | {"test_a": "passed"}, found, {"test_b": "skew"})["next"] == "rotation_matrix"
