"""hw06's reference solution, by other routes: Jourdain's principle at 50 digits, work and energy, closed forms."""

import math
import sys

import mpmath
import numpy as np
import pytest

from tam570_grader.writing import assignments

hw = assignments.solution("hw06_braking")

DRAW = np.random.default_rng(6)
DIGITS = 1e-13  # relative to the largest term; closed forms of a dozen operations in doubles
LOCKED = pytest.mark.parametrize("locked", ["front", "rear"])
BODY = ("mass", "yaw_inertia", "front", "rear")


def car(size=6.0, **fixed):
    """Masses and lengths over `size` decades to both sides, any place of G and any inertia that a car may have."""
    mass, length = (float(x) for x in 10 ** DRAW.uniform(-size, size, 2))
    front, rear = (float(length * x) for x in DRAW.uniform(0.2, 2, 2))
    drawn = {
        "mass": mass,
        "yaw_inertia": float(mass * front * rear * DRAW.uniform(0.2, 3)),
        "front": front,
        "rear": rear,
        "friction": float(DRAW.uniform(0.1, 1)),
        "gravity": float(10 ** DRAW.uniform(-1, 2)),
    }
    return {**drawn, **fixed}


def only(car, *names):
    return {name: car[name] for name in names}


def body(car):
    return only(car, *BODY)


def wheelbase(car):
    return car["front"] + car["rear"]


def usual(car):
    """Size of speeds: friction stops it within about a wheelbase."""
    return math.sqrt(max(car["friction"], 0.1) * max(car["gravity"], 0.1) * wheelbase(car))


def motion(car, speed=None, yaw=None):
    """A state of any place and heading; speed and yaw rate in their usual sizes."""
    speed, yaw = (DRAW.normal() if value is None else value for value in (speed, yaw))
    place = DRAW.normal(size=2) * wheelbase(car)
    return np.array([*place, DRAW.uniform(-9, 9), speed * usual(car), yaw * usual(car) / wheelbase(car)])


def free_and_dragging(locked, car):
    return (-car["rear"], car["front"]) if locked == "front" else (car["front"], -car["rear"])


def velocity(at, state, locked, car):
    """Forward and left, of the point of the centreline so far forward of G: the free axle has none to the left."""
    return np.array([state[3], (at - free_and_dragging(locked, car)[0]) * state[4]])


def scales(state, car):
    """Of place, heading, speed and yaw rate."""
    v = abs(state[3]) + abs(state[4]) * wheelbase(car)
    way = v * v / (car["friction"] * car["gravity"]) if car["friction"] * car["gravity"] else wheelbase(car)
    return np.array([way, way, 1.0, v, v / wheelbase(car)])


# Equations of motion


@LOCKED
def test_the_loads_balance_the_weight_and_its_moment(locked):
    for _ in range(50):
        c = car()
        here, there = (
            hw.axle_load(which, **only(c, "mass", "front", "rear", "gravity")) for which in ("front", "rear")
        )
        weight = c["mass"] * c["gravity"]
        assert here + there == pytest.approx(weight, rel=DIGITS)
        assert abs(here * c["front"] - there * c["rear"]) <= DIGITS * weight * wheelbase(c)


@LOCKED
def test_friction_is_against_the_velocity_of_the_locked_axle_and_has_its_size(locked):
    for _ in range(50):
        c = car()
        state = motion(c)
        load = hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity"))
        force = hw.friction_force(state, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
        sliding = velocity(free_and_dragging(locked, c)[1], state, locked, c)
        assert np.hypot(*force) == pytest.approx(c["friction"] * load, rel=DIGITS)
        assert force @ sliding == pytest.approx(-np.hypot(*force) * np.hypot(*sliding), rel=DIGITS)


def jourdain(rates, state, locked, car):
    """Residuals of the principle of virtual power at 50 digits, for the two motions that the free axle allows.

    G's acceleration is the derivative of its velocity along a motion with these rates; no axes turn, no side force
    occurs. Returns the residuals of a virtual speed and of a virtual yaw rate, and the sizes of their terms.
    """
    m, inertia = mpmath.mpf(car["mass"]), mpmath.mpf(car["yaw_inertia"])
    free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, car))
    heading, u, r = (mpmath.mpf(float(x)) for x in state[2:])
    du, dr = (mpmath.mpf(float(x)) for x in rates[3:])

    def of_G(t):
        return (u + du * t - 1j * free * (r + dr * t)) * mpmath.expj(heading + r * t + dr * t * t / 2)

    acceleration = mpmath.diff(of_G, 0) / mpmath.expj(heading)
    arm = dragging - free
    sliding = u + 1j * arm * r
    load = m * mpmath.mpf(car["gravity"]) * abs(free) / abs(arm)
    force = -mpmath.mpf(car["friction"]) * load * sliding / abs(sliding) if sliding else mpmath.mpc(0)
    along = m * acceleration.real - force.real
    about = -free * m * acceleration.imag + inertia * dr - arm * force.imag
    size = m * (abs(du) + abs(free) * r * r) + abs(force)
    turning = abs(arm * force) + m * abs(free * u * r) + abs(inertia * dr)
    return along, about, size, turning


