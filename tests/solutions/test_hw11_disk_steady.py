"""hw11's reference solution, by two other routes: mpmath at 50 digits, and the full equations of hw14."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw11_disk_steady")
rolling_disk = assignments.solution("hw14_rolling_disk")

DRAW = np.random.default_rng(11)
DIGITS = 1e-13  # relative; a closed form of a dozen operations in doubles
# Disk, hoop, a general wheel and a long roller: A and C in units of m a^2.
SHAPES = {"disk": (0.25, 0.5), "hoop": (0.5, 1.0), "wheel": (0.61, 0.87), "roller": (4.0, 0.5)}


def disk_of(shape, rng=DRAW):
    mass, radius = (float(x) for x in 10 ** rng.uniform(-6, 6, 2))
    size = mass * radius**2
    inertia = tuple(k * size for k in SHAPES[shape])
    return {"mass": mass, "radius": radius, "inertia": inertia, "gravity": float(10 ** rng.uniform(-3, 3))}


def usual(disk):
    """Size of precessions, rad/s."""
    return math.sqrt(disk["gravity"] / disk["radius"])


def body(disk, *names):
    return {name: disk[name] for name in names}


def precise_residual(lean, precession, spin, inward, normal, radius, inertia):
    """Moment minus Omega z x H at 50 digits, in vectors; and the size of its terms."""
    lean, Omega, spin, inward, normal, a = map(mpmath.mpf, (lean, precession, spin, inward, normal, radius))
    A, C = map(mpmath.mpf, inertia)
    c, s = mpmath.cos(lean), mpmath.sin(lean)
    axle, up = (c, 0, -s), (s, 0, c)  # axes: towards the centre, y, up
    H = [C * spin * n + A * Omega * c * u for n, u in zip(axle, up, strict=True)]
    moment = (-a * up[2]) * inward - (-a * up[0]) * normal  # y component of (-a up) x force
    rate = Omega * H[0]  # y component of Omega z x H
    return moment - rate, abs(a * normal) + abs(a * inward) + abs(A * Omega**2) + abs(C * Omega * spin)


def members(shape, count):
    for _ in range(count):
        disk = disk_of(shape)
        lean = float(DRAW.choice([-1, 1]) * DRAW.uniform(1e-3, 1.57))
        yield disk, lean, float(DRAW.choice([-1, 1]) * usual(disk) * 10 ** DRAW.uniform(-2, 2))


@pytest.mark.parametrize("shape", SHAPES)
def test_members_of_both_families_balance_the_moments_at_50_digits(shape):
    with mpmath.workdps(50):
        for disk, lean, precession in members(shape, 50):
            spins = (f(lean, precession, **disk) for f in (hw.rolling_spin, hw.sliding_spin))
            rolls = hw.contact_force(lean, precession, spin := next(spins), **body(disk, "mass", "radius", "gravity"))
            slides = (0.0, disk["mass"] * disk["gravity"])
            for member, force in ((spin, rolls), (next(spins), slides)):
                left, size = precise_residual(lean, precession, member, *force, *[disk["radius"], disk["inertia"]])
                assert abs(left) <= DIGITS * size


@pytest.mark.parametrize("shape", SHAPES)
def test_residual_and_tracks_agree_with_50_digits(shape):
    with mpmath.workdps(50):
        for disk, lean, precession in members(shape, 50):
            motion = (lean, precession, *(float(x) for x in DRAW.normal(size=3)))
            right, size = precise_residual(*motion, disk["radius"], disk["inertia"])
            found = hw.moment_residual(*motion, **body(disk, "mass", "radius", "inertia"))
            assert abs(found - right) <= DIGITS * size
            spin, R = (hw.rolling_spin(lean, precession, **disk), hw.rolling_track_radius(lean, precession, **disk))
            G = mpmath.mpf(R) - disk["radius"] * mpmath.sin(mpmath.mpf(lean))
            largest = abs(R) + disk["radius"]
            assert abs(G * precession - disk["radius"] * mpmath.mpf(spin)) <= DIGITS * largest * abs(precession)


@pytest.mark.parametrize("shape", SHAPES)
def test_precession_on_a_track_gives_back_the_track(shape):
    for disk, lean, precession in members(shape, 50):
        R = hw.rolling_track_radius(lean, precession, **disk)
        # Omega enters the track by its inverse square next to a term of size a: that loses digits
        lost = 1 + disk["radius"] * (1 + SHAPES[shape][0]) * precession**2 / disk["gravity"] / abs(math.tan(lean))
        assert hw.rolling_precession(lean, R, **disk) == pytest.approx(abs(precession), rel=10 * DIGITS * lost)


def test_the_thin_uniform_disk():
    disk = disk_of("disk")
    for lean, ratio in zip(DRAW.uniform(0.01, 1.5, 50), DRAW.uniform(1.2, 20, 50), strict=True):
        R = ratio * disk["radius"]
        square = 4 * disk["gravity"] * math.tan(lean) / (6 * R - 5 * disk["radius"] * math.sin(lean))
        # tan(lean) next to pi/2 and 6 R - 5 a sin(lean) keep all but a digit
        assert hw.rolling_precession(lean, R, **disk) == pytest.approx(math.sqrt(square), rel=DIGITS)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_common_family_is_the_intersection(shape):
    for disk, lean, _ in members(shape, 20):
        omega = hw.common_precession(lean, **disk)
        zero = {"rel": 0.0, "abs": 1e-12 * omega * (1 + disk["mass"] * disk["radius"] ** 2 / disk["inertia"][1])}
        scale = disk["inertia"][0] / disk["inertia"][1]
        assert hw.rolling_spin(lean, omega, **disk) / scale == pytest.approx(0.0, **zero)
        assert hw.sliding_spin(lean, omega, **disk) / scale == pytest.approx(0.0, **zero)
        R = hw.sliding_track_radius(lean, radius=disk["radius"])
        assert hw.rolling_track_radius(lean, omega, **disk) == pytest.approx(R, rel=1e-11)


def test_elsewhere_the_families_differ():
    for disk, lean, precession in members("wheel", 20):
        if abs(precession / hw.common_precession(lean, **disk) - 1) > 0.01:
            assert hw.rolling_spin(lean, precession, **disk) != hw.sliding_spin(lean, precession, **disk)


def test_the_common_precession_upright_is_the_limit():
    disk = disk_of("wheel")
    near = [hw.common_precession(lean, **disk) for lean in (-1e-9, 0.0, 1e-9)]
    assert np.ptp(near) <= DIGITS * near[0]  # it depends on the square of the lean


@pytest.mark.parametrize("shape", SHAPES)
def test_settling_energy_is_that_of_the_full_model(shape):
    for disk, lean, _ in members(shape, 20):
        omega = hw.common_precession(lean, **disk)
        state = steady_state(lean, omega, 0.0)
        expected = rolling_disk.energy(state, **disk)
        assert hw.settling_energy(lean, **disk) == pytest.approx(expected, rel=1e-12)


# What does not exist


@pytest.mark.parametrize("shape", ["disk", "hoop", "wheel"])
def test_impossible_circles_are_refused(shape):
    disk = disk_of(shape)
    a, (k, n) = disk["radius"], SHAPES[shape]
    tightest = a * math.sin(0.5) * (1 - k / (1 + n))
    for lean, R in [(-0.5, a), (0.5, -a), (0.5, 0.99 * tightest), (0.5, 0.0), (1e-8, -a), (0.0, 0.0)]:
        with pytest.raises(ValueError, match="no steady rolling|at any rate"):
            hw.rolling_precession(lean, R, **disk)
    assert hw.rolling_precession(0.5, 1.01 * tightest, **disk) > 0.0


def test_without_gravity_it_stands_still_unless_every_rate_will_do():
    disk = {**disk_of("wheel"), "gravity": 0.0}
    assert hw.rolling_precession(0.5, 3.0, **disk) == hw.rolling_precession(-0.5, 3.0, **disk) == 0.0
    with pytest.raises(ValueError):
        hw.rolling_precession(0.0, 0.0, **disk)


@pytest.mark.parametrize("track", [1.0, -1.0])
def test_upright_on_a_track_it_does_not_turn(track):
    omega = hw.rolling_precession(0.0, track, **disk_of("hoop"))
    assert omega == 0.0 and math.copysign(1, omega) == 1


# In the full equations


def steady_state(lean, precession, spin):
    """hw14's Euler state of the motion: tilt = pi/2 + lean, and spin = roll' + yaw' cos(tilt)."""
    tilt = lean + math.pi / 2
    return np.array([0.0, 0.0, 0.0, tilt, 0.0, precession, 0.0, spin - precession * math.cos(tilt)])


