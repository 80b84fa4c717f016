"""Known mistakes: which calls agree with a mistake."""

import math
from dataclasses import replace

import pytest

from tam570_grader.checks.case import Call, Case
from tam570_grader.diagnosis.mistakes import Mistake, NoValue, explains, named_mistake, solution_with

SOLUTION = "import math\n\nimport numpy as np\n\n\ndef f(x):\n    return 2.0 * x\n\n\ndef g(x):\n    return 3.0 * x\n"


def wrong(body, **fields):
    return Mistake("a_mistake", "A wrong formula.", "a_check", f"def f(x):\n    return {body}\n", **fields)


def is_named(mistake, *calls):
    """Return whether calls (function, input, student's result) agree with a mistake."""
    cause = named_mistake(SOLUTION, [mistake], [Call(name, Case(x), result) for name, x, result in calls])
    return cause is not None and cause.message == mistake.message


AGREE = [  # (formula of a wrong f, calls, whether they agree with it); the correct f is 2 x, and g is 3 x
    *((body, [("f", 0.0, 1.0)], False) for body in ("1 / x", "math.sqrt(x - 1)", "np.linalg.inv([[x]])")),
    # a call that failed agrees with no value
    ("x", [("f", 1.0, 1.0), ("f", 0.0, None)], False),
    ("1 / x", [("f", 1.0, 1.0), ("f", 0.0, None)], True),
    ("1 / x if x else math.nan", [("f", 1.0, 1.0), ("f", 0.0, None)], True),
    ("x", [("f", 0.0, None)], False),
    # results of functions that the mistake does not change do not matter
    ("x", [("f", 1.0, 1.0), ("g", 1.0, math.pi)], True),
    ("x", [("g", 1.0, 1.0)], False),
    # a correct result is no mistake
    ("2.0 * x", [("f", 1.0, 2.0)], False),
    ("2.0 * abs(x)", [("f", 1.0, 2.0)], False),
    # every call must agree
    ("2.0 * abs(x)", [("f", 1.0, 2.0), ("f", -1.0, 2.0)], True),
    ("2.0 * abs(x)", [("f", -1.0, 2.0), ("f", -2.0, -4.0)], False),
    # a result that cancels differs from zero by the rounding of larger results
    *(("x", [("f", large, large), ("f", 0.0, -3e-14)], large > 1.0) for large in (1.0, 90.0)),
]


@pytest.mark.parametrize(("body", "calls", "agreeing"), AGREE)
def test_a_mistake_is_named_where_its_numbers_agree(body, calls, agreeing):
    assert is_named(wrong(body), *calls) == agreeing


@pytest.mark.parametrize(("result", "following"), [(0.0, True), (1.0, False)])
def test_where_a_mistake_has_no_value_the_right_one_follows_too(result, following):
    calls = [Call("f", Case(1.0), 1.0), Call("f", Case(0.0), result)]
    assert explains(SOLUTION, lambda call: call.case.args[0] or NoValue, calls) == following


def test_how_closely_is_said_by_the_mistake():
    assert not is_named(wrong("x"), ("f", 1.0, 1.001))
    assert is_named(wrong("x", tolerance=1e-2), ("f", 1.0, 1.001))


def test_an_answer_is_computed_once_for_the_same_input():
    """A wrong function that counts its calls is called once for each input."""
    counted = wrong("(calls.append(1), x)[1]")
    text = counted.text.replace("def f", "calls = []\n\n\ndef f")
    counted = replace(counted, text=text)
    for x in (5.0, 5.0, 6.0, 5.0):
        named_mistake(SOLUTION, [counted], [Call("f", Case(x), x)])
    assert len(solution_with(SOLUTION, text).calls) == 2


def test_one_mistake_of_several_is_told_by_the_inputs_that_show_it_alone():
    thin, thick = Case(1.0).labelled("a thin disk"), Case(2.0).labelled("a hoop")
    calls = [Call("f", thin, 1.0), Call("f", thick, 7.0)]
    of_label, of_all = wrong("x", label="thin"), wrong("x")
    assert named_mistake(SOLUTION, [of_all, of_label], calls).message == of_label.message
    assert named_mistake(SOLUTION, [of_all], calls) is None
    assert named_mistake(SOLUTION, [wrong("x", label="thick")], calls) is None
