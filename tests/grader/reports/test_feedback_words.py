"""What a page says of a result: where to look first, what to do next, points, and nothing twice."""

import html
import re

from tam570_grader.checks.failure import Failure
from tam570_grader.reports import feedback
from tam570_grader.results.records import CheckResult, Result


def shown(*marks, message="", status="graded", info=None):
    """What stands on the page of a result."""
    result = Result("ada", "hw08_axis_angle", status, 9.7675, 10.0, 1, 0.1, "", marks, message)
    page = html.unescape(feedback.page(result, info or feedback.AssignmentInfo("", {}, {}, {})))
    return re.sub(r"<[^>]+>", "", page)


def check(name, outcome="failed", message="", points=0.0, **more):
    return CheckResult(name, "a", points, 1.0, outcome, message, **more)


def test_the_hint_is_for_the_function_that_failed_not_for_the_first_in_the_line():
    info = feedback.AssignmentInfo("", {}, dict.fromkeys(["one", "two", "three"], "skew"), {})
    failed = check("one", failure=Failure(message="rotate did not return", function="rotate"))
    missing = check("two", "not_run", unwritten="rotation_matrix")
    page = shown(failed, missing, check("three"), info=info)
    assert re.findall(r"tam570 hint hw08 (\w+)", page) == ["rotate", "rotation_matrix", "skew"]


def test_where_nothing_failed_the_first_thing_to_look_at_is_what_is_not_written():
    passed, blocked = check("one", "passed", points=1.0), check("two", "not_run", "Not run")
    missing, failed = check("three", "not_run", unwritten="skew"), check("four")
    assert "Look at this first: three" in shown(passed, blocked, missing)
    assert "Look at this first: four" in shown(passed, blocked, missing, failed)
    assert "Look at this first" not in shown(passed, blocked)


def test_a_mistake_that_was_found_by_trying_is_not_called_a_known_one():
    guess = check("one", suspect="In energy, a term is missing", failure=Failure(message="energy is wrong"))
    assert "Your numbers match this mistake: In energy, a term is missing.\n" in shown(guess)
    row = feedback.row(Result("ada", "hw07", "graded", 9.7675, 10.0, 1, 0.1, "", (guess,)).record())
    assert row[5] == "numbers match: In energy, a term is missing."


def test_scores_have_two_decimals(grade):
    assert "9.77 of 10 points" in shown(check("one", points=0.9675))
    record = Result("ada", "hw07", "graded", 9.9975, 10.0, 1, 0.1, "", ()).record()
    assert [feedback.row({**record, "score": score})[2] for score in (9.9975, 10.0)] == [" 9.99 / 10", "   10 / 10"]