def slope(lean, precession, spin, *, mass, radius, inertia, gravity):
    """d(tilt'')/d(tilt) along the two integrals of hw14's equations: negative where the motion is stable.

    The rates w2 = Omega sin(tilt) and spin change with the tilt by d(w2) = C/A spin - w2 cot(tilt) and
    d(spin) = m a^2/(C + m a^2) w2.
    """
    A, C = inertia
    m = mass * radius**2
    c, s = math.cos(lean + math.pi / 2), math.sin(lean + math.pi / 2)
    w2 = precession * s
    dw2, dspin = C / A * spin - w2 * c / s, m / (C + m) * w2
    gyroscopic = A * (2 * w2 * dw2 * c / s - (w2 / s) ** 2) - (C + m) * (dw2 * spin + w2 * dspin)
    return (gyroscopic + mass * gravity * radius * s) / (A + m)


SLOW, FAST, UNSTABLE = (-10, -0.01), (-np.inf, -10), (0.05, np.inf)  # slopes: of nutations, and of a growth


def chosen(shape, slopes):
    """A random member whose slope lies between these, of size 1 so that tolerances are plain."""
    while True:
        disk = {"mass": 1.0, "radius": 1.0, "inertia": SHAPES[shape], "gravity": 1.0}
        lean, precession = DRAW.choice([-1, 1]) * DRAW.uniform(0.01, 1.3), DRAW.uniform(0.05, 3)
        spin = hw.rolling_spin(lean, precession, **disk)
        rate = slope(lean, precession, spin, **disk)
        if slopes[0] < rate < slopes[1]:
            return disk, lean, precession, spin, rate


