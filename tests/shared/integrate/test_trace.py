"""Tracing writes a right-hand side as code, complete and without repetition, and caches it until anything changes."""

import ast
import dataclasses
import functools
import math
import types

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.integrate.cache_key import Changeable, cache_key
from tam570.integrate.dop853 import rates
from tam570.integrate.engine import engine
from tam570.integrate.formulas import written
from tam570.integrate.trace import Untraceable, traced

TIMES, START = np.array([0.0, 1.0]), np.array([1.0, 0.5])
GRAVITY = 9.81


def operations(rhs, size, **parameters):
    """Return the number of operations in one evaluation of the generated source."""
    formulas, _ = written(traced(functools.partial(rhs, **parameters), size))
    rhs, *_ = ast.parse(rates(formulas)).body
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


def test_helpers_and_numpy_functions_are_traced_too():
    array = np.array  # as after `from numpy import array`

    def helper(x):
        return np.sin(x) + math.cos(x) ** 2

    def rates(t, y, *, matrix):
        return matrix @ array([helper(y[0]), np.sqrt(y[1] ** 2 + 1)]) - np.cross([y[0], 0, 1], [0, 1, y[1]])[:2]

    bound = functools.partial(rates, matrix=np.array([[1.0, 0.0], [-2.0, 0.5]]))
    assert engine(bound, None, np.array([0.0, 1.0]), np.array([1.0, 0.0])).is_traced


class Trouble(Exception):
    """An exception that a right-hand side raises."""


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


def end(rhs, method="auto", **parameters):
    return solve(rhs, TIMES, START, parameters=parameters, method=method)[-1].tolist()


def oscillator(rate):
    return lambda t, y: (y[1], -rate * y[0])


def falling(t, y, *, gravity=1.0, extra=(0.0,)):
    return y[1], -gravity * GRAVITY + extra[0]


def same(rhs, other, first=None, second=None):
    return engine(rhs, first, TIMES, START) is engine(other, second, TIMES, START)


def test_an_engine_is_that_of_a_code_and_of_what_its_closure_and_parameters_hold():
    assert same(oscillator(2.0), oscillator(2.0))
    assert same(falling, falling, {"gravity": 2.0}, {"gravity": 2.0})
    assert not same(oscillator(2.0), oscillator(3.0))
    assert not same(oscillator(0.0), oscillator(-0.0))
    assert not same(oscillator(1), oscillator(True))
    assert not same(falling, falling, {"gravity": 2.0}, {"gravity": 3.0})
    assert end(oscillator(4.0)) != end(oscillator(9.0))


@dataclasses.dataclass
class Spring:
    rate: float = 2.0

    def rates(self, t, y):
        return y[1], -self.rate * y[0]


def changed_in_place():
    """Return {name: (right-hand side, function that changes a value that it reads)}."""
    numbers, inner, matrix, values = [1.0], [1.0], np.array([[0.0, 1.0], [-1.0, 0.0]]), {"rate": 1.0}
    thing, module = types.SimpleNamespace(rate=1.0), types.ModuleType("constants")
    module.rate = 1.0

    def with_attribute(t, y):
        return y[1], -with_attribute.rate * y[0]

    def with_default(t, y, numbers=[1.0]):  # noqa: B006
        return y[1], -numbers[0] * y[0]

    def rate():
        return inner[0]

    def with_code(t, y):
        return y[1], -y[0]

    with_attribute.rate = 1.0
    default, spring, other = with_default.__defaults__[0], Spring(1.0), (lambda t, y: (y[1], -5.0 * y[0])).__code__
    partial = functools.partial
    return {
        "list": (lambda t, y: (y[1], -numbers[0] * y[0]), partial(numbers.__setitem__, 0, 5.0)),
        "array": (lambda t, y: matrix @ y, partial(matrix.__setitem__, (1, 0), -5.0)),
        "dictionary": (lambda t, y: (y[1], -values["rate"] * y[0]), partial(values.update, rate=5.0)),
        "default": (with_default, partial(default.__setitem__, 0, 5.0)),
        "object": (lambda t, y: (y[1], -thing.rate * y[0]), partial(setattr, thing, "rate", 5.0)),
        "module": (lambda t, y: (y[1], -module.rate * y[0]), partial(setattr, module, "rate", 5.0)),
        "attribute of a function": (with_attribute, partial(setattr, with_attribute, "rate", 5.0)),
        "inner function": (lambda t, y: (y[1], -rate() * y[0]), partial(inner.__setitem__, 0, 5.0)),
        "method": (spring.rates, partial(setattr, spring, "rate", 5.0)),
        "code": (with_code, partial(setattr, with_code, "__code__", other)),
    }


CASES = [("auto", each) for each in changed_in_place()] + [("compiled", each) for each in list(changed_in_place())[:4]]


@pytest.mark.parametrize(("method", "changed"), CASES)
def test_what_is_changed_in_place_between_two_runs_is_seen(method, changed):
    rates, change = changed_in_place()[changed]
    for _ in range(4):  # a compiled run is cached from the third on
        assert end(rates, method) == pytest.approx(end(oscillator(1.0)), rel=1e-9)
    change()
    assert end(rates, method) == pytest.approx(end(oscillator(5.0)), rel=1e-9)


def test_a_global_changed_between_two_runs_is_seen(monkeypatch):
    first = end(falling)
    monkeypatch.setitem(globals(), "GRAVITY", 1.62)
    assert end(falling)[1] == pytest.approx(START[1] - 1.62)
    assert end(falling) != first


def by_import(t, y):
    import random

    return y[1], -random.choice([1.0]) * y[0]


@pytest.mark.parametrize("value", [Spring(), Spring().rates, by_import, [].append, object(), np.array([object()])])
def test_what_may_change_unseen_has_no_key(value):
    with pytest.raises(Changeable):
        cache_key(value)
