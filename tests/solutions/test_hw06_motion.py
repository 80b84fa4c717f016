"""hw06's motion: closed forms, work and energy, another integrator, Chaplygin's sleigh."""

import math

import mpmath
import numpy as np
import pytest
from cars import DRAW, LOCKED, body, car, free_and_dragging, hw, motion, only, scales, usual, velocity, wheelbase


def stopping_time(state, locked, c):
    """Narrowed down to the last digits by whether the car still moves; from public results alone."""
    low, high = 0.0, 1e3 * scales(state, c)[3] / (c["friction"] * c["gravity"])
    while high - low > 1e-15 * high:
        t = np.unique([0.0, *np.linspace(low, high, 50)])
        still = ~hw.simulate(t, state, locked, **c)[:, 3:].any(axis=1)
        index = int(np.argmax(still))
        low, high = float(t[index - 1]), float(t[index])
    return high


@LOCKED
@pytest.mark.parametrize("sign", [1, -1])
def test_a_straight_car_stops_as_in_the_textbook(locked, sign):
    c = car()
    start = motion(c, sign * 1.3, 0.0)
    slowing = c["friction"] * hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity")) / c["mass"]
    stop = abs(start[3]) / slowing
    t = stop * np.array([0.0, 0.3, 0.999999, 1.0 + 1e-12, 1.5, 1000.0])
    left = np.clip(1 - t / stop, 0, 1)
    way = start[3] * stop / 2 * (1 - left**2)
    ahead = np.array([math.cos(start[2]), math.sin(start[2])])
    expected = np.column_stack([start[:2] + np.outer(way, ahead), np.full(6, start[2]), start[3] * left, 0 * t])
    found = hw.simulate(t - 7 * stop, start, locked, **c)
    np.testing.assert_allclose(found / scales(start, c), expected / scales(start, c), rtol=0, atol=1e-12)
    assert not found[4:, 3:].any() and not found[:, 4].any()  # never turns, at rest not even by a rounding


