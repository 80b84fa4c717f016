"""`solve`: samples, ensembles, constraints, rotations, the order of the methods, imports, and invalid input."""

import math
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
from processes import imported_modules
from scipy.linalg import expm, expm_frechet
from scipy.special import sici
from systems import EPS, PENDULUM, clock, oscillator, pendulum

from tam570.integrate import dop853, solve, solve_rotation
from tam570.integrate.dop853 import compiled
from tam570.integrate.formulas import written
from tam570.integrate.rotation import _vector_rate
from tam570.integrate.trace import traced
from tam570.invariants import drift, observed_order, rotation_defect, violation
from tam570.lectures import rocket
from tam570.rotations import skew


def test_the_choice_of_times_changes_nothing():
    fine = np.linspace(0, 20, 4001)
    states = solve(pendulum, fine, [2.5, 0.0], parameters=PENDULUM, method="python")
    for stride in (1000, 800, 2000, 4000):
        coarse = solve(pendulum, fine[::stride], [2.5, 0.0], parameters=PENDULUM, method="python")
        assert (coarse == states[::stride]).all()


@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_samples_off_the_steps_are_as_good_as_the_steps(method):
    t = np.sort(np.random.default_rng(570).uniform(0, 20, 200))
    states = solve(pendulum, t, [2.0, 0.0], parameters=PENDULUM, method=method, rtol=1e-13)
    assert drift(lambda state: state[1] ** 2 / 2 - 9.81 * math.cos(state[0]), states).max() < 1e-13  # of length 1 m


def test_the_first_row_is_the_start_bit_by_bit():
    start = np.array([0.1 + 0.2, -1 / 3])
    for method in ("auto", "gauss", "composition"):
        assert (solve(oscillator, [5.0, 5.1, 7.0], start, method=method)[0] == start).all()


def test_times_may_be_negative_far_off_and_uneven():
    t = -1e6 + np.array([0, 1e-9, 0.5, 0.5 + 2**-30, 6.0])
    states = solve(oscillator, t, [1.0, 0.0], rtol=1e-13)
    assert states[:, 0] == pytest.approx(np.cos(t - t[0]), abs=1e-12)


def test_an_ensemble_is_its_members():
    starts = np.random.default_rng(570).uniform(-1, 1, (40, 2))
    t = np.linspace(0, 5, 7)
    together = solve(pendulum, t, starts, parameters=PENDULUM, method="python")
    assert together.shape == (40, 7, 2)
    alone = [solve(pendulum, t, start, parameters=PENDULUM, method="python") for start in starts]
    assert together == pytest.approx(np.array(alone), abs=1e-11)  # a tenth of rtol: NumPy's sines round differently
    few = solve(lambda t, y: (y[1], -abs(float(y[0]))), t, starts[:3])
    assert few.shape == (3, 7, 2)


def test_importing_loads_numpy_at_most():
    loaded = imported_modules("import tam570.integrate")
    assert "numpy" in loaded
    assert not {"scipy", "llvmlite", "sympy", "matplotlib", "mpmath", "tam570.rotations"} & loaded


def test_projection_keeps_a_constraint_and_leaves_the_motion_right():
    def particle(t, state):
        x, y, u, v = state
        pull = (u * u + v * v - 9.81 * y) / (x * x + y * y)
        return u, v, -pull * x, -9.81 - pull * y

    def on_the_circle(state):
        x, y, u, v = state
        r = math.hypot(x, y)
        along = (x * v - y * u) / r
        return x / r, y / r, -along * y / r, along * x / r

    t = np.linspace(0, 100, 201)
    states = solve(particle, t, [1.0, 0.0, 0.0, 0.0], project=on_the_circle, rtol=1e-12)
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, states).max() < 10 * EPS
    assert violation(lambda s: s[0] * s[2] + s[1] * s[3], states).max() < 1e-14
    angle = solve(pendulum, t, [math.pi / 2, 0.0], parameters=PENDULUM, rtol=1e-12)[:, 0]
    assert states[:, 0] == pytest.approx(np.sin(angle), abs=1e-7)  # 2000 steps of 1e-12 add up in the phase
    free = solve(particle, t, [1.0, 0.0, 0.0, 0.0])
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, free).max() > 1e-9  # without the projection


def test_rotations_stay_rotations_and_angular_momentum_stays():
    def euler(t, omega, *, inertia):
        A, B, C = inertia
        p, q, r = omega
        return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q

    t, inertia = np.linspace(0, 200, 101), (1.0, 2.0, 3.0)
    omegas, R = solve_rotation(euler, t, [0.1, 1.0, 0.2], np.eye(3), parameters={"inertia": inertia}, rtol=1e-12)
    assert rotation_defect(R).max() < 2e-15
    momentum = np.einsum("nij,nj->ni", R, inertia * omegas)
    assert np.abs(momentum - momentum[0]).max() < 1e-9


@pytest.mark.parametrize("angle", [0.1, 1.0])
def test_the_rate_of_a_rotation_vector_turns_the_matrix_by_omega(angle):
    u, omega = angle * np.array([0.48, -0.6, 0.64]), np.array([0.3, 1.0, -0.7])
    change = expm_frechet(skew(u), skew(_vector_rate(u, omega)), compute_expm=False)
    assert change == pytest.approx(expm(skew(u)) @ skew(omega), abs=2e-15)


def test_a_rotation_passes_zero_over_zero():
    def acceleration(t, omega):
        return math.sin(t - 2) / (t - 2), 0.0, 0.0

    omegas, _ = solve_rotation(acceleration, [0.0, 3.0], [0.0, 0.0, 1.0], np.eye(3))
    assert omegas[-1, 0] == pytest.approx(sici(2)[0] + sici(1)[0], rel=1e-9)


