"""The size by which a component is judged before it has shown one."""

import math

import pytest

from tam570.integrate import solve
from tam570.integrate.error_scale import NO_SCALE, error_scale


def sizes(rhs, y, h, later=(), m=None):
    y = tuple(y)
    return error_scale(lambda t, s, c: rhs(t, s), 0.0, h, y, rhs(0.0, y), m or [0.0] * len(y), (), later)


def chain(t, y):
    """Eight masses on springs."""
    x = [0.0, *y[:8], 0.0]
    return [*y[8:], *(x[i - 1] - 2 * x[i] + x[i + 1] for i in range(1, 9))]


def test_a_force_that_sets_in_later_gives_a_size_to_what_it_moves():
    def rates(t, y):
        return y[1], 3.0 if t > 1 else 0.0

    assert sizes(rates, (0.0, 0.0), 0.1) == (NO_SCALE, NO_SCALE)
    assert sizes(rates, (0.0, 0.0), 0.1, later=[0.5, 2.0]) == pytest.approx(
        (0.03, 0.3), rel=0.2
    )  # each is changed by another part of its size


def test_what_is_zero_has_a_scale_in_compiled_code_too(monkeypatch):
    pytest.importorskip("llvmlite")

    def in_space(t, y):
        return [*y[3:], *(-x / (y[0] ** 2 + y[1] ** 2 + y[2] ** 2) ** 1.5 for x in y[:3])]

    def none(*arguments):
        raise AssertionError("a scale was looked for in Python")

    monkeypatch.setattr("tam570.integrate.adaptive.error_scale", none)
    states = solve(chain, [0, 10.0], [1.0, *[0.0] * 15], method="compiled")
    circle = solve(in_space, [0, 10.0], [1.0, 0, 0, 0, 1.0, 0], method="compiled")[-1]
    monkeypatch.undo()
    assert states[-1] == pytest.approx(solve(chain, [0, 10.0], [1.0, *[0.0] * 15], method="python")[-1], abs=1e-8)
    assert circle[:3] == pytest.approx([math.cos(10), math.sin(10), 0.0], abs=1e-8)
