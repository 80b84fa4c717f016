"""Results of another form than RETURNS describes, `expect`, and formulas."""

import math

import numpy as np
import pytest
import sympy

from tam570.forms import WrongForm, conform
from tam570.formulas import REMEDIES
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, expect
from tam570_grader.checks.returns import array, form, free_body_diagram, group, number, result, rows
from tam570_grader.protocol.wire import packed, portable, unpacked
from tam570_grader.reports.sentences import describe_failure

SYMBOLIC = """
import sympy
def lagrange_equation():
    m, theta, l, g = sympy.symbols('m theta l g')
    return {}
"""


@pytest.fixture
def symbolic(student_of):
    """`symbolic(expression)` -> a student whose lagrange_equation of hw01 returns it."""
    return lambda expression: student_of("hw01_simple_pendulum", SYMBOLIC.format(expression))


@pytest.mark.parametrize(
    ("returns", "value", "fragment"),
    [
        (number, np.ones(1), "not a single number"),
        (number, float("nan"), "NaN or infinity"),
        (number, np.array(1j), "complex numbers"),
        (number, None, "None"),
        (array(3), np.ones((3, 1)), "shape (3, 1)"),
        (array(3), [1.0, [2.0, 3.0]], "differ in length"),
        (array(2), [1.0, "2"], "an array of strings"),
        (array(2), np.array([1.0, None]), "not real numbers"),
        (array(2, 2), [[1.0, 2.0], np.array([1.0, 1j])], "complex numbers"),
        (array(None, 2), np.ones((0, 2)), "shape (k, 2)"),
        (rows(2), np.ones((4, 2)), "not an array of shape (5, 2)"),
        (rows(2), np.ones((2, 2)), "shape (5, 2). Rows are missing: did the integration stop early, or"),
        (rows(2), np.ones((9, 2)), "Return one row for each entry of the first argument"),
        (group(number, array(2)), 1.0, "tuple of 2"),
        (group(number, array(2)), [1.0, [2.0]], "result 2"),
        (group(number, array(2)), (1.0, None), "Is a `return` missing?"),
        (free_body_diagram(2), [((0, 0), None), ((0, 0, 1), None)], "force 2"),
    ],
)
def test_a_result_of_another_form_says_how_here_and_at_home(returns, value, fragment):
    """The grader, after the sandbox has sent the result, and the visible tests (`conform`) report the same error."""
    with pytest.raises(Failed) as failed:
        result(returns, unpacked(packed(portable(value))), "f", Case(np.zeros(5)))
    assert fragment in describe_failure(failed.value.failure)
    with pytest.raises(WrongForm) as wrong:
        conform(form(returns), value, "f", (np.zeros(5),))
    assert (str(wrong.value), wrong.value.hint) == (str(failed.value), failed.value.failure.hint)


def test_infinity_is_a_number_where_it_is_promised():
    assert result(array(infinite=True), np.inf, "f", Case()) == np.inf


@pytest.mark.parametrize("actual", [np.nan, np.inf, [1.0, np.nan], []])
def test_expect_lets_nothing_through_that_is_no_number(actual):
    with pytest.raises(Failed):
        expect(actual, np.ones_like(actual), tolerance=1e300)


@pytest.mark.parametrize(
    ("expression", "reference"),
    [
        ("(m * l - m * g * sympy.sin(theta)) / (m * l) - 1", True),  # SymPy does not simplify it
        ("-g * sympy.sin(theta) / l + m - sympy.sqrt(m**2)", True),  # m cancels, because a mass is positive
        ("(sympy.exp(-sympy.I * theta) - sympy.exp(sympy.I * theta)) * g / (2 * sympy.I * l)", True),
        ("-sympy.Symbol('g', positive=True) * sympy.sin(theta) / sympy.Symbol('l', real=True)", True),
        ("-g * sympy.sin(theta) / l + sympy.I * g / 10**9", False),
        ("-g * sympy.sin(theta) / (l * m**1e-9)", False),
        ("-g * sympy.sin(theta) / l / sympy.Function('f')(theta)", False),
    ],
)
def test_what_cancels_may_stand_in_a_formula(expression, reference, symbolic):
    student = symbolic(expression)
    points = [{"theta": 0.3, "l": 2.0, "g": 9.0}, {"theta": 2.0, "l": 0.5, "g": 3.0}]
    if reference:
        sought = [-p["g"] * math.sin(p["theta"]) / p["l"] for p in points]
        assert student.lagrange_equation.at(points) == pytest.approx(sought, rel=1e-14)
    else:
        with pytest.raises(Failed, match="theta, l, g alone|not real"):
            student.lagrange_equation.at(points)


@pytest.mark.parametrize(
    ("expression", "form"),
    [
        ("sympy.Eq(theta, l)", "an equation"),
        ("[-g * theta / l]", "a list"),
        ("sympy.Matrix([-g * theta / l])", "a matrix"),
        ("{theta: -g * theta / l}", "a dict"),
        ("'-g*sin(theta)/l'", "text"),
        ("lambda theta: -g * theta / l", "a function"),
        ("sympy.lambdify(theta, theta)", "a function"),
        ("None", "None"),
    ],
)
def test_what_is_no_formula_is_told_alike_here_and_at_home(expression, form, symbolic):
    with pytest.raises(Failed) as failed:
        symbolic(expression).lagrange_equation.at([{"theta": 0.3, "l": 2.0, "g": 9.0}])
    names = {"sympy": sympy, **{name: sympy.Symbol(name) for name in ("theta", "l", "g")}}
    with pytest.raises(WrongForm) as wrong:
        conform({"formula": ["theta", "l", "g"]}, eval(expression, names), "lagrange_equation", ())
    assert str(failed.value) == str(wrong.value) == f"lagrange_equation returned {form} in place of a SymPy expression"
    assert failed.value.failure.hint == wrong.value.hint == REMEDIES[form]
