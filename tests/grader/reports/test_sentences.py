"""Text on the students' pages: numbers as people write them, where to look first, and which hint to read."""

import html
import re

import numpy as np
import pytest
from classes import check_result as check
from classes import result

from tam570_grader.checks.failure import Failure
from tam570_grader.reports import feedback
from tam570_grader.reports.sentences import describe_failure, points, quantity


@pytest.mark.parametrize(
    ("value", "message"),
    [
        *((2.7, "2.7"), (200.0, "200"), (1234.0, "1200"), (0.0312, "0.031"), (6e-4, "6e-4"), (1.13e-13, "1.1e-13")),
        *((9.99e-5, "1e-4"), (23456.0, "2.3e4"), (0.0, "0"), (np.inf, "more than any number")),
    ],
)
def test_numbers_are_as_people_write_them(value, message):
    assert quantity(value) == message


@pytest.mark.parametrize(
    ("earned", "most", "message"),
    [
        *((9.7675, 10.0, "9.77"), (0.125, 0.25, "0.13"), (9.9975, 10.0, "9.99"), (10.0, 10.0, "10")),
        *((0.1 + 0.2, 0.3, "0.3"), (0.3, 0.1 + 0.2, "0.3"), (0.0, 10.0, "0"), (12.0, 10.0, "12"), (None, 10.0, "?")),
    ],
)
def test_points_have_two_decimals_and_all_are_shown_for_nothing_less(earned, most, message):
    assert points(earned, most) == message


@pytest.mark.parametrize("error", np.random.default_rng(1).lognormal(-5, 9, 50))
def test_no_error_reads_as_its_limit_or_less(error):
    for limit in error / (1 + 10.0 ** -np.arange(1, 9)):
        sentence = describe_failure(Failure(quantity="x", error=error, limit=limit))
        shown, allowed = sentence.split(" is wrong by ")[1].split(" (limit ")
        assert float(shown) > float(allowed.rstrip(").")), (error, limit)


def shown(*checks, info=None, score=9.7675):
    """Return the text of the page of a result with these checks."""
    page = feedback.page(result("ada", *checks, score=score), info or feedback.AssignmentInfo("", {}, {}, {}))
    return re.sub(r"<[^>]+>", "", html.unescape(page))


def test_the_hint_is_for_the_function_that_failed_not_for_the_first_in_the_line():
    info = feedback.AssignmentInfo("", {}, dict.fromkeys(["one", "two", "three"], "skew"), {})
    failed = check("one", failure=Failure(message="rotate did not return", function="rotate"))
    missing = check("two", "not_run", unwritten="rotation_matrix")
    page = shown(failed, missing, check("three"), info=info)
    assert re.findall(r"tam570 hint hw08 (\w+)", page) == ["rotate", "rotation_matrix", "skew"]


def test_where_nothing_failed_the_first_thing_to_look_at_is_what_is_not_written():
    passed, blocked = check("one", "passed", points=1.0), check("two", "not_run", message="Not run")
    missing, failed = check("three", "not_run", unwritten="skew"), check("four")
    assert "Look at this first: three" in shown(passed, blocked, missing)
    assert "Look at this first: four" in shown(passed, blocked, missing, failed)
    assert "Look at this first" not in shown(passed, blocked)