@LOCKED
def test_the_energy_lost_is_the_work_of_friction(locked):
    """Work by Gauss-Legendre in panels that end well before the stop: the states come at uneven times."""
    nodes, weights = np.polynomial.legendre.leggauss(16)
    for _ in range(2):
        c = car()
        start = motion(c, DRAW.choice([-1, 1]) * DRAW.uniform(0.5, 2), DRAW.normal())
        span = 0.8 * stopping_time(start, locked, c)
        edges = np.linspace(0, span, 25)
        times = (edges[:-1, None] + edges[1:, None] + np.diff(edges)[:, None] * nodes) / 2
        t = np.concatenate([[0.0], times.ravel(), [span]])
        states = hw.simulate(t, start, locked, **c)
        power = [
            hw.friction_force(s, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
            @ velocity(free_and_dragging(locked, c)[1], s, locked, c)
            for s in states[1:-1]
        ]
        work = np.sum(np.reshape(power, times.shape) @ weights * np.diff(edges) / 2)
        first, last = (hw.kinetic_energy(s, locked, **body(c)) for s in states[[0, -1]])
        assert abs(last - first - work) <= 1e-11 * first


@LOCKED
def test_next_to_the_stop_it_slows_at_a_constant_rate_and_then_stays(locked):
    """That the time of the stop is right: 1e-3, 1e-5 and 1e-7 before it the speed is in proportion."""
    for _ in range(2):
        c = car(2.0)
        start = motion(c, DRAW.choice([-1, 1]) * DRAW.uniform(0.5, 2), DRAW.normal())
        stop = stopping_time(start, locked, c)
        before = np.array([1e-7, 1e-5, 1e-3])
        t = stop * np.concatenate([[0.0], 1 - before[::-1], [1 + 1e-13, 2.0, 50.0]])
        states = hw.simulate(t, start, locked, **c)
        arm = wheelbase(c)
        inertia = c["yaw_inertia"] + c["mass"] * free_and_dragging(locked, c)[0] ** 2
        energies = [hw.kinetic_energy(s, locked, **body(c)) for s in states[1:4][::-1]]
        slowed = np.sqrt(2 * np.array(energies) / c["mass"]) / (before * stop)
        least, most = sorted([1.0, math.sqrt(c["mass"] * arm**2 / inertia)])
        drag = c["friction"] * hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity")) / c["mass"]
        # d sqrt(2 E/m)/dt = -drag/m times sliding speed over sqrt(2 E/m), which is between these two
        assert (slowed >= drag * least * (1 - 1e-6)).all() and (slowed <= drag * most * (1 + 1e-6)).all()
        assert not states[4:, 3:].any()
        np.testing.assert_array_equal(states[4:, :3], [states[4, :3]] * 3)


@LOCKED
def test_it_stops_where_another_integrator_does(locked):
    """SciPy's DOP853 at 1e-12 up to an event at a sliding speed of 1e-8, from where the way is below 1e-15."""
    from scipy.integrate import solve_ivp

    c = car(1.0)
    start = motion(c, 1.5, 0.4)
    drags = free_and_dragging(locked, c)[1]

    def nearly(_, s):
        return np.hypot(*velocity(drags, s, locked, c)) - 1e-8 * usual(c)

    nearly.terminal = True
    stop = stopping_time(start, locked, c)
    run = solve_ivp(
        lambda t, s: hw.state_derivative(t, s, locked, **c),
        (0, 2 * stop),
        start / 1.0,
        method="DOP853",
        rtol=1e-12,
        atol=1e-13 * usual(c),
        events=nearly,
    )
    found = hw.simulate(np.array([0.0, 2 * stop]), start, locked, **c)[-1]
    assert run.t[-1] == pytest.approx(stop, rel=1e-6)
    np.testing.assert_allclose(
        found[:3] / scales(start, c)[:3], run.y[:3, -1] / scales(start, c)[:3], rtol=0, atol=1e-9
    )


def chaplygin(t, start, locked, c):
    """Heading, speed and yaw rate without friction at 40 digits: ln tan(psi/2) grows in proportion to the time."""
    free = mpmath.mpf(free_and_dragging(locked, c)[0])
    gyration = mpmath.sqrt(free**2 + mpmath.mpf(c["yaw_inertia"]) / c["mass"])
    heading, u, r = (mpmath.mpf(float(x)) for x in start[2:])
    V, psi0 = mpmath.hypot(u, gyration * r), mpmath.atan2(gyration * r, u)
    rows = []
    for time in t:
        psi = 2 * mpmath.atan(mpmath.tan(psi0 / 2) * mpmath.exp(free * V / gyration**2 * mpmath.mpf(float(time))))
        turned = (psi - psi0) * gyration / free
        rows.append([heading + turned, V * mpmath.cos(psi), V * mpmath.sin(psi) / gyration])
    return np.array(rows, dtype=float)


@LOCKED
def test_without_friction_it_is_chaplygins_sleigh(locked):
    for fixed in ({"friction": 0.0}, {"gravity": 0.0}):
        for _ in range(3):
            c = car(**fixed)
            start = motion(c, DRAW.normal(), DRAW.normal())
            v = abs(start[3]) + abs(start[4]) * wheelbase(c)
            t = np.sort(DRAW.uniform(0, 10 * wheelbase(c) / v, 30))
            t[0] = 0.0
            found = hw.simulate(t + 5.0 * t[-1], start, locked, **c)[:, 2:]
            with mpmath.workdps(40):
                expected = chaplygin(t, start, locked, c)
            scale = [1.0, v, v / wheelbase(c)]
            # an unstable start loses a few digits on its way round
            np.testing.assert_allclose(found / scale, expected / scale, rtol=0, atol=1e-11)


@LOCKED
def test_without_friction_it_keeps_its_energy_and_ends_with_G_ahead_of_the_free_axle(locked):
    c = car(friction=0.0)
    runs_wrong = -1.0 if locked == "front" else 1.0
    start = motion(c, runs_wrong, 1e-3)
    t = np.linspace(0, 1000 * wheelbase(c) / abs(start[3]), 101)
    states = hw.simulate(t, start, locked, **c)
    energies = [hw.kinetic_energy(s, locked, **body(c)) for s in states]
    assert np.ptp(energies) <= 1e-12 * energies[0]
    assert states[-1, 3] / start[3] == pytest.approx(-1.0, rel=1e-5)  # the energy of 1e-3 of yaw rate is 1e-6
    assert abs(states[-1, 4]) <= 1e-12 * abs(start[3]) / wheelbase(c)


@LOCKED
def test_a_yaw_rate_of_exactly_zero_stays_even_where_it_is_unstable(locked):
    c = car(friction=0.0)
    t = np.linspace(0, 1000 * wheelbase(c) / usual(c), 5)
    for sign in (1, -1):
        states = hw.simulate(t, motion(c, sign, 0.0), locked, **c)
        assert not states[:, 4].any() and np.ptp(states[:, 3]) == 0


@LOCKED
def test_the_sampling_of_the_times_changes_nothing(locked):
    c = car()
    start = motion(c, 1.5, 0.5)
    stop = abs(start[3]) / (c["friction"] * c["gravity"])  # or later
    t = stop * np.concatenate([[-3.0], np.sort(DRAW.uniform(-3, -1.5, 60))])
    picked = [0, 7, 40, 60]
    dense, sparse = (hw.simulate(times, start, locked, **c) / scales(start, c) for times in (t, t[picked]))
    np.testing.assert_allclose(dense[picked], sparse, rtol=0, atol=1e-12)


@pytest.mark.slow
@LOCKED
def test_every_car_stops_and_loses_all_its_energy_on_the_way(locked):
    """Long wheels, heavy frames, any start: no start leaves the time of the stop in doubt."""
    for _ in range(300):
        c = car()
        c["yaw_inertia"] *= float(10 ** DRAW.uniform(-1.5, 1.5))
        start = motion(c, DRAW.normal() * 3, DRAW.normal() * 10 ** DRAW.uniform(-12, 1))
        stop = 2e3 * scales(start, c)[3] / (c["friction"] * c["gravity"])
        t = np.concatenate([[0.0], stop * np.sort(DRAW.uniform(0, 1, 10))])
        states = hw.simulate(t, start, locked, **c)
        energies = [hw.kinetic_energy(s, locked, **body(c)) for s in states]
        assert (np.diff(energies) <= 0).all()
        assert energies[-1] == 0.0