@LOCKED
@pytest.mark.parametrize("fixed", [{}, {"friction": 0.0}, {"gravity": 0.0}])
def test_the_rates_satisfy_jourdains_principle(locked, fixed):
    with mpmath.workdps(50):
        for _ in range(40):
            c = car(**fixed)
            state = motion(c)
            rates = hw.state_derivative(0.0, state, locked, **c)
            along, about, size, turning = jourdain(rates, state, locked, c)
            assert abs(along) <= DIGITS * size
            assert abs(about) <= DIGITS * turning


@LOCKED
def test_the_free_axle_does_not_slip_sideways_and_goes_at_the_speed(locked):
    for _ in range(50):
        c = car()
        state = motion(c)
        rates = hw.state_derivative(0.0, state, locked, **c)
        along = np.array([math.cos(state[2]), math.sin(state[2])])
        across = np.array([-along[1], along[0]])
        of_free = rates[:2] + free_and_dragging(locked, c)[0] * state[4] * across
        scale = np.abs(rates[:2]).max() + wheelbase(c) * abs(state[4])
        assert abs(of_free @ across) <= DIGITS * scale
        assert abs(of_free @ along - state[3]) <= DIGITS * scale


@LOCKED
def test_kinetic_energy_changes_by_the_power_of_friction(locked):
    """The energy is quadratic in speed and yaw rate, so that a central difference of any step is exact."""
    for _ in range(50):
        c = car()
        state = motion(c)
        rates = hw.state_derivative(0.0, state, locked, **c)
        step = 0.1 * usual(c) / np.abs(rates[3:] * [1, wheelbase(c)]).max()
        after, before = (hw.kinetic_energy(state + h * rates, locked, **body(c)) for h in (step, -step))
        force = hw.friction_force(state, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
        power = force @ velocity(free_and_dragging(locked, c)[1], state, locked, c)
        assert abs((after - before) / (2 * step) - power) <= DIGITS * (after + before) / step


@LOCKED
def test_at_rest_nothing_acts_and_nothing_changes(locked):
    c = car()
    rest = motion(c, 0.0, 0.0)
    force = hw.friction_force(rest, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
    assert not force.any()
    assert not hw.state_derivative(0.0, rest, locked, **c).any()
    np.testing.assert_array_equal(hw.simulate(np.array([3.0, 4.0, 9.0]), rest, locked, **c), [rest] * 3)


@LOCKED
def test_the_smallest_motion_has_the_full_friction(locked):
    c = car()
    tiny = np.array([0.0, 0.0, 0.0, -1e-150, 0.0])
    force = hw.friction_force(tiny, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
    load = hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity"))
    np.testing.assert_allclose(force, [c["friction"] * load, 0.0], rtol=DIGITS)


def test_other_axles_are_refused():
    c = car()
    state, t = motion(c), np.array([0.0, 1.0])
    calls = [
        lambda w: hw.axle_load(w, **only(c, "mass", "front", "rear", "gravity")),
        lambda w: hw.friction_force(state, w, **only(c, "mass", "front", "rear", "friction", "gravity")),
        lambda w: hw.state_derivative(0.0, state, w, **c),
        lambda w: hw.simulate(t, state, w, **c),
        lambda w: hw.kinetic_energy(state, w, **body(c)),
        lambda w: hw.yaw_growth_rate(1.0, w, **c),
        lambda w: hw.critical_speed(w, **only(c, "front", "rear", "friction", "gravity")),
        lambda w: hw.small_yaw_rate(1.0, 2.0, 0.1, w, **c),
    ]
    for call in calls:
        for wrong in ("both", "Front", "", None):
            with pytest.raises(ValueError):
                call(wrong)


# Motion


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


@pytest.mark.full
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


# Stability


def growth(speed, locked, c):
    """d(yaw acceleration)/d(yaw rate) at 0: moments about the free axle, differentiated with 50 digits."""
    free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, c))
    m, arm, u = mpmath.mpf(c["mass"]), dragging - free, mpmath.mpf(speed)
    drag = mpmath.mpf(c["friction"]) * m * mpmath.mpf(c["gravity"]) * abs(free / arm)

    def yaw_acceleration(r):
        moment = -arm * drag * arm * r / mpmath.sqrt(u**2 + (arm * r) ** 2)
        return (moment + m * free * u * r) / (mpmath.mpf(c["yaw_inertia"]) + m * free**2)

    return mpmath.diff(yaw_acceleration, 0)


@LOCKED
def test_growth_rate_is_the_derivative_at_50_digits_and_a_difference_of_the_rates(locked):
    for _ in range(30):
        c = car()
        speed = float(10 ** DRAW.uniform(-1, 1) * usual(c))
        found = hw.yaw_growth_rate(speed, locked, **c)
        apart = [hw.yaw_growth_rate(speed, locked, **{**c, "friction": 0.0})]
        size = abs(apart[0]) + abs(found - apart[0])
        with mpmath.workdps(50):
            assert abs(found - growth(speed, locked, c)) <= DIGITS * size
        tiny = np.array([0, 0, 0, speed, 1e-6 * speed / wheelbase(c)])
        # the yaw acceleration is odd: a difference is off by the square of 1e-6
        difference = hw.state_derivative(0.0, tiny, locked, **c)[4] / tiny[4]
        assert abs(found - difference) <= 1e-11 * size


def test_the_critical_speed_is_where_the_growth_rate_changes_its_sign():
    for _ in range(30):
        c = car()
        road = only(c, "front", "rear", "friction", "gravity")
        critical = hw.critical_speed("rear", **road)
        assert critical**2 == pytest.approx(c["friction"] * c["gravity"] * wheelbase(c), rel=DIGITS)
        below, above = (hw.yaw_growth_rate(critical * (1 + e), "rear", **c) for e in (-1e-12, 1e-12))
        assert below < 0 < above
        assert hw.critical_speed("front", **road) == math.inf
        assert hw.yaw_growth_rate(1e6 * critical, "front", **c) < 0


def test_without_friction_the_rear_has_no_safe_speed():
    road = only(car(), "front", "rear", "gravity")
    assert hw.critical_speed("rear", friction=0.0, **road) == 0.0
    assert hw.critical_speed("front", friction=0.0, **road) == math.inf


@LOCKED
def test_small_yaw_rate_is_the_integral_of_the_growth_over_the_falling_speed(locked):
    """By mpmath's quadrature of growth/u' over ln u at 30 digits."""
    for _ in range(5):
        c = car()
        speed0 = float(DRAW.uniform(0.5, 3) * usual(c))
        speed = float(speed0 * DRAW.uniform(0.05, 1))
        found = hw.small_yaw_rate(speed, speed0, -0.3, locked, **c)
        with mpmath.workdps(30):
            free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, c))
            slowing = mpmath.mpf(c["friction"]) * c["gravity"] * abs(free / (dragging - free))
            ends = [mpmath.log(mpmath.mpf(speed0)), mpmath.log(mpmath.mpf(speed))]

            def per_fold(s, c=c, slowing=slowing):
                return -growth(mpmath.exp(s), locked, c) * mpmath.exp(s) / slowing

            exponent = mpmath.quad(per_fold, ends)
            assert abs(found / (-0.3 * mpmath.exp(exponent)) - 1) <= DIGITS * (1 + abs(exponent))


