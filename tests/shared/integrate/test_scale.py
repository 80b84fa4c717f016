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


def test_what_moves_keeps_its_own_size():
    assert sizes(lambda t, y: (y[1], -y[0]), (2.0, 3.0), 0.1) == (2.0, 3.0)
    assert sizes(lambda t, y: (y[1], -y[0]), (2.0, 0.0), 0.1) == (2.0, 0.2)  # at rest, and about to move
    assert sizes(lambda t, y: (y[1], -y[0]), (2.0, 0.0), 0.1, m=[5.0, 7.0]) == (5.0, 7.0)


def test_a_chain_hands_its_size_on_and_less_of_it_from_link_to_link():
    found = sizes(chain, [1.0, *[0.0] * 15], 0.1)
    assert found[0] == 1.0
    assert all(NO_SCALE < b < a for a, b in zip(found[:8], found[1:8], strict=False))


@pytest.mark.parametrize("unit", [2.0**-40, 2.0**40])
def test_sizes_go_with_the_unit(unit):
    found, other = sizes(chain, [1.0, *[0.0] * 15], 0.1), sizes(chain, [unit, *[0.0] * 15], 0.1)
    assert other == tuple(unit * size for size in found)


def test_a_stiff_spring_at_its_length_does_not_make_a_size_of_a_step_that_is_too_long():
    """It would turn over in 1e-4 s; in the step of 0.1 s that its rest suggests, the speed looks like 1e7 m/s."""
    found = sizes(lambda t, y: (y[1], -1e8 * (y[0] - 1)), (1.0, 0.0), 0.1)
    assert found[1] < 10 * math.sqrt(1e8)


def test_a_force_that_sets_in_later_gives_a_size_to_what_it_moves():
    def rates(t, y):
        return y[1], 3.0 if t > 1 else 0.0

    assert sizes(rates, (0.0, 0.0), 0.1) == (NO_SCALE, NO_SCALE)
    assert sizes(rates, (0.0, 0.0), 0.1, later=[0.5, 2.0]) == pytest.approx(
        (0.03, 0.3), rel=0.2
    )  # each is changed by another part of its size


def test_what_is_smaller_than_the_rounding_of_what_drives_it_is_zero():
    def rates(t, y):
        return y[1], -y[0], y[0] + y[2]

    zero, rounded, small = (sizes(rates, (1.0, 0.0, start), 0.1)[2] for start in (0.0, 1e-19, 1e-6))
    assert zero == pytest.approx(rounded)
    assert small == pytest.approx(0.1)  # by its own rate


def test_what_is_zero_has_a_scale_in_compiled_code_too(monkeypatch):
    pytest.importorskip("llvmlite")

    def in_space(t, y):
        return [*y[3:], *(-x / (y[0] ** 2 + y[1] ** 2 + y[2] ** 2) ** 1.5 for x in y[:3])]

    def none(*given):
        raise AssertionError("a scale was looked for in Python")

    monkeypatch.setattr("tam570.integrate.adaptive.error_scale", none)
    states = solve(chain, [0, 10.0], [1.0, *[0.0] * 15], method="compiled")
    circle = solve(in_space, [0, 10.0], [1.0, 0, 0, 0, 1.0, 0], method="compiled")[-1]
    monkeypatch.undo()
    assert states[-1] == pytest.approx(solve(chain, [0, 10.0], [1.0, *[0.0] * 15], method="python")[-1], abs=1e-8)
    assert circle[:3] == pytest.approx([math.cos(10), math.sin(10), 0.0], abs=1e-8)


def test_sizes_are_not_so_large_that_the_rates_are_others():
    """A pendulum let go level, by its direction and its rate: to first order nothing known is ever turned over."""
    found = sizes(lambda t, y: (-y[1] * y[2], y[0] * y[2], -9.81 * y[0]), (1.0, 0.0, 0.0), 0.0625)
    assert 0.1 < found[1] < 1.0  # the largest that it can be; 1758 to first order
