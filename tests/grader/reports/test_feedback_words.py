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


def test_a_mistake_that_was_found_by_trying_is_not_called_a_known_one():
    guess = check("one", suspect="In energy, a term is missing", failure=Failure(message="energy is wrong"))
    assert "Your numbers match this mistake: In energy, a term is missing.\n" in shown(guess)
    assert feedback.row(result("ada", guess).record())[5] == "numbers match: In energy, a term is missing."


def test_scores_have_two_decimals(grade):
    assert "9.77 of 10 points" in shown(check("one", points=0.9675))
    rows = [feedback.row(result("ada", score=score).record()) for score in (9.9975, 10.0)]
    assert [row[2] for row in rows] == [" 9.99 / 10", "   10 / 10"]
