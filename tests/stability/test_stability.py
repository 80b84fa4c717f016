"""Where integrators break: rest, symmetry, separatrices, extremes of scale, length and sampling, zeros, stiffness."""

import math
from functools import partial

import numpy as np
import pytest
from parameters import first
from run_time.scenes import OTHERS, SCENES, scene
from scipy.integrate import solve_ivp
from scipy.special import ellipk
from systems import PENDULUM, pendulum

from tam570.integrate import solve
from tam570.invariants import drift, growth_exponent

G = 9.81  # m/s^2
heat, _, _ = OTHERS["DETEST C3"]


def pendulum_energy(state):
    """Return the energy of a pendulum of 1 m and 1 kg above its lowest point, without the cancellation of 1 - cos."""
    return state[1] ** 2 / 2 + 2 * G * math.sin(state[0] / 2) ** 2


def oscillator(t, y, *, rate):
    return y[1], -rate * rate * y[0]


@pytest.mark.parametrize("name", SCENES)
def test_the_start_of_every_scene_is_left_by_small_steps(name):
    """Two methods that share only the right-hand side agree."""
    rhs, start, parameters, end = scene(name)
    t = np.linspace(0, min(end, 2.0), 5)
    explicit = solve(rhs, t, start, parameters=parameters, rtol=1e-13, method="python")
    implicit = solve(rhs, t, start, parameters=parameters, rtol=1e-12, method="gauss")
    size = np.abs(explicit).max(axis=0) + 1e-300
    assert (np.abs(explicit - implicit) / size).max() < 1e-9


@pytest.mark.parametrize("unit", [2.0**k for k in (-500, -40, -20, 20, 40, 500)])
def test_a_change_of_units_changes_no_bit(unit):
    t, run = np.linspace(0, 10, 21), partial(solve, oscillator, method="python")
    states = run(t, [1.0, 0.25], parameters={"rate": 2.5})
    assert (run(t, [unit, 0.25 * unit], parameters={"rate": 2.5}) == unit * states).all()
    if abs(math.log2(unit)) < 50:  # also for the unit of time
        others = run(t * unit, [1.0, 0.25 / unit], parameters={"rate": 2.5 / unit})
        assert (others * [1, unit] == states).all()