@pytest.mark.parametrize("shape", SHAPES)
def test_circles_that_nutate_fast_stay_steady_within_the_integrators_tolerance(shape):
    """Its steps grow until they are just about stable, and hold a nutation of 9e-8 of the spin (240 draws)."""
    disk, lean, precession, spin, _ = chosen(shape, FAST)
    start = steady_state(lean, precession, spin)
    states = rolling_disk.simulate_euler(np.linspace(0, 20 * math.pi / precession, 41), start, **disk)
    tilt_and_rates = [3, 5, 6, 7]
    assert np.abs(states - start)[:, tilt_and_rates].max() < 1e-6 * abs(spin)


@pytest.mark.parametrize("shape", SHAPES)
def test_stable_circles_stay_steady_for_ten_turns(shape):
    for _ in range(2):
        disk, lean, precession, spin, _ = chosen(shape, SLOW)
        t = np.linspace(0, 10 * 2 * math.pi / precession, 41)
        start = steady_state(lean, precession, spin)
        states = rolling_disk.simulate_euler(t, start, **disk)
        steady = start + np.outer(t, [0, 0, start[5], 0, start[7], 0, 0, 0])
        # The start's rounding, 1e-16, is a kick; moments 1e4 times the stiffness cancel, and ten turns add a digit.
        np.testing.assert_allclose(states[:, 2:], steady[:, 2:], rtol=1e-10, atol=1e-9)
        R = hw.rolling_track_radius(lean, precession, **disk)
        np.testing.assert_allclose(np.ptp(states[:, :2], axis=0), 2 * abs(R), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("shape", ["disk", "hoop", "wheel"])
def test_unstable_circles_leave_at_the_linear_rate(shape):
    disk, lean, precession, spin, rate = chosen(shape, UNSTABLE)
    kick, t = 1e-6, np.array([0.0, 3.0]) / math.sqrt(rate)
    start = steady_state(lean, precession, spin)
    # Kicked along the integrals, the tilt alone would not stay one mode; a tilt rate does: sinh(k t)/k.
    start[6] = kick
    grown = rolling_disk.simulate_euler(t, start, **disk)[-1, 3] - start[3]
    assert grown == pytest.approx(kick * math.sinh(3.0) / math.sqrt(rate), rel=1e-3)


@pytest.mark.parametrize("shape", SHAPES)
def test_steady_members_have_no_tilt_acceleration(shape):
    for disk, lean, precession in members(shape, 20):
        spin = hw.rolling_spin(lean, precession, **disk)
        left = rolling_disk.steady_residual(lean, precession, spin, **disk)
        A, m = disk["inertia"][0], disk["mass"] * disk["radius"] ** 2
        terms = A * precession**2 + disk["mass"] * disk["gravity"] * disk["radius"]
        assert abs(left) <= DIGITS * terms / (A + m)
        force = hw.contact_force(lean, precession, spin, **body(disk, "mass", "radius", "gravity"))
        found = rolling_disk.contact_force(steady_state(lean, precession, spin), **disk)
        inward = (0.0, -force[0], force[1])  # the centre of the circle is towards -y at yaw = 0
        scale = disk["mass"] * (disk["gravity"] + disk["radius"] * precession**2)
        np.testing.assert_allclose(found, inward, rtol=0, atol=1e-12 * (scale + abs(force[0])))