ROCKET = {"rhs": rocket.rates, "y0": rocket.START, "parameters": rocket.EXAMPLE}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"t": [0, 1, 1]}, r"^t: must increase, but t\[2\] = 1"),
        ({"t": [2.0, 0.0, 1.0]}, r"^t: must decrease, but t\[2\] = 1 does not come before t\[1\]"),
        ({"t": [0.0]}, "^t: need"),
        ({"t": [0, math.nan]}, "^t: "),
        ({"t": [0, 1j]}, "^t: must be"),
        ({"y0": [1.0, math.inf]}, "^y0: every number must be finite"),
        ({"y0": []}, "^y0: need"),
        ({"y0": [1j, 0]}, "^y0: must be"),
        ({"rtol": 0}, "^rtol: "),
        ({"rtol": [1e-6, 1e-6]}, "^rtol: "),
        ({"method": "euler"}, "^method: one of"),
        ({"parameters": {"w": 1}}, "^rhs: cannot be called"),
        ({"parameters": "w"}, "^parameters: must be a mapping"),
        ({"rhs": lambda t, y: y[0], "t": [1, 0]}, "^rhs: must return 2 numbers"),
        ({"rhs": lambda t, y: [[1.0, 2.0], 3.0]}, "^rhs: must return 2 numbers"),
        ({"rhs": lambda t, y: 1j * np.asarray(y)}, "^rhs: must return real"),
        ({"rhs": lambda t, y: (math.nan, 0.0)}, "^rhs: gives"),
        ({"rhs": lambda t, y: ("1.0", 0.0)}, "^rhs: must return numbers"),
        ({"project": lambda y: None}, "^project: must return a state of 2 numbers, got None"),
        ({"method": "gauss", "step": -1.0}, "^step: must be"),
        ({"method": "gauss", "step": math.inf}, "^step: must be"),
        ({"step": 0.1}, '^step: goes with method "gauss" or "composition" alone'),
        ({"max_step": 1e-20}, "^max_step: 1e-20 is too short"),
        ({"y0": [10**400, 0]}, "^y0: must be"),
        ({"method": "composition", "rhs": lambda t, y: (y[1], -y[0] - y[1])}, "^method: "),
        ({"method": "gauss", "project": lambda y: y}, "^project: "),
        ({"method": "gauss", "dense": True}, "^events, dense, report: "),
        ({"project": lambda y: y, "dense": True}, "^events, dense, report: "),
        ({"y0": [[1.0, 0.0]], "dense": True}, "^events, dense, report: "),
        ({**ROCKET, "t": [0, 18], "method": "gauss"}, r'jump of rhs near t = 10; try "auto"'),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "project": lambda y: y}, "^project: "),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "method": "gauss"}, "^y0: "),
        ({"method": "compiled", "rhs": lambda t, y: (y[1], -y[0]) if y[0] > 0 else (0.0, 1.0)}, "^method: "),
    ],
)
def test_bad_input_is_named_with_its_remedy(change, message):
    with pytest.raises(ValueError, match=message):
        solve(**{"rhs": oscillator, "t": [0, 1], "y0": [1.0, 0.0], **change})


def test_an_error_of_rhs_at_the_start_is_kept_with_time_and_state():
    with pytest.raises(ZeroDivisionError) as error:
        solve(lambda t, y: (y[1], 1.0 / t), [0, 1], [1.0, 0.0])
    assert error.value.__notes__ == ["solve: rhs raises this at the start, t = 0, y = [1.0, 0.0]"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R": np.eye(2)}, "^R: need finite numbers of shape"),
        ({"R": np.full((3, 3), math.nan)}, "^R: need finite numbers of shape"),
        ({"R": 2 * np.eye(3)}, "^R: must be a rotation"),
        ({"R": -np.eye(3)}, "^R: must be a rotation"),
        ({"omega": (1.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"omega": (math.inf, 0.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"t": [0.0]}, "^t: need"),
        ({"rtol": 1.0}, "^rtol: "),
    ],
)
def test_bad_input_of_a_rotation_is_named_too(change, message):
    arguments = {"t": [0, 1], "omega": (0.0, 0.0, 1.0), "R": np.eye(3), **change}
    with pytest.raises(ValueError, match=message):
        solve_rotation(lambda t, w: (0.0, 0.0, 0.0), **arguments)


def test_a_rotation_that_becomes_infinitely_fast_is_told_with_its_time():
    with pytest.raises(ArithmeticError, match=r"t = 0\.(9|99\d*)|t = 1"):
        solve_rotation(lambda t, w: (0.0, 0.0, w[2] * w[2]), [0, 2], (0.0, 0.0, 1.0), np.eye(3))


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


swing = partial(pendulum, length=1.0, gravity=1.0)


@pytest.mark.parametrize(
    ("method", "rhs", "start", "steps", "order"),
    [
        ("gauss", swing, [1.0, 0.5], (0.8, 0.5, 0.4), 12),
        ("gauss", clock, [1.0], (1.0, 0.8, 0.5), 12),  # a stage at the wrong time has a lower order
        ("composition", swing, [1.0, 0.5], (0.2, 0.125, 0.1), 8),
    ],
)
def test_fixed_steps_show_their_order(method, rhs, start, steps, order):
    run = partial(solve, rhs, [0, 4], start)
    exact = run(rtol=1e-15)[-1]
    errors = [np.abs(run(method=method, step=h)[-1] - exact).max() for h in steps]
    assert observed_order(steps, errors) > order - 0.7


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
