"""Order of the methods; zeros of an error estimate do not mislead the steps, and rounding does not stop them."""

import math
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
from systems import EPS, clock, oscillator, pendulum

from tam570.integrate import dop853, solve
from tam570.integrate.dop853 import compiled
from tam570.integrate.formulas import written
from tam570.integrate.trace import traced
from tam570.invariants import observed_order


def test_tableau_satisfies_the_order_conditions():
    b = dop853.ROWS[12]
    for power in range(8):
        moment = sum(Fraction(w) * Fraction(dop853.NODES[j]) ** power for j, w in b.items())
        assert abs(moment - Fraction(1, power + 1)) < 20 * EPS  # some weights are as large as 6
    third = {j: b.get(j, 0.0) + dop853.LESS.get(j, 0.0) for j in b}
    for estimate in (dop853.FIFTH, third):
        assert abs(sum(estimate.values())) < 20 * EPS  # no error where the derivative is constant


def one_step(h, theta=None):
    formulas, constants = written(traced(clock, 1))
    functions = compiled(formulas, True)
    y = (1.0,)
    f = functions["rhs"](0.3, y, constants)
    n, _, g, fifth, third, stages = functions["step"](0.3, h, y, (0.0,), f, y, (0.0,), 0.0, constants)
    out = np.empty((1, 1))
    if theta is None:
        return n[0], fifth, third
    functions["at"](out, 0, theta, y, functions["dense"](0.3, h, y, n, f, g, stages, constants))
    return out[0, 0]


def exact_clock(t):
    return math.exp(math.sin(0.3 + t) - math.sin(0.3))


def test_a_step_is_of_order_eight_and_its_estimates_of_five_and_three():
    steps = np.array([1.6, 1.2, 0.9, 0.7])
    results = [one_step(h) for h in steps]
    errors = [abs(n - exact_clock(h)) for h, (n, _, _) in zip(steps, results, strict=True)]
    assert observed_order(steps, errors) > 8.5  # the error of one step has order 9
    small = steps / 4
    fifth, third = np.transpose([one_step(h)[1:] for h in small]) ** 0.5
    assert observed_order(small, fifth) > 5.6
    assert observed_order(small, third) > 3.6


def test_inside_a_step_the_error_is_that_of_the_step():
    for h in (0.5, 0.3, 0.2):
        worst = max(abs(one_step(h, x) - exact_clock(x * h)) for x in np.linspace(0.02, 0.98, 25))
        n, fifth, third = one_step(h)
        estimate = fifth / math.sqrt(fifth + 0.01 * third)
        assert worst < 5 * max(estimate, abs(n - exact_clock(h)))  # 20 to 60 with DOP853's interpolant


@pytest.mark.parametrize(("method", "order"), [("gauss", 12), ("composition", 8)])
def test_fixed_steps_show_their_order(method, order):
    steps = np.array([0.8, 0.5, 0.4]) if method == "gauss" else np.array([0.2, 0.125, 0.1])
    swing = partial(solve, pendulum, [0, 4], [1.0, 0.5], parameters={"length": 9.81, "gravity": 9.81})
    exact = swing(rtol=1e-15)[-1]
    errors = [np.abs(swing(method=method, step=h)[-1] - exact).max() for h in steps]
    assert observed_order(steps, errors) > order - 0.7


def test_gauss_knows_the_time_of_its_stages():
    steps = np.array([1.0, 0.8, 0.5])
    errors = [abs(solve(clock, [0, 4], [1.0], method="gauss", step=h)[-1, 0] - math.exp(math.sin(4))) for h in steps]
    assert observed_order(steps, errors) > 10.5


def test_tolerances_beyond_rounding_finish():
    for rtol in (1e-15, 1e-17, 1e-30):
        state = solve(oscillator, [0, 100], [1.0, 0.0], rtol=rtol)[-1]
        assert state == pytest.approx([math.cos(100), -math.sin(100)], abs=100 * EPS)


def test_an_estimate_that_passes_through_zero_deceives_nobody():
    """The estimate of order 5 changes sign in the last step; used alone, it would let the error be 600 tolerances."""
    t = np.array([-3.0, -1.0, 2.0])
    states = solve(lambda t, y: (-y[0] * math.cos(t),), t, [math.exp(math.sin(3.0))], rtol=1e-12, method="python")
    assert states[:, 0] == pytest.approx(np.exp(-np.sin(t)), rel=1e-11)


def test_atol_spares_steps_where_nobody_looks():
    """An atol above the size of a tiny component saves the steps that its own scale needs."""

    def rates(t, y):
        return y[1], -y[0], y[3], -400 * y[2]

    def steps(**arguments):
        return solve(rates, [0, 20.0], [1.0, 0.0, 1e-12, 0.0], report=True, method="python", **arguments).report.steps

    assert steps(atol=1e-10) < steps() / 5
    assert steps(atol=[0.0, 0.0, 1e-10, 1e-10]) < steps() / 5
    assert steps(atol=0.0) >= steps()
