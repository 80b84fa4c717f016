"""`check` and the grader find the same function wrong in known mistakes."""

import json

import pytest
from parameters import SLUGS, first

from tam570.checking import deadline, session
from tam570.checking.examples import closed, load_examples, plain
from tam570.checking.trail import Trail
from tam570.progress import recalled
from tam570_grader.checks import assignments
from tam570_grader.checks.expect import check_context
from tam570_grader.diagnosis.mistakes import mistakes
from tam570_grader.grading.run_checks import generator


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
    at_home = load_examples(course / "assignments" / slug).mistakes
    today = {closed(mistake.message) for mistake in mistakes(assignments.checks_folder(course, slug))}
    assert {mistake["message"] for mistake in at_home} <= today


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_a_small_seed_gives_no_inputs_of_the_examples(slug, course, student_of, solution_text):
    """A class with seed 1 shares with the examples only the inputs that every seed gives."""
    student = student_of(slug, solution_text(slug))

    def inputs(seed):
        student.calls.clear()
        for check in assignments.assignment(course, slug).checks:
            with check_context():
                check.run(student, generator(seed, slug, check))
        return {json.dumps([plain(call.case.args), *map(plain, call.case.kwargs.values())]) for call in student.calls}

    calls = load_examples(course / "assignments" / slug).calls
    public = {json.dumps([{"tuple": call["args"]}, *call["kwargs"].values()]) for call in calls}
    assert inputs(1) & public <= inputs(2)
