"""Laws of the lectures on particles, systems, bodies whose mass changes, frames, rigid kinematics, and inertia."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from tam570.integrate import solve
from tam570.lectures import (
    bodies,
    chains,
    frames,
    inertia,
    many,
    oscillator,
    planet,
    quadratic_drag,
    rigid_kinematics,
    rocket,
    two_masses,
)
from tam570.rotations import matrix_from_axis_angle

DRAW = np.random.default_rng(829)
BURN = {"burn_rate": 3.0, "exhaust_speed": 900.0, "empty_mass": 40.0, "gravity": 9.81}
START = [10.0, 20.0, 100.0]  # it burns for 20 s


def test_the_tensor_of_an_orbit_knows_its_plane_and_energy():
    start, parameters = DRAW.normal(size=6), {"mass": 0.7, "stiffness": 3.0}
    xx, yy, zz, yz, zx, xy = oscillator.orbit_tensor(start, **parameters)
    tensor = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
    assert tensor @ oscillator.angular_momentum(start, **parameters) == pytest.approx(np.zeros(3), abs=1e-12)
    assert (xx + yy + zz) / 2 == pytest.approx(oscillator.energy(start, **parameters), rel=1e-14)


def test_drag_is_against_the_velocity_and_grows_as_its_square():
    """The hodograph, which is conserved, is the same for twice the weight and twice the drag."""
    _, _, vx, vy = state = DRAW.normal(size=4).tolist()
    drag = -0.3 * math.hypot(vx, vy) * np.array([vx, vy])
    rates = quadratic_drag.rates(0.0, state, mass=0.7, drag=0.3, gravity=9.81)
    assert rates == pytest.approx((vx, vy, *(drag / 0.7 - [0, 9.81])), rel=1e-12)


def at_pericentre(eccentricity, gm):
    """Return a start at the pericentre, at the distance 1 - e, in a random plane."""
    x, y = np.linalg.qr(DRAW.normal(size=(3, 3)))[0][:2]
    near = 1 - eccentricity
    return np.concatenate([near * x, math.sqrt(gm * (1 + eccentricity) / near) * y])


@pytest.mark.parametrize("eccentricity", [0.0, 1e-8, 0.2, 0.9, 0.99, 0.999])
def test_elements_and_exact_orbits_of_any_eccentricity(eccentricity):
    gm = 2.0
    start = at_pericentre(eccentricity, gm)
    orbit = planet.elements(start, gm=gm)
    T = 2 * math.pi / math.sqrt(gm)
    lost = 4e-16 / (1 - eccentricity) * 10  # the energy is a difference of terms 1/(1 - e) times as large
    assert orbit["eccentricity"] == pytest.approx(eccentricity, abs=lost)
    assert orbit["semi_major_axis"] == pytest.approx(1.0, rel=lost) and orbit["period"] == pytest.approx(T, rel=lost)
    far = planet.exact([0.0, T / 2, 0.77 * T], start, gm=gm)
    assert np.linalg.norm(far[1, :3]) == pytest.approx(1 + eccentricity, rel=1e-9)
    solved = solve(planet.rates, [0.0, 0.77 * T - T / 2], far[1], parameters={"gm": gm}, rtol=1e-13)
    assert far[2] == pytest.approx(solved[1], abs=1e-10)
    for invariant in planet.INVARIANTS.values():
        values = np.array([invariant(state, gm=gm) for state in far])
        assert np.abs(values - values[0]).max() < 1e2 * lost


def test_times_before_the_start_and_many_turns_later():
    start = at_pericentre(0.6, 1.0)
    late, early = planet.exact([0.0, 2 * math.pi * 1000, -2 * math.pi], start, gm=1.0)[1:]
    assert late == pytest.approx(start, abs=1e-10) and early == pytest.approx(start, abs=1e-12)


def test_an_unbound_orbit_has_no_period():
    orbit = planet.elements([1.0, 0.0, 0.0, 0.0, 2.0, 0.0], gm=1.0)
    assert orbit["period"] == math.inf and orbit["semi_major_axis"] == pytest.approx(-0.5)
    assert orbit["eccentricity"] == pytest.approx(3.0)


@pytest.mark.parametrize("n", [1, 2, 9, 10, 30])
def test_arrays_and_loops_pull_alike(n):
    masses, state = tuple(DRAW.uniform(0.5, 2.0, n)), DRAW.normal(size=6 * n)
    result = bodies.rates(0.0, state.tolist(), masses=masses, newton=0.9)
    pairs = bodies._by_pairs(state[: 3 * n].tolist(), masses, 0.9)
    assert result[: 3 * n] == pytest.approx(state[3 * n :]) and result[3 * n :] == pytest.approx(pairs, rel=1e-12)
    assert all(type(rate) is float for rate in result)


@pytest.mark.parametrize("n", [2, 12])
def test_bodies_at_one_place_have_no_accelerations(n):
    state = DRAW.normal(size=6 * n)
    state[:3] = state[3:6]
    result = bodies.rates(0.0, tuple(state.tolist()), masses=(1.0,) * n, newton=1.0)
    assert result[: 3 * n] == pytest.approx(state[3 * n :]) and np.isnan(result[3 * n :]).all()


def test_the_springs_energy_is_the_work_of_its_tension():
    parameters = {"stiffness": 7.0, "rest_length": 0.4}
    for length in (1.3, 0.4, 0.1):
        work, _ = quad(lambda x: two_masses.tension(x, **parameters), 0.4, length)
        assert two_masses.spring_energy(length, **parameters) == pytest.approx(work, abs=1e-12)
    assert two_masses.spring_energy(0.1, **parameters) > 0


@pytest.mark.parametrize("begin", [0.0, 7.0])
def test_an_empty_tank_stops_the_burning(begin):
    times = begin + np.array([0.0, 5.0, 19.999, 20.0, 20.001, 30.0])
    exact, solved = rocket.exact(times, START, **BURN), solve(rocket.rates, times, START, parameters=BURN)
    assert exact[3:, 2].tolist() == [40.0, 40.0, 40.0]
    assert exact == pytest.approx(solved, rel=1e-8)
    assert exact[5, 1] == pytest.approx(exact[3, 1] - 9.81 * 10)
    after = rocket.exact([0.0, 10.0], exact[3], **BURN)[-1]
    assert after == pytest.approx(exact[5], rel=1e-13)  # a tank that is empty from the beginning
    assert rocket.rates(0.0, exact[3].tolist(), **BURN)[1:] == (-9.81, 0.0)


def test_an_empty_tank_has_no_rounding():
    for full, empty in zip(DRAW.uniform(2, 3, 50), DRAW.uniform(0.1, 2, 50), strict=True):
        remaining = rocket.exact([0.0, 100.0], [0.0, 0.0, full], **{**BURN, "empty_mass": empty})[-1, 2]
        assert remaining == empty


def test_the_wrong_rocket_conserves_its_own_momentum_and_differs():
    free = {**BURN, "gravity": 0.0}
    _, v, m = solve(rocket.wrong_rates, np.linspace(0.0, 15.0, 30), START, parameters=free).T
    assert m * v == pytest.approx(np.full(30, 100.0 * 20.0), rel=1e-9)
    assert abs(rocket.wrong_rates(0, START, **BURN)[1] - rocket.rates(0, START, **BURN)[1]) > 20
    assert rocket.wrong_rates(0, [0, 0, 100], **free)[1] == 0.0  # from rest it never starts


def folded_energy(x, v, length, gravity):
    """Return the energy, J, of both parts for 1 kg/m, from their lengths and the heights of their middles."""
    falling, hanging = (length - x) / 2, (length + x) / 2
    return falling * v**2 / 2 - gravity * (falling * (x + falling / 2) + hanging**2 / 2)


def test_the_folded_chain_keeps_energy_or_falls_freely():
    for _ in range(5):
        length, x, v, g = DRAW.uniform(1, 3), DRAW.uniform(0, 0.9), DRAW.uniform(0, 5), 9.81
        by_energy, inelastic = chains.folded(x, v, length=length, gravity=g)
        step = 1e-6
        rise = (folded_energy(x + step * v, v + step * by_energy, length, g) - folded_energy(x, v, length, g)) / step
        assert rise == pytest.approx(0.0, abs=1e-3) and inelastic == g
        assert by_energy == pytest.approx(g + v**2 / (2 * (length - x)))


@pytest.mark.parametrize("supplied", [0.0, 0.3, 0.5])
def test_what_the_heap_supplies_is_not_lost(supplied):
    """The lifting power minus the rates of kinetic and potential energy is (1/2 - supplied) density v^3."""
    v, density, g = 3.0, 0.5, 9.81
    power = v * chains.lifted(1.2, v, density=density, gravity=g, supplied=supplied)
    assert power - density * v**3 / 2 - density * g * 1.2 * v == pytest.approx((0.5 - supplied) * density * v**3)


@pytest.mark.parametrize("supplied", [0.0, 0.3, 0.5])
def test_the_scale_bears_what_momentum_balance_of_the_whole_chain_leaves(supplied):
    """The part above obeys (length - x) v' = (length - x) g + supplied v^2; the reading is the weight minus p'."""
    length, density, g = 2.0, 0.4, 9.81

    def fall(t, state):
        x, v = state
        return v, g + supplied * v * v / (length - x)

    times = np.linspace(0.0, 0.45, 901)
    x, v = solve(fall, times, [0.0, 0.0], rtol=1e-12).T
    momentum = density * (length - x) * v
    rate = (momentum[2:] - momentum[:-2]) / (times[2:] - times[:-2])
    parameters = {"density": density, "gravity": g, "supplied": supplied, "length": length}
    readings = [chains.poured(fallen, **parameters) for fallen in x[1:-1]]
    assert readings == pytest.approx(density * length * g - rate, abs=1e-4)
    long = chains.poured(0.3, density=density, gravity=g, supplied=supplied)
    assert long == pytest.approx((3 - 2 * supplied) * density * g * 0.3)
    assert chains.poured(0.3, **{**parameters, "length": 1e6}) == pytest.approx(long, rel=1e-5)


def test_the_observer_on_the_table_adds_two_forces():
    for _ in range(5):
        turntable = {"mass": DRAW.uniform(0.5, 3), "stiffness": DRAW.uniform(0, 5), "spin": DRAW.uniform(-3, 3)}
        state = DRAW.normal(size=4)
        added = frames.coriolis(state, **turntable) + frames.centrifugal(state, **turntable)
        felt = turntable["mass"] * np.array(frames.rates(0.0, state, **turntable)[2:])
        assert felt == pytest.approx(added - turntable["stiffness"] * state[:2], abs=1e-12)
        assert frames.coriolis(state, **turntable) @ state[2:] == pytest.approx(0.0, abs=1e-12)


def test_to_space_and_back():
    times, states = DRAW.uniform(-9, 9, 7), DRAW.normal(size=(7, 4))
    there = frames.to_space(times, states, spin=-0.8)
    assert frames.from_space(times, there, spin=-0.8) == pytest.approx(states, abs=1e-13)
    assert frames.to_space(times[3], states[3], spin=-0.8) == pytest.approx(there[3], abs=1e-14)
    assert frames.to_space(0.0, [1.0, 0.0, 0.0, 0.0], spin=2.0) == pytest.approx([1.0, 0.0, 0.0, 2.0])


def test_a_swing_on_the_turning_earth_keeps_to_foucaults_plane():
    """The path solves the linear equations with Coriolis' force; after whole periods it is in Foucault's plane."""
    earth = {"length": 4.0, "gravity": 9.81, "latitude": 0.7, "spin": 0.3}
    rate = earth["spin"] * math.sin(earth["latitude"])

    def swing(t, state):
        x, y, vx, vy = state
        return vx, vy, -9.81 / 4.0 * x + 2 * rate * vy, -9.81 / 4.0 * y - 2 * rate * vx

    times = np.linspace(0.0, 20.0, 50)
    solved = solve(swing, times, [1.0, 0.0, 0.0, 0.0], rtol=1e-12)
    assert frames.foucault_path(times, **earth) == pytest.approx(solved[:, :2], abs=1e-9)
    period = 2 * math.pi / math.hypot(math.sqrt(9.81 / 4.0), rate)
    x, y = frames.foucault_path([3 * period], **earth)[0]
    assert math.atan2(y, x) == pytest.approx(float(frames.foucault(3 * period, **earth)), abs=1e-12)
    pole = {**earth, "latitude": math.pi / 2, "spin": 2 * math.pi / 86164.0}
    assert frames.foucault(86164.0, **pole) == pytest.approx(-2 * math.pi)


def wandering(t, coefficients):
    """Return the value, first and second derivative of a cubic in t."""
    a, b, c, d = coefficients
    return a + b * t + c * t**2 + d * t**3, b + 2 * c * t + 3 * d * t**2, 2 * c + 6 * d * t


def moving_point(t, way, axis, speeds, slide):
    """Return A and a point p in the body, each with two derivatives, and R, omega, alpha of an uneven rotation."""
    angle, rate, quicker = wandering(t, speeds)
    R = matrix_from_axis_angle(axis, angle)
    return wandering(t, way), R, rate * axis, quicker * axis, wandering(t, slide)


def test_velocity_and_acceleration_are_those_of_differences():
    for _ in range(5):
        axis = DRAW.normal(size=3)
        axis /= np.linalg.norm(axis)
        motion = DRAW.normal(size=(4, 3)), axis, DRAW.normal(size=4), DRAW.normal(size=(4, 3))
        t, h = DRAW.uniform(-1, 1), 1e-4

        def position(t, still=None, motion=motion):
            (A, _, _), R, _, _, (p, _, _) = moving_point(t, *motion)
            return A + R @ (p if still is None else still)

        (_, v_a, a_a), R, omega, alpha, (p, v, a) = moving_point(t, *motion)
        around = [position(t + s) for s in (-h, 0, h)]
        fixed = [position(t + s, p) for s in (-h, 0, h)]
        assert rigid_kinematics.velocity(v_a, omega, R @ p) == pytest.approx((fixed[2] - fixed[0]) / (2 * h), abs=1e-5)
        second = (fixed[0] - 2 * fixed[1] + fixed[2]) / h**2
        assert rigid_kinematics.acceleration(a_a, omega, alpha, R @ p) == pytest.approx(second, abs=1e-4)
        summands = rigid_kinematics.five_terms(a_a, omega, alpha, R @ p, R @ v, R @ a)
        assert len(summands) == 5 and all(term.shape == (3,) for term in summands.values())
        assert sum(summands.values()) == pytest.approx((around[0] - 2 * around[1] + around[2]) / h**2, abs=1e-4)


def test_a_turning_vector_keeps_its_length():
    omega, e = DRAW.normal(size=(2, 3))
    rate = rigid_kinematics.turning_vector(omega, e)
    turned = [matrix_from_axis_angle(omega, s * np.linalg.norm(omega)) @ e for s in (-1e-5, 1e-5)]
    assert rate == pytest.approx((turned[1] - turned[0]) / 2e-5, abs=1e-8) and rate @ e == pytest.approx(0.0, abs=1e-14)


def particles(n=4):
    return DRAW.uniform(0.3, 3, n), DRAW.normal(size=(n, 3)), DRAW.normal(size=(n, 3))


def test_koenigs_theorems():
    m, r, v = particles()
    state = np.concatenate([r, v]).ravel()
    assert sum(many.kinetic(state, masses=m)) == pytest.approx(m @ (v**2).sum(axis=1) / 2)
    of_G, about_G = many.kinetic(state, masses=m)
    assert of_G == pytest.approx((m @ v) @ (m @ v) / (2 * m.sum())) and about_G > 0
    about = DRAW.normal(size=3)
    of_G, about_G = many.angular_momentum(state, about, masses=m)
    assert of_G + about_G == pytest.approx(m @ np.cross(r - about, v))
    at_G = many.angular_momentum(state, m @ r / m.sum(), masses=m)
    assert at_G[0] == pytest.approx(np.zeros(3), abs=1e-13) and at_G[1] == pytest.approx(about_G)


def test_the_balances_are_the_rates_of_the_momenta():
    m, r, v = particles(3)
    forces = DRAW.normal(size=(3, 3, 3)) * (1 - np.eye(3))[..., None]
    a, h = forces.sum(axis=1) / m[:, None], 1e-6
    ends = [np.concatenate([r + s * v, v + s * a]).ravel() for s in (-h, h)]
    linear, angular, power = many.balances(np.concatenate([r, v]).ravel(), forces, masses=m)
    momenta = [sum(many.angular_momentum(end, np.zeros(3), masses=m)) for end in ends]
    assert linear == pytest.approx(m @ a) and angular == pytest.approx((momenta[1] - momenta[0]) / (2 * h), abs=1e-6)
    apart, parting = r[:, None] - r, v[:, None] - v
    square = (apart**2).sum(axis=2) + np.eye(3)
    tensions = ((forces * apart).sum(axis=2) * (parting * apart).sum(axis=2) / square).sum() / 2
    kinetic = [sum(many.kinetic(end, masses=m)) for end in ends]
    assert power == pytest.approx((kinetic[1] - kinetic[0]) / (2 * h) - tensions, abs=1e-6)


def cloud():
    return DRAW.normal(size=(6, 3)), DRAW.uniform(0.2, 2, 6)


def test_the_shift_to_a_parallel_axis():
    points, masses = cloud()
    arm = DRAW.normal(size=3)
    r = points - masses @ points / masses.sum() - arm
    there = (masses @ (r**2).sum(axis=1)) * np.eye(3) - (masses * r.T) @ r
    assert inertia.parallel_axis(inertia.inertia(points, masses), masses.sum(), arm) == pytest.approx(there)


def test_principal_axes():
    points, masses = cloud()
    matrix = inertia.inertia(points, masses)
    moments, axes = inertia.principal(matrix)
    assert matrix @ axes == pytest.approx(axes * moments, abs=1e-12)
    assert (np.diff(moments) >= 0).all() and moments[0] > 0 and moments[2] <= moments[0] + moments[1]
    assert axes.T @ axes == pytest.approx(np.eye(3), abs=1e-13) and np.linalg.det(axes) == pytest.approx(1.0)


def test_box_and_disk_are_the_limits_of_many_particles():
    size = np.array([0.6, 1.0, 1.7])
    middles = (np.arange(30) + 0.5) / 30 - 0.5
    grid = np.stack(np.meshgrid(middles, middles, middles), axis=-1).reshape(-1, 3) * size
    many_particles = inertia.inertia(grid, np.full(27000, 2.0 / 27000))
    assert inertia.of_box(2.0, size) == pytest.approx(many_particles, rel=2e-3, abs=1e-12)
    flat = grid[((grid[:, :2] / size[:2]) ** 2).sum(axis=1) <= 0.25] / size * [2, 2, 0]
    many_particles = inertia.inertia(flat, np.full(len(flat), 3.0 / len(flat)))
    assert inertia.of_disk(3.0, 1.0) == pytest.approx(many_particles, rel=2e-2, abs=1e-2)
    assert inertia.principal(inertia.of_disk(3.0, 1.0))[0] == pytest.approx([0.75, 0.75, 1.5])
