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


def same(one, other, first=None, second=None):
    return engine(one, first, TIMES, START) is engine(other, second, TIMES, START)


def test_the_same_code_with_the_same_numbers_is_traced_and_compared_once():
    assert same(oscillator(2.0), oscillator(2.0))
    assert same(falling, falling, {"gravity": 2.0}, {"gravity": 2.0})


def test_what_a_closure_or_a_parameter_holds_makes_another_engine():
    assert not same(oscillator(2.0), oscillator(3.0))
    assert not same(oscillator(0.0), oscillator(-0.0))
    assert not same(oscillator(1), oscillator(True))
    assert not same(falling, falling, {"gravity": 2.0}, {"gravity": 3.0})
    assert end(oscillator(4.0)) != end(oscillator(9.0))


def changed_in_place(kind):
    """Pairs of a right-hand side and a function that changes what it reads."""
    if kind == "list":
        held = [1.0]
        return lambda t, y: (y[1], -held[0] * y[0]), functools.partial(held.__setitem__, 0, 5.0)
    if kind == "array":
        matrix = np.array([[0.0, 1.0], [-1.0, 0.0]])
        return lambda t, y: matrix @ y, functools.partial(matrix.__setitem__, (1, 0), -5.0)
    if kind == "dictionary":
        known = {"rate": 1.0}
        return lambda t, y: (y[1], -known["rate"] * y[0]), functools.partial(known.update, rate=5.0)
    if kind == "object":
        thing = types.SimpleNamespace(rate=1.0)
        return lambda t, y: (y[1], -thing.rate * y[0]), functools.partial(setattr, thing, "rate", 5.0)
    if kind == "attribute of a function":

        def rates(t, y):
            return y[1], -rates.rate * y[0]

        rates.rate = 1.0
        return rates, functools.partial(setattr, rates, "rate", 5.0)
    if kind == "default":

        def with_default(t, y, held=[1.0]):  # noqa: B006
            return y[1], -held[0] * y[0]

        return with_default, functools.partial(with_default.__defaults__[0].__setitem__, 0, 5.0)
    if kind == "inner function":
        held = [1.0]

        def rate():
            return held[0]

        return lambda t, y: (y[1], -rate() * y[0]), functools.partial(held.__setitem__, 0, 5.0)
    module = types.ModuleType("constants")
    module.rate = 1.0
    return lambda t, y: (y[1], -module.rate * y[0]), functools.partial(setattr, module, "rate", 5.0)


KINDS = [
    "list",
    "array",
    "dictionary",
    "object",
    "attribute of a function",
    "default",
    "function of a function",
    "module",
]


@pytest.mark.parametrize(
    ("method", "kind"),
    [("auto", kind) for kind in KINDS]
    + [("compiled", kind) for kind in KINDS if kind in ("list", "array", "dictionary", "default")],
)
def test_what_is_changed_in_place_between_two_runs_is_seen(method, kind):
    rates, change = changed_in_place(kind)
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
