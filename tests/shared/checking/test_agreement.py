"""`check` and the grader find the same function wrong in known mistakes."""

import json

import pytest

from tam570.checking import deadline, session
from tam570.checking.examples import FILE, closed
from tam570.checking.trail import Trail
from tam570.progress import recalled
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import mistakes


@pytest.mark.slow
def test_known_mistakes_fail_at_home_and_at_the_same_function(desk, course, solution_text, grade, slug):
    """`check` fails for nine in ten of them, and then names a function that the grader finds wrong, too."""
    deadline.start()  # ends calls that take too long in this process, too
    passing, known_mistakes = [], mistakes(assignments.checks_folder(course, slug))
    for mistake in known_mistakes:
        file, text = desk / f"{slug}.py", f"{solution_text(slug)}\n\n{mistake.text}"
        file.write_text(text)
        if session.check(file, slug, Trail(), lost={}):
            passing.append(mistake.message)
        else:
            checks = grade(slug, text, naming=False).checks
            wrong = {check.unwritten or check.failure.function for check in checks if check.unwritten or check.failure}
            assert recalled(file)[0]["next"] in wrong, mistake.message
    assert len(passing) <= 0.1 * len(known_mistakes), passing


def test_home_has_the_sentences_of_today(slug, course):
    """The examples have only messages of known mistakes; `tam570-grader stubs --examples` updates them."""
    at_home = json.loads((course / "assignments" / slug / FILE).read_text())["mistakes"]
    today = {closed(mistake.message) for mistake in mistakes(assignments.checks_folder(course, slug))}
    assert {mistake["message"] for mistake in at_home} <= today