@LOCKED
def test_small_yaw_rate_is_what_a_simulation_of_a_tiny_one_shows(locked):
    for _ in range(3):
        c = car(2.0)
        start = motion(c, 1.8, 1e-8)
        slowing = c["friction"] * hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity")) / c["mass"]
        t = np.linspace(0, 0.8 * start[3] / slowing, 9)
        yaw_rates = hw.simulate(t, start, locked, **c)[:, 4]
        expected = [hw.small_yaw_rate(start[3] - slowing * s, start[3], start[4], locked, **c) for s in t]
        # the square of the yaw rate, 1e-16, grows to what its largest value makes it
        within = 1e-11 + 10 * (np.abs(expected).max() * wheelbase(c) / usual(c)) ** 2
        # the integrator's errors are relative to the largest yaw rate so far
        np.testing.assert_allclose(yaw_rates, expected, rtol=within, atol=1e-14 * np.abs(expected).max())


@pytest.mark.parametrize(
    ("start", "car"),
    [
        (
            (-0.235199012408966, 3.9971478385340546, -7.281371780528036, 6.540810562747153, 0.0),
            (
                722.7571931032608,
                2406.600482543964,
                1.7475707023826028,
                1.1750117274590313,
                0.7390814865494137,
                14.003486415879372,
            ),
        ),
        (
            (0.012748897698458883, 0.4407580432097111, -4.3234204675900845, -1.9186076228570403, 0.0),
            (
                4.536725131190757,
                6.220548875868298,
                0.9535768532773177,
                0.7803127596966779,
                0.46519542639505007,
                19.183657117389565,
            ),
        ),
    ],
)
def test_the_checks_find_the_stop_of_a_car_that_does_not_turn(start, car):
    """Its yaw acceleration is zero or rounding, which ends no integration: two draws where it once did."""
    assignments.assignment(assignments.find(), "hw06_braking")
    known = dict(zip((*BODY, "friction", "gravity"), car, strict=True))
    time, end = sys.modules["_checks_hw06_braking.right"].stopped(np.array(start), "front", known)
    slowing = known["friction"] * known["gravity"] * known["rear"] / wheelbase(known)
    assert time == pytest.approx(abs(start[3]) / slowing, rel=1e-5)
    way = math.copysign(start[3] ** 2 / (2 * slowing), start[3])
    place = start[0] + way * math.cos(start[2]), start[1] + way * math.sin(start[2])
    assert tuple(end[:3]) == pytest.approx((*place, start[2]), abs=1e-5 * abs(way))