@pytest.mark.parametrize("amplitude", [0.3, 0.7, 1.0, 1.3])
def test_rounding_makes_no_energy_drift(amplitude):
    """A random walk of half a million steps reaches 1e-13; a 1/3 that is rounded the same way in each, 3e-12."""
    turns = [0.0, 2e5 * math.pi]
    _, (x, v) = solve(oscillator, turns, [amplitude, 0.0], parameters={"rate": 1.0}, rtol=1e-15, method="compiled")
    assert x * x + v * v == pytest.approx(amplitude**2, rel=4e-13, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_energy_over_ten_thousand_periods(method):
    """The exponent is that of the mean error of twelve motions, because a single random walk has no clear exponent."""
    errors, share = [], np.geomspace(0.01, 1, 60)
    for amplitude in np.linspace(0.5, 3.0, 12):
        period = 4 / math.sqrt(G) * ellipk(math.sin(amplitude / 2) ** 2)
        t = np.concatenate([[0.0], 1e4 * period * share])
        states = solve(pendulum, t, [amplitude, 0.0], parameters=PENDULUM, method=method, rtol=1e-13)
        errors.append(drift(pendulum_energy, states)[1:])
    assert np.max(errors) < 5e-14
    mean = np.sqrt(np.mean(np.square(errors), axis=0))
    assert growth_exponent(share, mean) < 0.6  # a random walk is 0.5, a drift would be 1


def chain(t, y):
    """Return the rates of masses of 1 kg between springs of 1 N/m with fixed ends."""
    return [*y[len(y) // 2 :], *heat(t, y[: len(y) // 2])]


def by_scipy(rates, t, start, **options):
    """Return the states of SciPy's DOP853 at its best tolerance, unless options say otherwise."""
    options = {"method": "DOP853", "rtol": 3e-14, "atol": 1e-16, **options}
    result = solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, **options)
    assert result.success
    return result.y.T


def cascade(t, y):
    """Return rates in which each component drives the next by its square; at first only the first one has an effect."""
    return [-y[0], *(a * a - b for a, b in zip(y, y[1:], strict=False))]


@pytest.mark.parametrize(
    ("rates", "start", "end"),
    [
        *((chain, np.eye(2 * masses)[0], 20) for masses in (4, 8, 30)),
        *((OTHERS[f"FPU {name}"][0], np.eye(32)[16], 20) for name in ("alpha, 8", "beta, 16")),
        (heat, np.eye(50)[25], 5),  # C4 has 51 from the edge
        (heat, np.eye(50)[0], 5),
        *((OTHERS[f"DETEST {name}"][0], np.eye(10)[0], 20) for name in ("C1", "C2")),
        (cascade, np.eye(6)[0], 10),
    ],
    ids=["4 masses", "8 masses", "30 masses", "FPU alpha", "FPU beta", "heat inside", "heat", "C1", "C2", "cascade"],
)
@pytest.mark.parametrize("rtol", first(1, [1e-8, 1e-6, 1e-11]))
def test_what_reaches_the_others_only_later(rates, start, end, rtol):
    t = np.linspace(0, end, 21)
    states, exact = solve(rates, t, start, rtol=rtol), by_scipy(rates, t, start)
    theirs = np.abs(by_scipy(rates, t, start, rtol=rtol, atol=rtol) - exact).max()  # C2 is stiff: 40 times rtol
    assert np.abs(states - exact).max() < max(10 * rtol, theirs)


def test_an_ensemble_under_a_force_that_sets_in_late():
    """Each member agrees with its single run; the force, a square root, is zero until t = 3."""

    def rates(t, y):
        return y[1], np.sqrt(np.abs(t - 3) + (t - 3)) - y[0]

    t, starts = np.linspace(0, 10, 5), np.zeros((20, 2))
    starts[10:, 0] = 1.0
    together = solve(rates, t, starts, rtol=1e-8, method="python")
    for start, result in zip(starts, together, strict=True):
        assert result == pytest.approx(solve(rates, t, start, rtol=1e-10, method="python"), abs=1e-6)


def test_an_ensemble_respects_the_atol_of_the_caller():
    """The motion shrinks by a factor of e^50 and grows back, which only atol=0 computes."""

    def rates(t, y):
        return (t - 10) * y[0] - 3 * y[1], (t - 10) * y[1] + 3 * y[0]

    starts = np.random.default_rng(575).normal(size=(20, 2))
    together = solve(rates, [0, 20.0], starts, atol=[0.0, 0.0], method="compiled")[:, -1]
    assert together @ [1, 1j] == pytest.approx(np.exp(60j) * (starts @ [1, 1j]), rel=1e-7)


def van_der_pol(t, y, *, stiffness):
    return y[1], stiffness * (1 - y[0] ** 2) * y[1] - y[0]


def robertson(t, y):
    a, b, c = y
    return -0.04 * a + 1e4 * b * c, 0.04 * a - 1e4 * b * c - 3e7 * b * b, 3e7 * b * b


@pytest.mark.parametrize("method", ["python", "auto"])
@pytest.mark.parametrize(
    ("rhs", "end", "start", "parameters"),
    [
        (van_der_pol, 1e8, [2.0, 0.0], {"stiffness": 1e5}),
        (van_der_pol, 3e9, [2.0, 0.0], {"stiffness": 1e3}),
        (robertson, 1e11, [1.0, 0.0, 0.0], {}),
    ],
)
def test_what_would_never_end_is_told_with_its_remedy(method, rhs, end, start, parameters):
    with pytest.raises(ArithmeticError, match=r"stiff at t = .*Radau.*LSODA"):
        solve(rhs, [0, end], start, parameters=parameters, method=method, rtol=1e-8)


@pytest.mark.parametrize("method", ["python", "auto"])
def test_what_ends_in_time_is_right(method):
    states = solve(robertson, [0, 10.0], [1.0, 0.0, 0.0], method=method, rtol=1e-9)
    exact = by_scipy(robertson, [0, 10.0], [1.0, 0.0, 0.0], method="Radau", rtol=1e-10, atol=1e-14)
    assert states[-1] == pytest.approx(exact[-1], rel=1e-6, abs=1e-11)


@pytest.mark.parametrize("rtol", first(1, [1e-3, 1e-10]))
def test_a_long_oscillation_is_not_called_stiff(rtol):
    """A fast, slightly damped oscillation with a million steps to go raises no error about stiffness."""
    seen = []

    def rates(t, y):
        seen.append(0)
        if len(seen) > 150_000:
            raise KeyboardInterrupt
        return y[1], -1e4 * y[0] - 0.01 * y[1] + (0.0 if y[0] > -9 else 1.0)

    with pytest.raises(KeyboardInterrupt):
        solve(rates, [0, 1e6], [1.0, 0.0], rtol=rtol)


@pytest.mark.parametrize(("decay", "end"), first(1, [(5e4, 30.0), (3e5, 3.0)]))
def test_a_stiff_phase_that_passes_is_stepped_through_and_right_from_the_start(decay, end):
    """The decay is fast only at first; the first trial step is thousands of times too long and must not set a scale."""

    def rates(t, y):
        return (-(decay if t < 0.1 else 1.0) * (y[0] - np.cos(t)) - np.sin(t),)

    t = np.array([0.0, 0.02, 0.05, 0.08, end])
    states = solve(rates, t, [1.0], rtol=1e-9)
    assert np.abs(states[:, 0] - np.cos(t)).max() < 1e-8
