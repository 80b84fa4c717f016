"""hw14's reference solution. The routes: momentum balances by complex steps, the three derivations against each other,
Legendre functions by mpmath for both linear integrals, linear theory against simulation, energy, symmetry.
"""

import functools
import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw14_rolling_disk")

# Disk, hoop, a general wheel and a long roller: A and C in units of m a^2.
SHAPES = {"disk": (0.25, 0.5), "hoop": (0.5, 1.0), "wheel": (0.61, 0.87), "roller": (4.0, 0.5)}
TINY = 1e-30  # complex step: its square vanishes beside 1


def disk_of(shape, mass=1.7, radius=0.45, gravity=9.81):
    return {
        "mass": mass,
        "radius": radius,
        "gravity": gravity,
        "inertia": tuple(k * mass * radius**2 for k in SHAPES[shape]),
    }


def states(seed, count, tilts=(0.1, 3.0), rates=5.0):
    """Random Euler states; rates in rad/s."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        place, angles = rng.uniform(-3, 3, 2), rng.uniform(-5, 5, 2)
        yield np.array([*place, angles[0], rng.uniform(*tilts), angles[1], *rng.normal(0, rates, 3)])


def frame(state):
    """e1, e2, e3 of a state that may be complex."""
    yaw, tilt = state[2:4]
    c, s = np.cos(tilt), np.sin(tilt)
    e1 = np.array([np.cos(yaw), np.sin(yaw), 0])
    e3 = np.array([np.sin(yaw) * s, -np.cos(yaw) * s, c])
    return e1, np.array([-np.sin(yaw) * c, np.cos(yaw) * c, s]), e3


def omega(state):
    e1, _, e3 = frame(state)
    return state[5] * np.array([0, 0, 1]) + state[6] * e1 + state[7] * e3


def along_the_motion(function, state, disk):
    """d/dt of a function of the Euler state by a complex step along the equations: exact to rounding."""
    rates = np.array(hw.euler_state_derivative(0.0, state, **disk))
    return np.imag(function(state + 1j * TINY * rates)) / TINY


def centre(state, radius):
    return np.array([state[0], state[1], 0]) + radius * frame(state)[1]


def spin_momentum(state, inertia):
    """Angular momentum about the centre, space axes."""
    w, e3 = omega(state), frame(state)[2]
    return inertia[0] * w + (inertia[1] - inertia[0]) * (w @ e3) * e3


def size_of(state, disk):
    """Size of the moments at work."""
    rates = np.abs(state[5:]).sum()
    inertia = disk["mass"] * disk["radius"] ** 2 + sum(disk["inertia"])
    return inertia * rates**2 + disk["mass"] * disk["gravity"] * disk["radius"]


# The balances


@pytest.mark.parametrize("shape", SHAPES)
def test_the_disk_rolls_without_slip(shape):
    disk = disk_of(shape)
    for state in states(1, 50):
        velocity = along_the_motion(lambda s: centre(s, disk["radius"]), state, disk)
        rolling = np.cross(omega(state), disk["radius"] * frame(state)[1])
        np.testing.assert_allclose(velocity, rolling, rtol=0, atol=1e-14 * disk["radius"] * np.abs(state[5:]).sum())


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("tilts", [(0.1, 3.0), (1e-3, 2e-3), (math.pi - 2e-3, math.pi - 1e-3)])
def test_momentum_and_angular_momentum_balance(shape, tilts):
    disk = disk_of(shape)
    for state in states(2, 50, tilts):
        force = hw.contact_force(state, **disk)
        e2, a = frame(state)[1], disk["radius"]
        velocity_rate = a * along_the_motion(lambda s: np.cross(omega(s), frame(s)[1]), state, disk)
        weight = np.array([0, 0, -disk["mass"] * disk["gravity"]])
        momentum = force + weight - disk["mass"] * velocity_rate
        turning = along_the_motion(lambda s: spin_momentum(s, disk["inertia"]), state, disk)
        moment = np.cross(-a * e2, force) - turning
        # Next to flat yaw'' and roll'' are large and opposite: their sum loses the digits of 1/sin(tilt).
        rounding = 1e-14 * size_of(state, disk) / math.sin(state[3])
        np.testing.assert_allclose(moment, 0, atol=rounding)
        np.testing.assert_allclose(momentum, 0, atol=rounding / a)


def omega_rate(state, disk):
    return along_the_motion(omega, state, disk)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("mass, radius, gravity", [(1.7, 0.45, 9.81), (1e-6, 1e3, 1.6), (1e6, 1e-3, 0.0)])
def test_three_derivations_agree_pointwise(shape, mass, radius, gravity):
    disk = disk_of(shape, mass, radius, gravity)
    for state in states(3, 100, (0.02, 3.12), rates=3 * math.sqrt(9.81 / radius)):
        placed = hw.matrix_state(state, radius=radius)
        matrix = np.array(hw.matrix_state_derivative(0.0, placed, **disk))
        multiplier = hw.multiplier_state_derivative(0.0, placed, **disk)
        scale = np.repeat([np.abs(matrix[part]).max() for part in (np.s_[:3], np.s_[3:12], np.s_[12:])], [3, 9, 3])
        np.testing.assert_allclose(multiplier / scale, matrix / scale, rtol=0, atol=1e-11)
        np.testing.assert_allclose(omega_rate(state, disk) / scale[-1], matrix[12:] / scale[-1], rtol=0, atol=1e-11)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_matrix_state_is_that_of_the_angles(shape):
    def turn(axis, angle):
        c, s = math.cos(angle), math.sin(angle)
        return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]] if axis == "z" else [[1, 0, 0], [0, c, -s], [0, s, c]])

    for state in states(4, 20):
        placed = hw.matrix_state(state, radius=0.45)
        R = turn("z", state[2]) @ turn("x", state[3]) @ turn("z", state[4])
        np.testing.assert_allclose(placed[3:12].reshape(3, 3), R, atol=1e-15)
        np.testing.assert_allclose(placed[12:], omega(state), atol=1e-13)  # rates of 5 rad/s
        np.testing.assert_allclose(placed[:3], centre(state, 0.45), atol=1e-15)


def test_a_positive_spin_moves_the_centre_along_minus_e1():
    state = np.array([0, 0, 0.7, math.pi / 2, 0, 0, 0, 2.0])
    matrix = hw.matrix_state_derivative(0.0, hw.matrix_state(state, radius=0.5), **disk_of("disk", radius=0.5))
    np.testing.assert_allclose(matrix[:3], -1.0 * frame(state)[0], atol=1e-15)


# Motions


@functools.cache
def general_start(shape):
    """A start whose motion stays off the flat for 10 s, by trial."""
    disk = disk_of(shape)
    for state in states(5, 100, (0.8, 2.3), rates=4.0):
        state[7] += 15.0 * np.sign(state[7])
        tilts = hw.simulate_euler(np.linspace(0, 10, 200), state, **disk)[:, 3]
        if np.sin(tilts).min() > 0.2:
            return state, disk
    raise AssertionError("no such start")


@pytest.mark.parametrize("shape", SHAPES)
def test_both_simulations_agree_over_ten_seconds(shape):
    state, disk = general_start(shape)
    t = np.array([2.0, 2.1, 2.5, 4.0, 7.7, 12.0])
    angles = hw.simulate_euler(t, state, **disk)
    by_angles = np.array([hw.matrix_state(row, radius=disk["radius"]) for row in angles])
    by_matrix = hw.simulate_matrix(t, by_angles[0], **disk)
    np.testing.assert_array_equal(angles[0], state)
    np.testing.assert_array_equal(by_matrix[0], by_angles[0])
    np.testing.assert_allclose(by_matrix, by_angles, rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("shape", SHAPES)
def test_energy_rotation_and_ground_are_kept(shape):
    state, disk = general_start(shape)
    t = np.linspace(0, 10, 11)
    energies = [hw.energy(row, **disk) for row in hw.simulate_euler(t, state, **disk)]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-11)
    found = hw.simulate_matrix(t, hw.matrix_state(state, radius=disk["radius"]), **disk)
    R = found[:, 3:12].reshape(-1, 3, 3)
    np.testing.assert_allclose(R.transpose(0, 2, 1) @ R, np.broadcast_to(np.eye(3), R.shape), atol=1e-11)
    np.testing.assert_allclose(found[:, 2], disk["radius"] * np.hypot(R[:, 0, 2], R[:, 1, 2]), rtol=0, atol=1e-11)


def test_energy_is_kinetic_and_potential():
    disk = disk_of("wheel")
    for state in states(7, 20):
        w = omega(state)
        velocity = np.cross(w, disk["radius"] * frame(state)[1])
        kinetic = 0.5 * (disk["mass"] * velocity @ velocity + w @ spin_momentum(state, disk["inertia"]))
        potential = disk["mass"] * disk["gravity"] * centre(state, disk["radius"])[2]
        assert hw.energy(state, **disk) == pytest.approx(kinetic + potential, rel=1e-13)


def legendre(degree, cosine):
    """Legendre function of complex degree and its derivative in the tilt."""
    x = mpmath.mpf(cosine)
    value = mpmath.hyp2f1(-degree, degree + 1, 1, (1 - x) / 2)
    slope = -degree * (degree + 1) / 2 * mpmath.hyp2f1(1 - degree, degree + 2, 2, (1 - x) / 2)
    return value.real, -(slope * -mpmath.sqrt(1 - x * x)).real


@pytest.mark.parametrize("shape", SHAPES)
def test_omega_is_appell_and_korteweg_s_function_of_the_tilt(shape):
    """w3 = p P(cos tilt) + q P(-cos tilt), and m a^2/(C + m a^2) w2 is its derivative in the tilt."""
    state, disk = general_start(shape)
    k, n = SHAPES[shape]
    degree = (-1 + mpmath.sqrt(mpmath.mpc(1 - 4 * n / (k * (1 + n))))) / 2

    def basis(tilt):
        (P, P1), (Q, Q1) = (legendre(degree, sign * math.cos(tilt)) for sign in (1, -1))
        return np.array([[P, Q], [P1 * (1 + n), -Q1 * (1 + n)]], float)

    motion = hw.simulate_euler(np.linspace(0, 10, 21), state, **disk)
    spin = motion[:, 7] + motion[:, 5] * np.cos(motion[:, 3])
    w = np.column_stack([spin, motion[:, 5] * np.sin(motion[:, 3])])
    constants = np.linalg.solve(basis(state[3]), w[0])
    expected = [basis(tilt) @ constants for tilt in motion[:, 3]]
    np.testing.assert_allclose(w, expected, rtol=0, atol=1e-10 * np.abs(w).max())


def test_the_motion_runs_backwards():
    state, disk = general_start("wheel")
    forth = hw.simulate_euler([0.0, 5.0], state, **disk)[-1]
    forth[5:] *= -1
    back = hw.simulate_euler([0.0, 5.0], forth, **disk)[-1]
    back[5:] *= -1
    np.testing.assert_allclose(back, state, rtol=1e-9, atol=1e-9)


# Straight rolling, spinning upright, critical speeds


@pytest.mark.parametrize("shape, fraction", [("disk", 3.0), ("hoop", 4.0)])
def test_the_critical_speed_of_disk_and_hoop(shape, fraction):
    disk = disk_of(shape)
    expected = math.sqrt(disk["gravity"] * disk["radius"] / fraction)
    assert hw.critical_speed(**disk) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_rate_vanishes_at_the_critical_speed(shape):
    disk = disk_of(shape)
    critical = hw.critical_speed(**disk)
    rates = [hw.growth_rate_squared(ratio * critical, **disk) for ratio in (0.0, 0.999, 1.0, 1.001)]
    assert rates[1] > 0 > rates[3]
    assert abs(rates[2]) <= 1e-14 * rates[0]


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("ratio", [0.0, 0.8, 1.25])
def test_a_small_lean_grows_or_swings_as_linear_theory_says(shape, ratio):
    disk, kick = disk_of(shape), 1e-7  # rad/s
    speed = ratio * hw.critical_speed(**disk)
    square = hw.growth_rate_squared(speed, **disk)
    rate = math.sqrt(abs(square))
    t = np.linspace(0, 3, 7) / rate
    state = [0, 0, 0.3, math.pi / 2, 0, 0, kick, speed / disk["radius"]]
    lean = hw.simulate_euler(t, state, **disk)[:, 3] - math.pi / 2
    expected = kick / rate * (np.sinh(rate * t) if square > 0 else np.sin(rate * t))
    # The next order is the cube of the lean; the lean, a difference of angles, has 1e-16 of rounding.
    np.testing.assert_allclose(lean, expected, rtol=0, atol=1e-7 * np.abs(expected).max() + 2e-15)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("ratio, falls", [(0.9, True), (1.1, False)])
def test_a_coin_on_its_edge_sleeps_when_it_spins_fast(shape, ratio, falls):
    """Upright on a point: stable where yaw'^2 (A + m a^2) > m g a, by the linearised equations."""
    disk = disk_of(shape)
    weight = disk["mass"] * disk["gravity"] * disk["radius"]
    inertia = disk["inertia"][0] + disk["mass"] * disk["radius"] ** 2
    yaw_rate = ratio * math.sqrt(weight / inertia)
    square = weight / inertia * (1 - ratio**2)
    t, kick = np.array([0.0, 5 / math.sqrt(abs(square))]), 1e-6  # rad/s
    lean = hw.simulate_euler(t, [0, 0, 0, math.pi / 2, 0, yaw_rate, kick, 0], **disk)[-1, 3] - math.pi / 2
    expected = (np.sinh if falls else np.sin)(5.0) * kick / math.sqrt(abs(square))
    assert lean == pytest.approx(expected, rel=1e-6)


