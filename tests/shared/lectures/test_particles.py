"""Laws of the lectures on particles: closed forms, limits, edges."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from tam570.integrate import solve
from tam570.lectures import bodies, oscillator, planet, quadratic_drag, two_masses

DRAW = np.random.default_rng(829)
BALL = {"mass": 0.6, "drag": 0.05, "gravity": 9.81}


# quadratic_drag


def test_without_drag_the_path_is_a_parabola():
    t = np.linspace(0, 3, 30)
    states = solve(quadratic_drag.rates, t, [1.0, 2.0, 3.0, 14.0], parameters={**BALL, "drag": 0.0})
    assert states[:, 1] == pytest.approx(2 + 14 * t - 9.81 * t**2 / 2, abs=1e-9)
    assert states[:, 0] == pytest.approx(1 + 3 * t, abs=1e-9)


def test_straight_up_and_down_it_slows_as_a_tangent_and_falls_as_a_hyperbolic_one():
    vt = quadratic_drag.terminal_speed(**BALL)
    up = vt / 9.81 * math.atan(30.0 / vt)  # s, to the top
    t = np.array([0.0, up, up + 1.5])
    states = solve(quadratic_drag.rates, t, [0.0, 0.0, 0.0, 30.0], parameters=BALL, rtol=1e-12)
    assert states[1, 3] == pytest.approx(0.0, abs=1e-9)
    assert states[2, 3] == pytest.approx(-vt * math.tanh(9.81 * 1.5 / vt), rel=1e-9)
    assert (states[:, [0, 2]] == 0).all()
    assert quadratic_drag.hodograph(states[0], **BALL) == math.inf


@pytest.mark.parametrize("vx", [12.0, -12.0])
def test_the_hodograph_is_that_of_its_mirror_image(vx):
    t = np.linspace(0, 3, 30)
    states = solve(quadratic_drag.rates, t, [0.0, 0.0, vx, 20.0], parameters=BALL, rtol=1e-13)
    found = [quadratic_drag.hodograph(state, **BALL) for state in states]
    assert found == pytest.approx(np.full(30, found[0]), rel=1e-9)


def test_it_falls_at_the_terminal_speed_at_last():
    end = solve(quadratic_drag.rates, [0, 60.0], [0.0, 0.0, 20.0, 20.0], parameters=BALL)[-1]
    assert end[3] == pytest.approx(-quadratic_drag.terminal_speed(**BALL), rel=1e-9)


def test_without_drag_or_gravity_some_things_are_refused():
    with pytest.raises(ValueError, match="drag"):
        quadratic_drag.terminal_speed(mass=1.0, drag=0.0, gravity=9.81)
    with pytest.raises(ValueError, match="gravity"):
        quadratic_drag.hodograph([0.0, 0.0, 1.0, 1.0], mass=1.0, drag=0.1, gravity=0.0)
    with pytest.raises(ValueError, match="drag"):
        quadratic_drag.rates(0.0, [0.0, 0.0, 1.0, 1.0], mass=1.0, drag=-0.1, gravity=9.81)


# oscillator


def test_every_orbit_closes_after_one_period_and_is_centred():
    for _ in range(5):
        mass, stiffness = DRAW.uniform(0.2, 5.0, 2)
        start, T = DRAW.normal(size=6), 2 * math.pi * math.sqrt(mass / stiffness)
        there = oscillator.exact([0.0, T / 2, T], start, mass=mass, stiffness=stiffness)
        assert there[1] == pytest.approx(-start, abs=1e-12) and there[2] == pytest.approx(start, abs=1e-12)


def test_the_tensor_of_an_orbit_knows_its_plane_and_energy():
    start, known = DRAW.normal(size=6), {"mass": 0.7, "stiffness": 3.0}
    xx, yy, zz, yz, zx, xy = oscillator.orbit_tensor(start, **known)
    tensor = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
    assert tensor @ oscillator.angular_momentum(start, **known) == pytest.approx(np.zeros(3), abs=1e-12)
    assert (xx + yy + zz) / 2 == pytest.approx(oscillator.energy(start, **known), rel=1e-14)


# planet


def at_pericentre(eccentricity, gm):
    """A start in a random plane, at the distance 1 - e."""
    x, y = np.linalg.qr(DRAW.normal(size=(3, 3)))[0][:2]
    near = 1 - eccentricity
    return np.concatenate([near * x, math.sqrt(gm * (1 + eccentricity) / near) * y])


@pytest.mark.parametrize("eccentricity", [0.0, 1e-8, 0.2, 0.9, 0.99, 0.999])
def test_elements_and_exact_orbits_of_any_eccentricity(eccentricity):
    gm = 2.0
    start = at_pericentre(eccentricity, gm)
    orbit = planet.elements(start, gm=gm)
    T = 2 * math.pi / math.sqrt(gm)
    lost = 4e-16 / (1 - eccentricity) * 10  # the energy is a difference of what is 1/(1 - e) times as large
    assert orbit["eccentricity"] == pytest.approx(eccentricity, abs=lost)
    assert orbit["semi_major_axis"] == pytest.approx(1.0, rel=lost) and orbit["period"] == pytest.approx(T, rel=lost)
    far = planet.exact([0.0, T / 2, 0.77 * T], start, gm=gm)
    assert np.linalg.norm(far[1, :3]) == pytest.approx(1 + eccentricity, rel=1e-9)
    solved = solve(planet.rates, [0.0, 0.77 * T - T / 2], far[1], parameters={"gm": gm}, rtol=1e-13)
    assert far[2] == pytest.approx(solved[1], abs=1e-10)
    for law in planet.INVARIANTS.values():
        values = np.array([law(state, gm=gm) for state in far])
        assert np.abs(values - values[0]).max() < 1e2 * lost


def test_equal_areas_in_equal_times():
    start = at_pericentre(0.8, 1.0)
    t = np.linspace(0, 2 * math.pi, 20001)
    r = planet.exact(t, start, gm=1.0)[:, :3]
    swept = np.linalg.norm(np.cross(r[:-1], r[1:]), axis=1) / 2
    parts = swept.reshape(10, 2000).sum(axis=1)
    assert parts == pytest.approx(np.full(10, parts[0]), rel=1e-5)  # triangles under the arc: 1e-6 near the sun
    assert swept.sum() == pytest.approx(math.pi * math.sqrt(1 - 0.8**2), rel=1e-5)


def test_times_before_the_start_and_many_turns_later():
    start = at_pericentre(0.6, 1.0)
    late, early = planet.exact([0.0, 2 * math.pi * 1000, -2 * math.pi], start, gm=1.0)[1:]
    assert late == pytest.approx(start, abs=1e-10) and early == pytest.approx(start, abs=1e-12)


@pytest.mark.parametrize("velocity", [(0.0, 1.5, 0.0), (0.0, math.sqrt(2.0), 0.0), (0.5, 0.0, 0.0), (0.0, 0.0, 0.0)])
def test_what_is_no_ellipse_is_refused(velocity):
    with pytest.raises(ValueError, match="state"):
        planet.exact([0.0, 1.0], [1.0, 0.0, 0.0, *velocity], gm=1.0)


def test_at_the_sun_nothing_is_known():
    with pytest.raises(ValueError, match="state"):
        planet.elements((0.0, 0.0, 0.0, 1.0, 0.0, 0.0), gm=1.0)
    assert math.isnan(planet.rates(0.0, (0.0, 0.0, 0.0, 1.0, 0.0, 0.0), gm=1.0)[3])


def test_an_unbound_orbit_has_no_period():
    orbit = planet.elements([1.0, 0.0, 0.0, 0.0, 2.0, 0.0], gm=1.0)
    assert orbit["period"] == math.inf and orbit["semi_major_axis"] == pytest.approx(-0.5)
    assert orbit["eccentricity"] == pytest.approx(3.0)


# bodies


def test_two_bodies_are_a_planet_about_each_other():
    masses, newton = (0.7, 1.6), 1.3
    r, v = DRAW.normal(size=(2, 2, 3))
    t = np.linspace(0, 1.0, 5)
    states = solve(bodies.rates, t, [*r.ravel(), *v.ravel()], parameters={"masses": masses, "newton": newton})
    apart = np.hstack([states[:, 3:6] - states[:, :3], states[:, 9:] - states[:, 6:9]])
    relative = solve(planet.rates, t, apart[0], parameters={"gm": newton * sum(masses)})
    assert apart == pytest.approx(relative, abs=1e-8)
    centre = (masses[0] * states[:, :3] + masses[1] * states[:, 3:6]) / sum(masses)
    assert np.diff(centre, 2, axis=0) == pytest.approx(0, abs=1e-9)


def test_the_figure_of_eight_comes_back():
    end = solve(bodies.rates, [0, 6.32591398], bodies.START, parameters=bodies.EXAMPLE, rtol=1e-13)[-1]
    assert end == pytest.approx(bodies.START, abs=1e-7)  # of the digits that its start is known to


@pytest.mark.parametrize("n", [1, 2, 9, 10, 30])
def test_arrays_and_loops_pull_alike(n):
    masses, state = tuple(DRAW.uniform(0.5, 2.0, n)), DRAW.normal(size=6 * n)
    found = bodies.rates(0.0, state.tolist(), masses=masses, newton=0.9)
    pairs = bodies._by_pairs(state[: 3 * n].tolist(), masses, 0.9)
    assert found[: 3 * n] == pytest.approx(state[3 * n :]) and found[3 * n :] == pytest.approx(pairs, rel=1e-12)
    assert all(type(rate) is float for rate in found)


@pytest.mark.parametrize("n", [2, 12])
def test_bodies_at_one_place_have_no_accelerations(n):
    state = DRAW.normal(size=6 * n)
    state[:3] = state[3:6]
    found = bodies.rates(0.0, tuple(state.tolist()), masses=(1.0,) * n, newton=1.0)
    assert found[: 3 * n] == pytest.approx(state[3 * n :]) and np.isnan(found[3 * n :]).all()


def test_a_mass_of_zero_among_others_is_refused():
    with pytest.raises(ValueError, match="masses"):
        bodies.rates(0.0, (0.0,) * 18, masses=(1.0, 0.0, 1.0), newton=1.0)


# two_masses


def test_the_distance_swings_with_the_reduced_mass():
    masses, stiffness, rest = (0.5, 2.0), 6.0, 1.0
    T = 2 * math.pi / math.sqrt(stiffness * (1 / masses[0] + 1 / masses[1]))
    known = {"masses": masses, "stiffness": stiffness, "rest_length": rest}
    states = two_masses.exact([0.0, T / 2, T], [0.2, 1.9, 0.4, -0.3], **known)
    stretch = states[:, 1] - states[:, 0] - rest
    assert stretch[1:] == pytest.approx([-stretch[0], stretch[0]], abs=1e-12)


def test_the_springs_energy_is_the_work_of_its_tension():
    known = {"stiffness": 7.0, "rest_length": 0.4}
    for length in (1.3, 0.4, 0.1):
        work, _ = quad(lambda one: two_masses.tension(one, **known), 0.4, length)
        assert two_masses.spring_energy(length, **known) == pytest.approx(work, abs=1e-12)
    assert two_masses.spring_energy(0.1, **known) > 0
