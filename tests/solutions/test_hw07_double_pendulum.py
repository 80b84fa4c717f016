"""Accuracy of hw07's solution, by SymPy's Lagrange equations of bars made of particles, Newton's law along simulated
motions, 50 digits (mpmath), elliptic functions in the massless limit, reversal, mirror and conservation.
"""

import functools
import math

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from scipy.special import ellipj, ellipk

from tam570_grader.checks import assignments

pendulum = assignments.solution("hw07_double_pendulum")

BARS = {"masses": np.array([1.3, 0.7]), "lengths": np.array([0.9, 1.6])}  # kg, m
SWINGING = {**BARS, "gravity": 9.81}  # m/s^2
THETA, OMEGA = np.array([1.1, -2.3]), np.array([-1.7, 2.9])  # rad, rad/s
HORIZONTAL, STILL = np.full(2, math.pi / 2), np.zeros(2)
ROUNDING = 1e-13  # relative; a dozen roundings make 1e-15


@functools.cache
def lagrange():
    """[M], {f}, {g}, energy and angular momentum as functions: integrals over the particles of the bars."""
    th, om, m, l = (sp.symbols(f"{name}1:3", real=True) for name in ("th", "om", "m", "l"))  # noqa: E741
    g, s = sp.symbols("g s", positive=True)
    unit = [sp.Matrix([sp.sin(a), -sp.cos(a)]) for a in th]
    places = s * l[0] * unit[0], l[0] * unit[0] + s * l[1] * unit[1]
    velocities = [r.jacobian(th) * sp.Matrix(om) for r in places]

    def summed(quantity):
        return sum(sp.integrate(sp.expand(m[i] * quantity(places[i], velocities[i])), (s, 0, 1)) for i in (0, 1))

    kinetic = summed(lambda r, v: v.dot(v) / 2)
    potential = summed(lambda r, v: g * r[1])
    momentum = summed(lambda r, v: r[0] * v[1] - r[1] * v[0])
    p = sp.Matrix([kinetic]).jacobian(om)
    M = p.jacobian(om)
    f = p.jacobian(th) * sp.Matrix(om) - sp.Matrix([kinetic]).jacobian(th).T
    G = sp.Matrix([potential]).jacobian(th).T
    return sp.lambdify((*th, *om, *m, *l, g), (M, f, G, kinetic + potential, momentum), "numpy")


def random_calls(n=30):
    """States and pendulums with masses and lengths over four decades."""
    rng = np.random.default_rng(7)
    for _ in range(n):
        bars = {"masses": 10 ** rng.uniform(-2, 2, 2), "lengths": 10 ** rng.uniform(-2, 2, 2)}
        yield rng.uniform(-9, 9, 2), rng.normal(size=2) * 3, bars, rng.uniform(0, 30)


def test_every_term_is_lagranges():
    for theta, omega, bars, g in random_calls():
        M, f, G, energy, momentum = lagrange()(*theta, *omega, *bars["masses"], *bars["lengths"], g)
        found = pendulum.mass_matrix(theta, **bars)
        near(found, M)
        assert np.all(np.linalg.eigvalsh(found / np.sqrt(np.outer(np.diag(found), np.diag(found)))) > 0)
        near(pendulum.velocity_terms(theta, omega, **bars), f[:, 0], omega @ np.abs(M) @ omega)
        near(pendulum.gravity_terms(theta, gravity=g, **bars), G[:, 0])
        size = omega @ np.abs(M) @ omega + np.abs(G).sum() + g * bars["masses"].sum() * bars["lengths"].sum()
        near(pendulum.energy(theta, omega, gravity=g, **bars), energy, size)
        near(pendulum.angular_momentum(theta, omega, **bars), momentum, np.sum(np.abs(M) @ np.abs(omega)))


def near(found, expected, size=None):
    np.testing.assert_allclose(
        found, expected, rtol=0, atol=ROUNDING * (np.abs(expected).max() if size is None else size)
    )


def exact_acceleration(theta, omega, masses, lengths, gravity):
    """From the matrix and the terms, all with 50 digits."""
    (m1, m2), (l1, l2), (th1, th2), (om1, om2) = (
        map(mp.mpf, map(float, pair)) for pair in (masses, lengths, theta, omega)
    )
    coupling, g = m2 * l1 * l2 / 2, mp.mpf(gravity)
    M = mp.matrix(
        [[(m1 / 3 + m2) * l1**2, coupling * mp.cos(th1 - th2)], [coupling * mp.cos(th1 - th2), m2 * l2**2 / 3]]
    )
    pull = mp.matrix(
        [
            -coupling * mp.sin(th1 - th2) * om2**2 - g * (m1 / 2 + m2) * l1 * mp.sin(th1),
            coupling * mp.sin(th1 - th2) * om1**2 - g * m2 * l2 / 2 * mp.sin(th2),
        ]
    )
    return np.array([float(x) for x in mp.lu_solve(M, pull)])


