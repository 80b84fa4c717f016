"""A right-hand side is written down as it is in its scene: nothing missing, nothing twice, nothing stale."""

import ast
import functools
import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.integrate.dop853 import rates
from tam570.integrate.engine import engine
from tam570.integrate.formulas import written
from tam570.integrate.trace import Untraceable, traced


def operations(rhs, size, **parameters):
    """Operations of one evaluation, counted in the generated source."""
    formulas, _ = written(traced(functools.partial(rhs, **parameters), size))
    rhs, _ = ast.parse(rates(formulas)).body
    return sum(isinstance(node, (ast.BinOp, ast.UnaryOp, ast.Call)) for node in ast.walk(rhs))


def drag_and_wind(t, state, *, mass, drag, gravity, wind):
    x, y, z, u, v, w = state
    speed = math.sqrt((u - wind) ** 2 + v * v + w * w)
    return (u, v, w, -drag / mass * speed * (u - wind), -drag / mass * speed * v, -drag / mass * speed * w - gravity)


def test_what_a_scene_lacks_is_not_computed():
    parameters = {"mass": 2.0, "drag": 0.1, "gravity": 9.81, "wind": 3.0}
    full = operations(drag_and_wind, 6, **parameters)
    for absent in ("wind", "gravity", "drag"):
        assert operations(drag_and_wind, 6, **{**parameters, absent: 0.0}) < full
    assert operations(drag_and_wind, 6, **{**parameters, "drag": 0.0}) == 0  # constant rates


def test_what_occurs_twice_is_computed_once():
    graph = traced(lambda t, y: (math.sin(y[0]) * y[1], y[1] * math.sin(y[0]) + math.sin(y[0])), 2)
    formulas, _ = written(graph)
    assert "\n".join((*formulas.lines, *formulas.rates)).count("sin") == 1


@pytest.mark.parametrize("question", [lambda x: x > 0, lambda x: x == 0, bool, float, int, lambda x: max(x, 0.0)])
def test_a_function_that_asks_for_values_is_not_written_down(question):
    with pytest.raises((Untraceable, TypeError)):
        traced(lambda t, y: (1.0 if question(y[0]) else 2.0,), 1)


def test_a_function_that_treats_symbols_otherwise_is_found_out():
    def two_faced(t, y):
        return (y[1], -y[0]) if isinstance(y[0], float) else (y[1], y[0])

    assert not engine(two_faced, None, np.array([0.0, 1.0]), np.array([1.0, 0.0])).is_traced
    assert solve(two_faced, [0, math.pi], [1.0, 0.0])[-1] == pytest.approx([-1, 0], abs=1e-9)


def test_helpers_and_numpy_functions_are_traced_too():
    def helper(x):
        return np.sin(x) + math.cos(x) ** 2

    def rates(t, y, *, matrix):
        return matrix @ np.array([helper(y[0]), np.sqrt(y[1] ** 2 + 1)]) - np.cross([y[0], 0, 1], [0, 1, y[1]])[:2]

    bound = functools.partial(rates, matrix=np.array([[1.0, 0.0], [-2.0, 0.5]]))
    assert engine(bound, None, np.array([0.0, 1.0]), np.array([1.0, 0.0])).is_traced


class Trouble(Exception):
    """A function's own."""


def test_a_refusal_says_why_and_an_error_of_the_functions_own_is_not_one():
    def rebranded(t, y):
        try:
            return (float(y[0]),)
        except TypeError as problem:
            raise Trouble("only numbers") from problem

    def broken(t, y):
        raise Trouble("always")

    with pytest.raises(Untraceable, match="value of the state"):
        traced(rebranded, 1)
    with pytest.raises(Untraceable, match="type of the state"):
        traced(lambda t, y: math.nan if isinstance(y[0], float) else (_ for _ in ()).throw(ValueError("no")), 1)
    with pytest.raises(Trouble, match="always"):
        traced(broken, 1)
    assert solve(rebranded, [0, 1.0], [1.0])[-1, 0] == pytest.approx(math.e, rel=1e-9)
