"""The integrator: order, samples, input, and what it does with a right-hand side."""

import ast
import functools
import math
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

from tam570.integrate import explicit, machine, solve, solve_rotation, tableau
from tam570.integrate.source import compiled, functions
from tam570.integrate.trace import Untraceable, traced
from tam570.invariants import drift, observed_order, rotation_defect, violation

EPS = 2.0**-52


def pendulum(t, state, *, length, gravity):
    theta, omega = state
    return omega, -gravity / length * math.sin(theta)


def pendulum_energy(state):
    return state[1] ** 2 / 2 - 9.81 * math.cos(state[0])  # length 1 m


def oscillator(t, y):
    return y[1], -y[0]


def clock(t, y):
    """y = exp(sin t): a stage at the wrong time shows, where the pendulum would hide it."""
    return (y[0] * math.cos(t),)


PENDULUM = {"length": 1.0, "gravity": 9.81}


# Order


def test_tableau_satisfies_the_order_conditions():
    b = tableau.ROWS[12]
    for power in range(8):
        moment = sum(Fraction(w) * Fraction(tableau.NODES[j]) ** power for j, w in b.items())
        assert abs(moment - Fraction(1, power + 1)) < 20 * EPS  # some weights are as large as 6
    for estimate in (tableau.FIFTH, tableau.THIRD):
        assert abs(sum(estimate.values())) < 20 * EPS  # no error where the derivative is constant


def one_step(h, theta=None):
    formulas, constants = traced(clock, 1)
    functions = compiled(formulas, True)
    y = (1.0,)
    f = functions["rhs"](0.3, y, constants)
    n, _, g, _, fifth, third, stages = functions["step"](0.3, h, y, (0.0,), f, y, constants)
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
    assert observed_order(steps, errors) > 8.5  # 9 of one step
    small = steps / 4
    fifth, third = np.transpose([one_step(h)[1:] for h in small]) ** 0.5
    assert observed_order(small, fifth) > 5.6
    assert observed_order(small, third) > 3.6


def test_inside_a_step_the_error_is_that_of_the_step():
    for h in (0.5, 0.3, 0.2):
        inside = max(abs(one_step(h, x) - exact_clock(x * h)) for x in np.linspace(0.02, 0.98, 25))
        n, fifth, third = one_step(h)
        estimate = fifth / math.sqrt(fifth + 0.01 * third)
        assert inside < 5 * max(estimate, abs(n - exact_clock(h)))  # DOP853's own interpolant: 20 to 60


@pytest.mark.parametrize(("method", "order"), [("gauss", 12), ("composition", 8)])
def test_fixed_steps_show_their_order(method, order):
    steps = np.array([0.8, 0.5, 0.4]) if method == "gauss" else np.array([0.2, 0.125, 0.1])
    exact = solve(pendulum, [0, 4], [1.0, 0.5], parameters={"length": 9.81, "gravity": 9.81}, rtol=1e-15)[-1]
    errors = [
        np.abs(
            solve(pendulum, [0, 4], [1.0, 0.5], parameters={"length": 9.81, "gravity": 9.81}, method=method, step=h)[-1]
            - exact
        ).max()
        for h in steps
    ]
    assert observed_order(steps, errors) > order - 0.7


def test_gauss_knows_the_time_of_its_stages():
    steps = np.array([1.0, 0.8, 0.5])
    errors = [abs(solve(clock, [0, 4], [1.0], method="gauss", step=h)[-1, 0] - math.exp(math.sin(4))) for h in steps]
    assert observed_order(steps, errors) > 10.5


# Samples


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
    assert drift(pendulum_energy, states).max() < 1e-13


def test_energy_holds_to_the_tolerance_at_any_sample():
    t = np.linspace(0, 20, 3001)
    for rtol, allowed in ((1e-6, 1e-4), (1e-10, 1e-8), (1e-13, 1e-11)):  # a hundred steps or more
        states = solve(pendulum, t, [3.0, 0.0], parameters=PENDULUM, rtol=rtol)
        assert drift(pendulum_energy, states).max() < allowed


def test_the_first_row_is_the_start_bit_by_bit():
    start = np.array([0.1 + 0.2, -1 / 3])
    for method in ("auto", "gauss", "composition"):
        assert (solve(oscillator, [5.0, 5.1, 7.0], start, method=method)[0] == start).all()