@pytest.mark.parametrize("masses", [(1.0, 1.0), (1.0, 1e-9), (1e-9, 1.0), (1e-6, 1e6), (1e6, 1e-6)])
@pytest.mark.parametrize("lengths", [(1.0, 1.0), (1e-3, 1e3), (1e3, 1e-3)])
@pytest.mark.parametrize("theta", [(0.3, -2.0), (1.0, 1.0), (1.0, 1.0 + 1e-9)])
def test_accelerations_against_fifty_digits(masses, lengths, theta):
    known = {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": 9.81}
    with mp.workdps(50):
        exact = exact_acceleration(theta, OMEGA, **known)
    size = (np.max(lengths * OMEGA**2) + 9.81) / np.array(lengths) * 12  # determinants go down to 1/12
    lagrangian = pendulum.angular_acceleration(np.array(theta), OMEGA, **known)
    free, _ = pendulum.on_the_fly(np.array(theta), OMEGA, **known)
    assert np.all(np.abs(lagrangian - exact) <= ROUNDING * size)
    assert np.all(np.abs(free - exact) <= 10 * ROUNDING * size)  # ten equations round more


def test_hinge_forces_are_newtons_along_a_motion():
    """The accelerations of the mass centres by differences of eighth order, of which steps of 5 ms leave 1e-8."""
    h, weights = 5e-3, np.array([-9, 128, -1008, 8064, -14350, 8064, -1008, 128, -9]) / 5040
    states = pendulum.simulate(1.0 + h * np.arange(9), THETA, OMEGA, **SWINGING)
    wires = np.array([pendulum.wireframe(state[:2], lengths=BARS["lengths"]) for state in states])
    accelerations = np.tensordot(weights, wires.mean(axis=2), 1) / h**2 + [0, 9.81]
    on_bar_2 = BARS["masses"][1] * accelerations[1]
    by_ceiling = BARS["masses"][0] * accelerations[0] + on_bar_2
    _, forces = pendulum.on_the_fly(states[4, :2], states[4, 2:], **SWINGING)
    np.testing.assert_allclose(forces, [by_ceiling, on_bar_2], atol=1e-6)


def energies(states, known):
    return np.array([pendulum.energy(state[:2], state[2:], **known) for state in states])


def test_energy_stays_from_horizontal_for_ten_seconds():
    known = {"masses": np.ones(2), "lengths": np.ones(2), "gravity": 9.81}
    states = pendulum.simulate(np.linspace(0.0, 10.0, 501), HORIZONTAL, STILL, **known)
    assert np.ptp(states[:, 1]) > 2 * math.pi  # it does turn over
    assert np.ptp(energies(states, known)) <= 1e-11 * 2 * 9.81 * 2


def test_energy_and_angular_momentum_stay_without_gravity():
    known = {**BARS, "gravity": 0.0}
    states = pendulum.simulate(np.linspace(3.0, 30.0, 200), THETA, OMEGA, **known)
    assert np.ptp(energies(states, known)) <= 1e-11 * energies(states[:1], known)[0]
    momenta = [pendulum.angular_momentum(state[:2], state[2:], **BARS) for state in states]
    assert np.ptp(momenta) <= 1e-11 * np.sum(pendulum.mass_matrix(THETA, **BARS)) * np.max(np.abs(OMEGA))


def test_a_motion_retraces_its_path_and_has_a_mirror_image():
    t = np.array([0.0, 0.3, 0.35, 1.0, 2.0])
    states = pendulum.simulate(t, THETA, OMEGA, **SWINGING)
    back = pendulum.simulate(2.0 - t[::-1], states[-1, :2], -states[-1, 2:], **SWINGING)
    np.testing.assert_allclose(back[::-1] * [1, 1, -1, -1], states, atol=1e-10)  # what rounding grows to in 2 s
    np.testing.assert_allclose(pendulum.simulate(t, -THETA, -OMEGA, **SWINGING), -states, atol=1e-10)


def test_the_sampling_does_not_matter():
    t = np.array([0.0, 0.3, 0.35, 1.0, 2.0])
    few, many = (pendulum.simulate(times, THETA, OMEGA, **SWINGING) for times in (t, np.linspace(0.0, 2.0, 41)))
    np.testing.assert_allclose(few[[1, 2, 3, 4]], many[[6, 7, 20, 40]], atol=1e-10)
    np.testing.assert_array_equal(few[0], [*THETA, *OMEGA])


@pytest.mark.parametrize("light", [1e-9, 1e-12])
def test_under_a_massless_bar_bar_1_is_a_compound_pendulum(light):
    """Released at 2 rad: sin(th/2) = sin(1) sn(K - w t), w^2 = 3 g/(2 l). The light bar disturbs by its mass."""
    known = {"masses": np.array([1.3, 1.3 * light]), "lengths": np.array([0.9, 0.6]), "gravity": 9.81}
    t, m = np.linspace(0.0, 4.0, 41), math.sin(1.0) ** 2
    sn, *_ = ellipj(ellipk(m) - math.sqrt(1.5 * 9.81 / 0.9) * t, m)
    found = pendulum.simulate(t, np.array([2.0, -0.5]), STILL, **known)[:, 0]
    np.testing.assert_allclose(found, 2 * np.arcsin(math.sin(1.0) * sn), atol=1e3 * light + 1e-10)


def exact_frequencies(masses, lengths, gravity):
    """By the roots of det(K - w^2 M) with 50 digits."""
    (m1, m2), (l1, l2) = map(mp.mpf, map(float, masses)), map(mp.mpf, map(float, lengths))
    M = (m1 / 3 + m2) * l1**2, m2 * l1 * l2 / 2, m2 * l2**2 / 3
    k1, k2 = gravity * (m1 / 2 + m2) * l1, gravity * m2 * l2 / 2
    squares = mp.polyroots([M[0] * M[2] - M[1] ** 2, -(M[0] * k2 + M[2] * k1), k1 * k2], maxsteps=200, extraprec=200)
    return sorted(float(mp.sqrt(mp.re(square))) for square in squares)


@pytest.mark.parametrize("masses", [(1.0, 1.0), (0.3, 4.0), (1.0, 1e-9), (1e-9, 1.0), (1e6, 1e-6)])
@pytest.mark.parametrize("lengths", [(1.0, 1.0), (1.0, 1.6), (1e-3, 1e3), (1e6, 1e-6)])
def test_frequencies_against_fifty_digits(masses, lengths):
    with mp.workdps(50):
        exact = exact_frequencies(masses, lengths, mp.mpf(9.81))
    found = pendulum.small_oscillation_frequencies(masses=masses, lengths=lengths, gravity=9.81)
    np.testing.assert_allclose(found, exact, rtol=ROUNDING)


def test_frequencies_of_equal_bars_and_without_gravity():
    equal = {"masses": (0.7, 0.7), "lengths": (1.3, 1.3)}
    book = 9.81 / 1.3 * np.array([3 - 6 / math.sqrt(7), 3 + 6 / math.sqrt(7)])
    np.testing.assert_allclose(pendulum.small_oscillation_frequencies(gravity=9.81, **equal) ** 2, book, rtol=ROUNDING)
    np.testing.assert_array_equal(pendulum.small_oscillation_frequencies(gravity=0.0, **equal), [0, 0])


@pytest.mark.parametrize("mode", [0, 1])
def test_small_oscillations_have_their_frequencies(mode):
    """A mode of 1e-6 rad is a cosine, but for its cube."""
    frequency = pendulum.small_oscillation_frequencies(**SWINGING)[mode]
    M = pendulum.mass_matrix(STILL, **BARS)
    K = np.diag(pendulum.gravity_terms(HORIZONTAL, **SWINGING))
    shape = np.linalg.svd(K - frequency**2 * M)[2][1]  # what the singular matrix takes to zero
    t = np.linspace(0.0, 5.0, 30)
    states = pendulum.simulate(t, 1e-6 * shape, STILL, **SWINGING)
    np.testing.assert_allclose(states[:, :2], 1e-6 * np.outer(np.cos(frequency * t), shape), atol=1e-15)


def test_the_tip_path_is_that_of_the_wireframe():
    from matplotlib.figure import Figure

    axes, t = Figure().subplots(), np.linspace(1.0, 3.0, 21)
    pendulum.plot_tip_path(axes, t, THETA, OMEGA, **SWINGING)
    (line,) = axes.lines
    states = pendulum.simulate(t, THETA, OMEGA, **SWINGING)
    along = np.cumsum(BARS["lengths"] * np.exp(1j * (states[:, :2] - math.pi / 2)), axis=1)[:, 1]
    np.testing.assert_allclose(line.get_xydata() @ [1, 1j], along, atol=1e-12)
    assert axes.get_aspect() == 1


@pytest.mark.slow
@pytest.mark.parametrize("number", range(20))
def test_energy_over_a_minute_of_chaos(number):
    rng = np.random.default_rng(number)
    known = {"masses": 10 ** rng.uniform(-0.5, 0.5, 2), "lengths": 10 ** rng.uniform(-0.5, 0.5, 2), "gravity": 9.81}
    states = pendulum.simulate(np.linspace(0.0, 60.0, 601), rng.uniform(-3, 3, 2), STILL, **known)
    scale = 9.81 * np.sum(known["masses"]) * np.sum(known["lengths"])
    assert np.ptp(energies(states, known)) <= 1e-11 * scale