def test_upright_motions_without_a_kick_stay():
    disk = disk_of("disk")
    straight = hw.simulate_euler([0.0, 1.0], [0, 0, 0, math.pi / 2, 0, 0, 0, -6.0], **disk)[-1]
    np.testing.assert_allclose(straight[:3], [6 * disk["radius"], 0, 0], atol=1e-13)
    coin = hw.simulate_euler([0.0, 1.0], [1, 2, 0, math.pi / 2, 0, 30.0, 0, 0], **disk)[-1]
    np.testing.assert_allclose(coin[:4], [1, 2, 30, math.pi / 2], atol=1e-13)


def test_the_disk_is_not_bound_by_its_mass():
    (state, disk), t = general_start("hoop"), [0.0, 2.0]
    heavy = disk_of("hoop", mass=1e6)
    found, same = (hw.simulate_euler(t, state, **which)[-1] for which in (disk, heavy))
    np.testing.assert_allclose(same, found, rtol=1e-10)


def test_the_drawing_is_fixed_in_the_disk():
    state, *_ = states(11, 1)
    lines = hw.wireframe(state, radius=0.45, sides=12)
    assert lines.shape == (14, 2, 3)
    placed = hw.matrix_state(state, radius=0.45)
    body = (lines - placed[:3]) @ placed[3:12].reshape(3, 3)
    np.testing.assert_allclose(np.linalg.norm(body, axis=2), 0.45, rtol=1e-14)
    np.testing.assert_allclose(body[..., 2], 0, atol=1e-15)
    np.testing.assert_array_equal(lines[:12, 1], np.roll(lines[:12, 0], -1, axis=0))
    across = np.diff(body[12:], axis=1)[:, 0]
    np.testing.assert_allclose(across @ across.T, 0.9**2 * np.eye(2), rtol=0, atol=1e-14)