def test_times_may_be_negative_far_off_and_uneven():
    t = -1e6 + np.array([0, 1e-9, 0.5, 0.5 + 2**-30, 6.0])
    states = solve(oscillator, t, [1.0, 0.0], rtol=1e-13)
    assert states[:, 0] == pytest.approx(np.cos(t - t[0]), abs=1e-12)


def test_the_time_reaches_the_right_hand_side():
    t = np.linspace(-3, 4, 30)
    states = solve(clock, t, [math.exp(math.sin(-3))], rtol=1e-12)
    assert states[:, 0] == pytest.approx(np.exp(np.sin(t)), rel=1e-10)


def test_a_run_there_and_back_ends_where_it_began():
    there = solve(pendulum, [0, 10], [2.0, 0.0], parameters=PENDULUM, rtol=1e-13)[-1]
    back = solve(pendulum, [0, 10], there * [1, -1], parameters=PENDULUM, rtol=1e-13)[-1]
    assert back == pytest.approx([2.0, 0.0], abs=1e-10)


# Steps that deceive nobody


def primitive_of_sin8(t):
    """By its Fourier series."""
    series = ((-7 / 16, 2), (7 / 32, 4), (-1 / 16, 6), (1 / 128, 8))
    return 35 / 128 * t + sum(a * math.sin(k * t) / k for a, k in series)


@pytest.mark.parametrize(
    ("rhs", "start", "exact"),
    [
        (lambda t, y: (t**3,), [0.0], lambda t: t**4 / 4),  # derivative and its first two derivatives zero
        (lambda t, y: (0.0,), [1.5], lambda t: 1.5),
        (lambda t, y: (2.0,), [0.0], lambda t: 2 * t),
        (lambda t, y: (math.sin(t) ** 8,), [0.0], primitive_of_sin8),
    ],
)
def test_zero_derivatives_at_the_start(rhs, start, exact):
    t = np.array([0.0, 3.0, 30.0])
    found = solve(rhs, t, start, rtol=1e-12)[:, 0]
    assert found == pytest.approx([exact(x) for x in t], rel=1e-10, abs=1e-12)


def test_noise_in_a_component_that_should_be_zero_stops_nothing():
    def noisy(t, y):
        u = (y[0] + 3.0) - 3.0 - y[0]  # nothing but rounding
        return y[1], -y[0], u

    calls = []
    solve(lambda t, y: calls.append(0) or noisy(t, y), [0, 20], [1.0, 0.0, 0.0], rtol=1e-12)
    assert len(calls) < 20000  # the oscillator alone takes 3000


def braked_car(t, y, mass, inertia, free, locked, drag):
    """Straight ahead and in the ground's axes: the yaw acceleration is rounding, and exactly zero at most headings."""
    heading, speed, yaw_rate = y[2:]
    c, s = math.cos(heading), math.sin(heading)
    sideways = (locked - free) * yaw_rate
    slip = math.hypot(speed, sideways)
    along, aside = -drag * speed / slip, -drag * sideways / slip
    fx, fy, moment = along * c - aside * s, along * s + aside * c, locked * aside
    lacking = yaw_rate * speed - (c * fy - s * fx) / mass - free * moment / inertia
    multiplier = lacking / (1 / mass + free**2 / inertia)
    ax, ay = (fx - s * multiplier) / mass, (fy + c * multiplier) / mass
    left = -free * yaw_rate
    turning = (moment + free * multiplier) / inertia
    return speed * c - left * s, speed * s + left * c, yaw_rate, ax * c + ay * s + yaw_rate * left, turning


def test_noise_that_is_seldom_there_stops_nothing():
    start = (-4.8552552320993305, -4.674480783934106, -0.04617421486523288, -2.2205596578680047, 0.0)
    car = {
        "mass": 94.56225829295548,
        "inertia": 40.18801082303782,
        "free": 0.4215275712597747,
        "locked": -1.2915052972567986,
        "drag": 96.83754605511551,
    }
    span = (-0.49083545047596405, 0.8101878878199923)
    _, _, heading, speed, yaw_rate = solve(braked_car, span, start, parameters=car, rtol=1e-11)[-1]
    lost = car["drag"] / car["mass"] * (span[1] - span[0])
    assert (heading, yaw_rate) == pytest.approx((start[2], 0.0), abs=1e-15)
    assert abs(speed) == pytest.approx(abs(start[3]) - lost, rel=1e-12)


def test_an_infinite_solution_is_an_error_and_says_where():
    with pytest.raises(ArithmeticError, match=r"t = 1\.0"):
        solve(lambda t, y: (y[0] ** 2,), [0, 2], [1.0])


