"""Laws of the lectures on particles: closed forms, limits, edges."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from tam570.integrate import solve
from tam570.lectures import bodies, oscillator, planet, two_masses

DRAW = np.random.default_rng(829)


def test_the_tensor_of_an_orbit_knows_its_plane_and_energy():
    start, parameters = DRAW.normal(size=6), {"mass": 0.7, "stiffness": 3.0}
    xx, yy, zz, yz, zx, xy = oscillator.orbit_tensor(start, **parameters)
    tensor = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
    assert tensor @ oscillator.angular_momentum(start, **parameters) == pytest.approx(np.zeros(3), abs=1e-12)
    assert (xx + yy + zz) / 2 == pytest.approx(oscillator.energy(start, **parameters), rel=1e-14)


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
