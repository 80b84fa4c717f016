"""Components that are only rounding of larger ones cost no steps; small components with physics keep their scale."""

import math

import numpy as np
import pytest
from parameters import first
from run_time.public import PROBLEMS
from scipy.integrate import solve_ivp

from tam570.integrate import solve
from tam570_grader.checks import assignments

EPS = 2.0**-52
HW06, HW14 = (assignments.solution(slug) for slug in ("hw06_braking", "hw14_rolling_disk"))
DISK = {"mass": 1.0, "radius": 0.5, "inertia": (0.0625, 0.125), "gravity": 9.81}
CAR = {"mass": 1136.0, "yaw_inertia": 1300.0, "front": 1.9, "rear": 1.1, "friction": 0.7, "gravity": 9.81}


def disk(tilt, yaw=0.3, yaw_rate=0.0, spin=0.0):
    return HW14.matrix_state([1.0, 2.0, yaw, tilt, 0.2, yaw_rate, 0.0, spin], radius=0.5)


def by_matrix(t, y):
    return HW14.matrix_state_derivative(t, y, **DISK)


def by_angles(t, y):
    return HW14.euler_state_derivative(t, y, **DISK)


def braking(locked):
    return lambda t, y: HW06.state_derivative(t, y, locked, **CAR)


def balanced(t, y):
    """Return the rates of two bodies on a spring and of their centre, whose acceleration is only rounding."""
    pull = y[1] - y[0]
    return y[2], y[3], pull, -pull, y[5], (y[0] + 0.1) - 0.1 - y[0]


def circular(t, y):
    r, _, outwards, turning = y
    return outwards, turning, r * turning * turning - 1 / (r * r), -2 * outwards * turning / r


ROUNDED = {
    "a disk let go at rest": (by_matrix, disk(1.2), 0.4),
    "a disk let go nearly upright": (by_matrix, disk(math.pi / 2 - 0.1), 0.8),
    "a disk that rolls straight on": (by_matrix, disk(math.pi / 2, spin=8.0), 5.0),
    "the same by angles": (by_angles, np.array([0, 0, 0.3, math.pi / 2, 0.2, 0, 0, 8.0]), 5.0),
    "a disk that spins upright": (by_angles, np.array([0, 0, 0.3, math.pi / 2, 0.2, 3.0, 0, 0]), 5.0),
    "a car that brakes straight": (braking("front"), np.array([1.0, 2.0, 0.74, 24.4, 0.0]), 3.0),
    "a car with locked rear wheels": (braking("rear"), np.array([1.0, 2.0, -2.3, 11.0, 0.0]), 1.4),
    "a rate that is rounding": (lambda t, y: (y[1], -y[0], y[0] + 3.0 - 3.0 - y[0]), np.array([1.0, 0.0, 0.0]), 20.0),
    "a centre of mass": (balanced, np.array([1.0, -1.0, 0.0, 0.0, 0.0, 0.0]), 50.0),
    "a circular orbit": (circular, np.array([1.7, 0.0, 0.0, 1.7**-1.5]), 60.0),
}
DETEST = ("DETEST C1", "DETEST C3", "DETEST C4")
CHAINS = {name: (PROBLEMS[name][0], np.array(PROBLEMS[name][1]), 20.0) for name in DETEST}


class TooMany(Exception):
    """The rates are called too often."""


def counted(rates, allowed=math.inf):
    """Return `rates` with a branch, so that they are called at every stage, and a list with an item for each call."""
    calls = []

    def counting(t, y):
        calls.append(0)
        if len(calls) > allowed or not y[0] < math.inf:
            raise TooMany
        return rates(t, y)

    return counting, calls


def by_scipy(rates, start, end, rtol):
    result = solve_ivp(rates, (0, end), start, method="DOP853", rtol=rtol, atol=rtol * np.abs(start).max())
    return result.y[:, -1], result.nfev


@pytest.mark.parametrize("name", [*ROUNDED, *CHAINS])
@pytest.mark.parametrize("rtol", first(1, [1e-9, 1e-6, 1e-12]))
def test_what_is_only_rounding_or_far_away_costs_no_steps(name, rtol):
    """`solve` needs at most 600 calls and 4 times those of SciPy, which scales all errors by the largest component."""
    rates, start, end = {**ROUNDED, **CHAINS}[name]
    _, evaluations = by_scipy(rates, start, end, rtol)
    exact, _ = by_scipy(rates, start, end, 3e-14)  # at rtol itself SciPy is off by ten rtol on some processors
    result = solve(counted(rates, 4 * evaluations + 600)[0], [0, end], start, rtol=rtol, method="python")[-1]
    traced = solve(rates, [0, end], start, rtol=rtol, method="python", report=True).report  # traced if possible
    assert traced.evaluations <= 4 * evaluations + 600
    if name != "a car with locked rear wheels":  # there rounding grows until it is visible
        assert np.abs(result - exact).max() < 300 * rtol * np.abs(exact).max() + 1e-13


