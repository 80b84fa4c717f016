"""The visible tests pass on correct answers of any style, and fail where the grader finds a mistake."""

import json
import shutil

import pytest
from parameters import SLUGS, first

from tam570.checking import deadline, session
from tam570.checking.examples import closed, load_examples, plain
from tam570.checking.trail import Trail
from tam570.progress import recalled
from tam570_grader.checks import assignments
from tam570_grader.checks.expect import check_context
from tam570_grader.diagnosis.mistakes import mistakes
from tam570_grader.grading.seeds import generator

EXACT = """
import runpy
import numpy as np
import sympy

def exact(value):
    if isinstance(value, tuple):
        return [exact(part) for part in value]
    numbers = isinstance(value, float | np.ndarray | np.generic)
    return np.vectorize(sympy.Float, otypes=[object])(value) if numbers else value

def strict(function):
    def called(*args, **kwargs):
        for value in (*args, *kwargs.values()):
            steps = isinstance(value, list) and all(isinstance(step, tuple) for step in value)
            plain = steps or isinstance(value, str | float | int | tuple) or hasattr(value, "plot")
            assert plain or value.dtype == float, value
        return exact(function(*args, **kwargs))
    return called

solution = runpy.run_path({solution!r})
globals().update({{name: strict(solution[name]) for name in solution["__all__"]}})
"""
RIGHT = sorted((assignments.find() / "autograder" / "checks").glob("*/alternatives/*.py"))


def test_the_visible_tests_pass_on_the_solution_and_fail_on_the_stub(desk, slug, course, capsys):
    assert session.check(course / "solutions" / f"{slug}.py", slug, Trail(), lost={}), capsys.readouterr()
    capsys.readouterr()
    assert not session.check(course / "assignments" / slug / f"{slug}.py", slug, Trail(), lost={})
    said = capsys.readouterr().out
    assert "nothing is written yet" in said and len(said.splitlines()) == 1


@pytest.mark.parametrize("path", first(1, RIGHT), ids=[f"{path.parents[1].name[:4]}-{path.stem}" for path in RIGHT])
def test_the_visible_tests_pass_on_right_answers_in_other_styles(desk, tam570, in_process, path):
    shutil.copy(path, desk / f"{path.parents[1].name}.py")
    code, said = tam570("check", desk / f"{path.parents[1].name}.py")
    assert code == 0, said


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_the_visible_tests_take_any_numbers_and_give_arrays(desk, tam570, in_process, slug, course):
    """Results may be SymPy numbers or arrays of them; arguments are arrays, tuples or plain, except hw09's list."""
    name = f"{slug}.py"
    (desk / name).write_text(EXACT.format(solution=str(course / "solutions" / name)))
    shutil.copy(course / "assignments" / slug / f"test_{name}", desk)
    code, said = tam570("check", desk / name)
    assert code == 0, said


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