# The long form


@pytest.mark.slow
def test_a_thousand_seconds():
    state, disk = general_start("disk")
    t = np.linspace(0, 1e3, 11)
    energies = [hw.energy(row, **disk) for row in hw.simulate_euler(t, state, **disk)]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-11)
    found = hw.simulate_matrix(t, hw.matrix_state(state, radius=disk["radius"]), **disk)
    R = found[:, 3:12].reshape(-1, 3, 3)
    np.testing.assert_allclose(R.transpose(0, 2, 1) @ R, np.broadcast_to(np.eye(3), R.shape), atol=1e-10)
    np.testing.assert_allclose(found[:, 2], disk["radius"] * np.hypot(R[:, 0, 2], R[:, 1, 2]), rtol=0, atol=1e-10)


def shuddering(shape, tilt, kick):
    """The motion that rolls and slides at once, hw11's, kicked: yaw'^2 = m g a/(A sin(tilt)) and no spin."""
    disk = disk_of(shape)
    yaw_rate = math.sqrt(disk["mass"] * disk["gravity"] * disk["radius"] / (disk["inertia"][0] * math.sin(tilt)))
    state = np.array([0, 0, 0, tilt, 0, yaw_rate, 0, -yaw_rate * math.cos(tilt)])
    state[6] = kick * tilt * yaw_rate
    return state, disk


@pytest.mark.parametrize("kick", [0.0, 0.1])
def test_a_nearly_flat_coin_shudders_for_two_seconds(kick):
    state, disk = shuddering("disk", 1e-3, kick)
    motion = hw.simulate_euler(np.linspace(0, 2, 21), state, **disk)
    energies = [hw.energy(row, **disk) for row in motion]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-11)
    assert np.ptp(motion[:, 3]) <= 1e-9 * 1e-3 if kick == 0.0 else np.ptp(motion[:, 3]) > 1e-5


@pytest.mark.slow
def test_a_nearly_flat_coin_shudders_for_a_thousand_seconds():
    state, disk = shuddering("disk", 1e-3, 0.1)
    motion = hw.simulate_euler(np.linspace(0, 1e3, 5), state, **disk)
    energies = [hw.energy(row, **disk) for row in motion]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-11)
