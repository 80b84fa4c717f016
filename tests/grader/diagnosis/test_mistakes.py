"""Known mistakes: what agrees with one, and what does not."""

import math
from dataclasses import replace

import pytest

from tam570_grader.checks.case import Case
from tam570_grader.diagnosis.mistakes import Mistake, candidates, known, mistakes, solution_with
from tam570_grader.sandbox.function import Call

SOLUTION = "import math\n\nimport numpy as np\n\n\ndef f(x):\n    return 2.0 * x\n\n\ndef g(x):\n    return 3.0 * x\n"


def wrong(body, **fields):
    return Mistake("one", "A wrong formula.", "a_check", f"def f(x):\n    return {body}\n", **fields)


def named(slip, *calls):
    """Whether calls (function, input, the student's result) agree with a mistake."""
    cause = known(SOLUTION, [slip], [Call(name, Case(x), result) for name, x, result in calls])
    return cause is not None and cause.message == slip.message


@pytest.mark.parametrize("body", ["1 / x", "math.sqrt(x - 1)", "np.linalg.inv([[x]])"])
def test_a_mistake_without_a_value_does_not_agree(body):
    assert not named(wrong(body), ("f", 0.0, 1.0))


def test_a_call_that_failed_agrees_with_no_value():
    calls = ("f", 1.0, 1.0), ("f", 0.0, None)
    assert not named(wrong("x"), *calls)
    assert named(wrong("1 / x"), *calls)
    assert named(wrong("1 / x if x else math.nan"), *calls)
    assert not named(wrong("x"), calls[1])


def test_what_the_mistake_does_not_change_is_not_asked():
    assert named(wrong("x"), ("f", 1.0, 1.0), ("g", 1.0, math.pi))
    assert not named(wrong("x"), ("g", 1.0, 1.0))


def test_a_right_result_is_no_mistake():
    assert not named(wrong("2.0 * x"), ("f", 1.0, 2.0))
    assert not named(wrong("2.0 * abs(x)"), ("f", 1.0, 2.0))


def test_every_call_must_agree():
    assert named(wrong("2.0 * abs(x)"), ("f", 1.0, 2.0), ("f", -1.0, 2.0))
    assert not named(wrong("2.0 * abs(x)"), ("f", -1.0, 2.0), ("f", -2.0, -4.0))


def test_how_closely_is_said_by_the_mistake():
    assert not named(wrong("x"), ("f", 1.0, 1.001))
    assert named(wrong("x", tolerance=1e-2), ("f", 1.0, 1.001))


def test_an_answer_is_computed_once_for_the_same_input():
    """A wrong function that counts its calls."""
    counted = wrong("(calls.append(1), x)[1]")
    text = counted.text.replace("def f", "calls = []\n\n\ndef f")
    counted = replace(counted, text=text)
    for x in (5.0, 5.0, 6.0, 5.0):
        known(SOLUTION, [counted], [Call("f", Case(x), x)])
    assert len(solution_with(SOLUTION, text).calls) == 2


def test_one_mistake_of_several_is_told_by_the_inputs_that_show_it_alone():
    thin, thick = Case(1.0).labelled("a thin disk"), Case(2.0).labelled("a hoop")
    calls = [Call("f", thin, 1.0), Call("f", thick, 7.0)]
    told, untold = wrong("x", label="thin"), wrong("x")
    assert known(SOLUTION, [untold, told], calls).message == told.message
    assert known(SOLUTION, [untold], calls) is None
    assert known(SOLUTION, [wrong("x", label="thick")], calls) is None


FILE = '''
"""Mistakes of an assignment."""

from tam570_grader.diagnosis.mistakes import mistake

from .checks import a_check

HALF = 0.5


@mistake("You halve x.", first_fails=a_check)
def f(reference, x):
    return HALF * x


@mistake("You add 1; a hint says so.", first_fails=a_check, compared=False)
def f(reference, x):
    return reference(x) + 1.0


@mistake("You forget g.", first_fails=a_check, name="nothing", tolerance=1e-2, label="thin")
def g(reference, x):
    return 0.0
'''


def test_a_file_of_mistakes_is_read_whole(tmp_path):
    (tmp_path / "mistakes.py").write_text(FILE)
    halved, added, forgotten = mistakes(tmp_path)
    assert [one.name for one in (halved, added, forgotten)] == ["f", "f_2", "nothing"]
    assert {one.first_fails for one in (halved, added, forgotten)} == {"a_check"}
    assert (forgotten.tolerance, forgotten.label, halved.tolerance) == (1e-2, "thin", None)
    assert [solution_with(SOLUTION, one.text).f(4.0) for one in (halved, added, forgotten)] == [2.0, 9.0, 8.0]
    assert mistakes(tmp_path / "none") == ()


def test_a_mistake_is_a_suspect_of_the_functions_that_it_changes(tmp_path):
    (tmp_path / "mistakes.py").write_text(FILE)
    names = [[one.name for one in candidates(SOLUTION, tmp_path, {asked})] for asked in "fg"]
    assert names == [["f"], ["nothing"]], "f_2 is not compared"
