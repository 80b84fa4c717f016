"""Known mistakes: what agrees with one, and what does not."""

import math
from dataclasses import replace

import pytest

from tam570_grader.checks.case import Case
from tam570_grader.diagnosis.mistakes import Mistake, named_mistake, solution_with
from tam570_grader.sandbox.function import Call

SOLUTION = "import math\n\nimport numpy as np\n\n\ndef f(x):\n    return 2.0 * x\n\n\ndef g(x):\n    return 3.0 * x\n"


def wrong(body, **fields):
    return Mistake("one", "A wrong formula.", "a_check", f"def f(x):\n    return {body}\n", **fields)


def named(slip, *calls):
    """Whether calls (function, input, the student's result) agree with a mistake."""
    cause = named_mistake(SOLUTION, [slip], [Call(name, Case(x), result) for name, x, result in calls])
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
        named_mistake(SOLUTION, [counted], [Call("f", Case(x), x)])
    assert len(solution_with(SOLUTION, text).calls) == 2


def test_one_mistake_of_several_is_told_by_the_inputs_that_show_it_alone():
    thin, thick = Case(1.0).labelled("a thin disk"), Case(2.0).labelled("a hoop")
    calls = [Call("f", thin, 1.0), Call("f", thick, 7.0)]
    told, untold = wrong("x", label="thin"), wrong("x")
    assert named_mistake(SOLUTION, [untold, told], calls).message == told.message
    assert named_mistake(SOLUTION, [untold], calls) is None
    assert named_mistake(SOLUTION, [wrong("x", label="thick")], calls) is None
