"""Laws of the lectures on particles and on bodies whose mass changes: closed forms, limits, edges."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from tam570.integrate import solve
from tam570.lectures import bodies, chains, oscillator, planet, rocket, two_masses

DRAW = np.random.default_rng(829)
BURN = {"burn_rate": 3.0, "exhaust_speed": 900.0, "empty_mass": 40.0, "gravity": 9.81}
START = [10.0, 20.0, 100.0]  # it burns for 20 s


def test_the_tensor_of_an_orbit_knows_its_plane_and_energy():
    start, parameters = DRAW.normal(size=6), {"mass": 0.7, "stiffness": 3.0}
    xx, yy, zz, yz, zx, xy = oscillator.orbit_tensor(start, **parameters)
    tensor = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
    assert tensor @ oscillator.angular_momentum(start, **parameters) == pytest.approx(np.zeros(3), abs=1e-12)
    assert (xx + yy + zz) / 2 == pytest.approx(oscillator.energy(start, **parameters), rel=1e-14)


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
