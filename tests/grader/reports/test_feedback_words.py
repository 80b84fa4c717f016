"""What a page says of a result: where to look first, what to do next, points, and nothing twice."""

import html
import re

from classes import check_result as check
from classes import result

from tam570_grader.checks.failure import Failure
from tam570_grader.reports import feedback


def shown(*checks, info=None, score=9.7675):
    """What stands on the page of a result."""
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