def test_tolerances_beyond_rounding_finish():
    for rtol in (1e-15, 1e-17, 1e-30):
        state = solve(oscillator, [0, 100], [1.0, 0.0], rtol=rtol)[-1]
        assert state == pytest.approx([math.cos(100), -math.sin(100)], abs=100 * EPS)


# Input


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"t": [0, 1, 1]}, r"^t: must increase, but t\[2\] = 1"),
        ({"t": [0.0]}, "^t: need"),
        ({"t": [0, math.nan]}, "^t: "),
        ({"y0": [1.0, math.inf]}, "^y0: every number must be finite"),
        ({"y0": []}, "^y0: need"),
        ({"y0": [1j, 0]}, "^y0: must be"),
        ({"rtol": 0}, "^rtol: "),
        ({"method": "euler"}, "^method: one of"),
        ({"parameters": {"w": 1}}, "^rhs: cannot be called"),
        ({"rhs": lambda t, y: (y[0],)}, "^rhs: must return 2 numbers"),
        ({"rhs": lambda t, y: 1j * np.asarray(y)}, "^rhs: must return real"),
        ({"rhs": lambda t, y: (math.nan, 0.0)}, "^rhs: gives"),
        ({"method": "gauss", "step": -1.0}, "^step: must be"),
        ({"method": "gauss", "step": math.inf}, "^step: must be"),
        ({"step": 0.1}, '^step: goes with method "gauss" or "composition" alone'),
        ({"step": -5.0, "method": "python"}, '^step: goes with method "gauss" or "composition" alone'),
        ({"step": 0.1, "method": "numba"}, '^step: goes with method "gauss" or "composition" alone'),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "step": 0.1}, '^step: goes with method "gauss" or "composition" alone'),
        ({"method": "composition", "rhs": lambda t, y: (y[1], -y[0] - y[1])}, "^method: "),
        ({"method": "gauss", "project": lambda y: y}, "^project: "),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "project": lambda y: y}, "^project: "),
        ({"y0": [[1.0, 0.0], [0.0, 1.0]], "method": "gauss"}, "^y0: "),
        ({"method": "numba", "rhs": lambda t, y: (y[1], -y[0]) if y[0] > 0 else (0.0, 1.0)}, "^method: "),
    ],
)
def test_bad_input_is_named_with_its_remedy(change, message):
    given = {"rhs": oscillator, "t": [0, 1], "y0": [1.0, 0.0], **change}
    with pytest.raises(ValueError, match=message):
        solve(given.pop("rhs"), given.pop("t"), given.pop("y0"), **given)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R": np.eye(2)}, "^R: need finite numbers of shape"),
        ({"R": np.full((3, 3), math.nan)}, "^R: need finite numbers of shape"),
        ({"omega": (1.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"omega": (math.inf, 0.0, 0.0)}, "^omega: need finite numbers of shape"),
        ({"t": [0.0]}, "^t: need"),
        ({"rtol": 1.0}, "^rtol: "),
    ],
)
def test_bad_input_of_a_rotation_is_named_too(change, message):
    given = {"t": [0, 1], "omega": (0.0, 0.0, 1.0), "R": np.eye(3), "rtol": 1e-10, **change}
    with pytest.raises(ValueError, match=message):
        solve_rotation(lambda t, w: (0.0, 0.0, 0.0), given["t"], given["omega"], given["R"], rtol=given["rtol"])


def test_a_rotation_that_becomes_infinitely_fast_is_told_with_its_time():
    with pytest.raises(ArithmeticError, match=r"t = 0\.(9|99\d*)|t = 1"):
        solve_rotation(lambda t, w: (0.0, 0.0, w[2] * w[2]), [0, 2], (0.0, 0.0, 1.0), np.eye(3))


def test_functions_of_every_habit_give_the_same():
    def of_arrays(t, y):
        return np.array([[0.0, 1.0], [-1.0, 0.0]]) @ y

    def of_halves(t, y):
        q, v = y[:1], y[1:]
        return np.concatenate([v, -q])

    def that_adds_slices(t, y):  # a tuple would be joined, not added
        turned = y[::-1] + y[::-1]
        return turned * np.array([0.5, -0.5])

    def that_branches(t, y):
        return (y[1], -y[0]) if y[0] > -9 else (0.0, 0.0)

    def that_changes_what_it_gets(t, y):
        y[0], y[1] = y[1], -y[0]
        return y

    exact = solve(oscillator, [0, 7.0], [1.0, 0.5])
    for rhs in (of_arrays, of_halves, that_adds_slices, that_branches, that_changes_what_it_gets):
        assert solve(rhs, [0, 7.0], [1.0, 0.5]) == pytest.approx(exact, abs=1e-13), rhs.__name__
    start = np.array([1.0, 0.5])
    solve(that_changes_what_it_gets, [0, 1.0], start)
    assert (start == [1.0, 0.5]).all()


