"""An engine is kept for a right-hand side that has not changed, and for no other."""

import dataclasses
import functools
import types

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.integrate.cache_key import Changeable, cache_key
from tam570.integrate.engine import engine

TIMES, START = np.array([0.0, 1.0]), np.array([1.0, 0.5])
GRAVITY = 9.81


def end(rhs, method="auto", **parameters):
    return solve(rhs, TIMES, START, parameters=parameters, method=method)[-1].tolist()


def oscillator(rate):
    return lambda t, y: (y[1], -rate * y[0])


def falling(t, y, *, gravity=1.0, extra=(0.0,)):
    return y[1], -gravity * GRAVITY + extra[0]


def same(rhs, other, first=None, second=None):
    return engine(rhs, first, TIMES, START) is engine(other, second, TIMES, START)


def test_the_same_code_with_the_same_numbers_is_traced_and_compared_once():
    assert same(oscillator(2.0), oscillator(2.0))
    assert same(falling, falling, {"gravity": 2.0}, {"gravity": 2.0})


def test_what_a_closure_or_a_parameter_holds_makes_another_engine():
    assert not same(oscillator(2.0), oscillator(3.0))
    assert not same(oscillator(0.0), oscillator(-0.0))
    assert not same(oscillator(1), oscillator(True))
    assert not same(falling, falling, {"gravity": 2.0}, {"gravity": 3.0})
    assert end(oscillator(4.0)) != end(oscillator(9.0))


def changed_in_place():
    """Right-hand sides, and functions that change what they read."""
    numbers, inner, matrix, values = [1.0], [1.0], np.array([[0.0, 1.0], [-1.0, 0.0]]), {"rate": 1.0}
    thing, module = types.SimpleNamespace(rate=1.0), types.ModuleType("constants")
    module.rate = 1.0

    def with_attribute(t, y):
        return y[1], -with_attribute.rate * y[0]

    def with_default(t, y, numbers=[1.0]):  # noqa: B006
        return y[1], -numbers[0] * y[0]

    def rate():
        return inner[0]

    with_attribute.rate = 1.0
    default = with_default.__defaults__[0]
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
    }


CASES = [("auto", each) for each in changed_in_place()] + [("compiled", each) for each in list(changed_in_place())[:4]]


@pytest.mark.parametrize(("method", "changed"), CASES)
def test_what_is_changed_in_place_between_two_runs_is_seen(method, changed):
    rates, change = changed_in_place()[changed]
    for _ in range(4):  # a compiled run is kept from the third on
        assert end(rates, method) == pytest.approx(end(oscillator(1.0)), rel=1e-9)
    change()
    assert end(rates, method) == pytest.approx(end(oscillator(5.0)), rel=1e-9)


def test_a_global_changed_between_two_runs_is_seen(monkeypatch):
    first = end(falling)
    monkeypatch.setitem(globals(), "GRAVITY", 1.62)
    assert end(falling)[1] == pytest.approx(START[1] - 1.62)
    assert end(falling) != first


def test_other_code_makes_another_engine_even_in_the_same_function():
    def rates(t, y):
        return y[1], -y[0]

    assert end(rates)
    rates.__code__ = (lambda t, y: (y[1], -9.0 * y[0])).__code__
    assert end(rates) == pytest.approx(end(oscillator(9.0)), rel=1e-12)


@dataclasses.dataclass
class Spring:
    rate: float = 2.0

    def rates(self, t, y):
        return y[1], -self.rate * y[0]


def by_import(t, y):
    import random

    return y[1], -random.choice([1.0]) * y[0]


@pytest.mark.parametrize("value", [Spring(), Spring().rates, by_import, [].append, object(), np.array([object()])])
def test_what_may_change_unseen_has_no_key(value):
    with pytest.raises(Changeable):
        cache_key(value)


def test_methods_of_objects_that_change_are_traced_anew():
    spring = Spring()
    first = end(spring.rates)
    spring.rate = 7.0
    assert end(spring.rates) == pytest.approx(end(oscillator(7.0)), rel=1e-9)
    assert first == pytest.approx(end(oscillator(2.0)), rel=1e-9)