def test_heat_that_meets_heat_is_solved():
    """A small start in the middle of a chain, overtaken by larger heat from the end, keeps its accuracy."""
    rates, start, end = CHAINS["DETEST C4"]
    start = np.where(np.arange(51) == 25, 2e-11, start)
    by_steps, by_series = (
        solve(rates, [0, end], start, rtol=1e-13, method=method) for method in ("python", "compiled")
    )
    assert by_steps[-1] == pytest.approx(by_series[-1], rel=1e-13, abs=0)


@pytest.mark.parametrize("rate", [0.0, 1e-9])
def test_a_disk_upright_to_the_last_digits_rolls_on(rate):
    """The tilt is pi/2 rounded; the steps need not resolve what this rounding does to the other rates."""

    def rolled(tilt_rate):
        rates, calls = counted(by_angles)
        end = solve(rates, [0, 10], [0, 0, 0, math.pi / 2, 0, 0, tilt_rate, 8.0], rtol=1e-12)[-1]
        return end, len(calls)

    (end, cost), (wobble, ordinary) = rolled(rate), rolled(1e-3)
    assert cost < 2 * ordinary  # sixty times as many if rounding counts as motion
    assert end[[0, 4, 7]] == pytest.approx([-40, 80, 8], rel=1e-10)  # straight on
    if rate == 1e-9:  # small motions are proportional to their start, except for the rounding of the tilt
        assert end[[2, 5]] * 1e6 == pytest.approx(wobble[[2, 5]], abs=1e-5 * abs(wobble[5]))


@pytest.mark.parametrize("unit", [2.0**-40, 2.0**40])
def test_no_unit_changes_a_step(unit):
    """Springs are linear: in any unit of length the motion is the same, its rounding too."""
    rates, start, end = ROUNDED["a centre of mass"]

    def scaled(t, y):
        return [unit * rate for rate in rates(t, [value / unit for value in y])]

    (plain, calls), (other, others) = counted(rates), counted(scaled)
    assert (solve(plain, [0, end], start)[-1] * unit == solve(other, [0, end], start * unit)[-1]).all()
    assert len(calls) == len(others)


@pytest.mark.parametrize("small", [1e-6, 1e-12, 1e-20])
def test_a_seed_that_nothing_large_drives_keeps_its_own_scale(small):
    """A small population beside an oscillator that drives it grows as exp(t - cos t + 1)."""

    def rates(t, y):
        return y[1], -y[0], y[2] * (1 - y[1])

    for method in ("python", "compiled"):
        result = solve(rates, [0, 20.0], [1.0, 0.0, small], rtol=1e-10, method=method)[-1, 2]
        assert result == pytest.approx(small * math.exp(20 - math.cos(20) + 1), rel=1e-8)


@pytest.mark.parametrize("size", [1e-3, 1e-9, 1e-12])
def test_an_unstable_start_grows_as_it_should_beside_what_is_large(size):
    """A pendulum's small angle from the top grows beside the large position of a cart as it does without the cart."""

    def rates(t, y):
        return y[2], y[3], 0.0, math.sin(y[1])

    result = solve(rates, [0, 5.0], [100.0, size, 3.0, 0.0], rtol=1e-10, method="python")[-1]
    reference = solve_ivp(rates, (0, 5), [0.0, size, 0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14 * size).y[:, -1]
    assert result[[1, 3]] == pytest.approx(reference[[1, 3]], rel=1e-8)


def soft_step(t, y):
    """Return a rate that rises from nearly 0 to 1 at t = 2.3; its first values are a difference of halves."""
    return (0.5 + 0.5 * (t - 2.3) / math.sqrt((t - 2.3) ** 2 + 1e-12),)


MOSTLY_ROUNDING = {  # rates, y(5), and the largest of the numbers whose difference the rates are
    "1 - cos": (lambda t, y: (1 - math.cos(1e-6 * t),), 1e-12 * 125 / 6, 1.0),
    "exp - 1": (lambda t, y: (math.exp(1e-12 * t) - 1,), 12.5e-12, 1.0),
    "log": (lambda t, y: (math.log(1 + 1e-13 * t),), 12.5e-13, 1.0),
    "a soft step": (soft_step, 2.7, 0.5),
}


@pytest.mark.parametrize("name", MOSTLY_ROUNDING)
def test_rates_that_are_mostly_rounding_at_first_cost_few_steps(name):
    rates, end, largest = MOSTLY_ROUNDING[name]
    motion = solve(rates, [0, 5.0], [0.0], dense=True, report=True)
    assert motion.report.steps + motion.report.refusals < 250
    for states in (motion.states, *(solve(rates, [0, 5.0], [0.0], method=how) for how in ("python", "compiled"))):
        assert states[-1, 0] == pytest.approx(end, rel=1e-10, abs=20 * 5.0 * EPS * largest)