# The right-hand side specialised to its scene


def operations(rhs, size, **parameters):
    """Operations of one evaluation and of one step, counted in the generated source."""
    formulas, _ = traced(functools.partial(rhs, **parameters), size)
    tree = ast.parse(functions(formulas))
    return {
        function.name: sum(isinstance(node, (ast.BinOp, ast.UnaryOp, ast.Call)) for node in ast.walk(function))
        for function in tree.body
    }


def drag_and_wind(t, state, *, mass, drag, gravity, wind):
    x, y, z, u, v, w = state
    speed = math.sqrt((u - wind) ** 2 + v * v + w * w)
    return (u, v, w, -drag / mass * speed * (u - wind), -drag / mass * speed * v, -drag / mass * speed * w - gravity)


def test_what_a_scene_lacks_is_not_computed():
    given = {"mass": 2.0, "drag": 0.1, "gravity": 9.81, "wind": 3.0}
    full = operations(drag_and_wind, 6, **given)
    for absent in ("wind", "gravity", "drag"):
        fewer = operations(drag_and_wind, 6, **{**given, absent: 0.0})
        assert fewer["rhs"] < full["rhs"]
        assert fewer["step"] < full["step"]
    nothing = operations(drag_and_wind, 6, **{**given, "drag": 0.0})
    assert nothing["rhs"] == 0  # constant rates
    assert nothing["step"] < full["step"] / 2


def hanging_spring(t, state, *, mass, stiffness, rest, gravity, anchor):
    x, y, z, u, v, w = state
    dx, dy, dz = x - anchor[0], y - anchor[1], z - anchor[2]
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    pull = stiffness / mass * (length - rest) / length
    return u, v, w, -pull * dx, -pull * dy - gravity[1], -pull * dz - gravity[2]


def test_what_is_zero_in_a_plane_is_not_computed_if_it_is_a_parameter():
    """Not so of a component that starts at zero: the formulas hold for every start, the motion stays in the plane."""
    given = {"mass": 2.0, "stiffness": 40.0, "rest": 1.0}
    general = operations(hanging_spring, 6, **given, gravity=(0.0, 9.81, 0.5), anchor=(0.1, 0.2, 0.3))
    planar = operations(hanging_spring, 6, **given, gravity=(0.0, 9.81, 0.0), anchor=(0.1, 0.2, 0.0))
    assert planar["rhs"] < general["rhs"]
    assert planar["step"] < general["step"]
    parameters = {**given, "gravity": (0.0, 9.81, 0.0), "anchor": (0.1, 0.2, 0.0)}
    states = solve(hanging_spring, [0, 1, 5], [0.8, -1.0, 0.0, 0.3, 0.0, 0.0], parameters=parameters)
    assert (states[:, [2, 5]] == 0).all()


def test_what_occurs_twice_is_computed_once():
    formulas, _ = traced(lambda t, y: (math.sin(y[0]) * y[1], y[1] * math.sin(y[0]) + math.sin(y[0])), 2)
    assert "\n".join((*formulas.lines, *formulas.rates)).count("sin") == 1


def test_states_that_nothing_depends_on_have_no_stages():
    free = functions(traced(lambda t, y: (y[1], -y[1]), 2)[0])
    assert "s0 = y0 + h" not in free


@pytest.mark.parametrize("question", [lambda x: x > 0, lambda x: x == 0, bool, float, int, lambda x: max(x, 0.0)])
def test_a_function_that_asks_for_values_is_not_written_down(question):
    with pytest.raises((Untraceable, TypeError)):
        traced(lambda t, y: (1.0 if question(y[0]) else 2.0,), 1)


def test_a_function_that_treats_symbols_otherwise_is_found_out():
    def two_faced(t, y):
        return (y[1], -y[0]) if isinstance(y[0], float) else (y[1], y[0])

    assert not explicit.engine(two_faced, None, np.array([0.0, 1.0]), np.array([1.0, 0.0])).traced
    assert solve(two_faced, [0, math.pi], [1.0, 0.0])[-1] == pytest.approx([-1, 0], abs=1e-9)


def test_helpers_and_numpy_functions_are_traced_too():
    def helper(x):
        return np.sin(x) + math.cos(x) ** 2

    def rates(t, y, *, matrix):
        return matrix @ np.array([helper(y[0]), np.sqrt(y[1] ** 2 + 1)]) - np.cross([y[0], 0, 1], [0, 1, y[1]])[:2]

    bound = functools.partial(rates, matrix=np.array([[1.0, 0.0], [-2.0, 0.5]]))
    assert explicit.engine(bound, None, np.array([0.0, 1.0]), np.array([1.0, 0.0])).traced


def test_a_value_changed_between_two_runs_is_seen():
    gravity = 1.0

    def falling(t, y):
        return y[1], -gravity

    first = solve(falling, [0, 1], [0.0, 0.0])[-1, 0]
    gravity = 2.0
    assert solve(falling, [0, 1], [0.0, 0.0])[-1, 0] == pytest.approx(2 * first)


# Constraints, rotations, ensembles, compiled code


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
    assert states[:, 0] == pytest.approx(np.sin(angle), abs=1e-7)  # 2000 steps of 1e-12; the phase adds them up
    free = solve(particle, t, [1.0, 0.0, 0.0, 0.0])
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, free).max() > 1e-9  # what would happen without


def euler(t, omega, *, inertia):
    A, B, C = inertia
    p, q, r = omega
    return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q


def test_rotations_stay_rotations_and_angular_momentum_stays():
    inertia = np.array([1.0, 2.0, 3.0])
    t = np.linspace(0, 200, 101)
    omegas, R = solve_rotation(euler, t, [0.1, 1.0, 0.2], np.eye(3), parameters={"inertia": tuple(inertia)}, rtol=1e-12)
    assert rotation_defect(R).max() < 1e-14
    momentum = np.einsum("nij,nj->ni", R, inertia * omegas)
    assert np.abs(momentum - momentum[0]).max() < 1e-9


def test_constant_spin_is_exact():
    spin = np.array([0.3, -0.4, 1.2])
    _, R = solve_rotation(lambda t, w: (0.0, 0.0, 0.0), [0, 1.0, 50.0], spin, np.eye(3), rtol=1e-12)
    angle = np.linalg.norm(spin) * 50
    n = spin / np.linalg.norm(spin)
    hat = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    assert R[-1] == pytest.approx(np.eye(3) + math.sin(angle) * hat + (1 - math.cos(angle)) * hat @ hat, abs=1e-11)


def test_an_ensemble_is_its_members():
    starts = np.random.default_rng(570).uniform(-1, 1, (40, 2))
    t = np.linspace(0, 5, 7)
    together = solve(pendulum, t, starts, parameters=PENDULUM, method="python")
    assert together.shape == (40, 7, 2)
    alone = [solve(pendulum, t, start, parameters=PENDULUM, method="python") for start in starts]
    assert together == pytest.approx(np.array(alone), abs=1e-12)
    few = solve(lambda t, y: (y[1], -abs(float(y[0]))), t, starts[:3])
    assert few.shape == (3, 7, 2)


def test_compiled_and_interpreted_agree():
    pytest.importorskip("numba")
    t = np.linspace(0, 30, 50)
    for rtol in (1e-6, 1e-12):
        compiled_, plain = (
            solve(pendulum, t, [2.0, 0.0], parameters=PENDULUM, rtol=rtol, method=m) for m in ("numba", "python")
        )
        assert compiled_ == pytest.approx(plain, abs=1e-11)  # the same steps, sines rounded otherwise


def test_where_nothing_may_be_written_it_goes_on_in_python(tmp_path, monkeypatch):
    pytest.importorskip("numba")
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert machine.wait("no such source") == np.inf

    def rates(t, state):  # of this test alone: no process has it compiled
        return state[1], -math.sin(state[0]) - 0.0123 * state[1]

    t, starts = np.linspace(0, 1000, 4), np.array([[2.0, 0.0], [1.0, 0.0]])
    rows = solve(rates, t, starts, rtol=1e-12)
    assert rows == pytest.approx(solve(rates, t, starts, rtol=1e-12, method="python"), abs=1e-12)
    with pytest.raises(OSError, match="file"):
        solve(rates, t, starts[0], method="numba")


def test_importing_loads_numpy_at_most():
    code = "import sys, tam570.integrate; print(*sorted({m.split('.')[0] for m in sys.modules}))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "numpy" in loaded
    assert not {"scipy", "numba", "sympy", "matplotlib", "mpmath"} & set(loaded)
