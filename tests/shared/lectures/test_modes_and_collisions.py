"""Laws of the lectures on vibrations, collisions, stiff springs, convergence, and Hamilton's principle."""

import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.invariants import observed_order
from tam570.lectures import convergence, stiff_impact
from tam570.lectures.collisions import collide, cradle
from tam570.lectures.least_action import action, is_minimum, path
from tam570.lectures.modes import chain, inverted_pendulum, modes, pendulum, saddle

DRAW = np.random.default_rng(573)
STEPS = [0.01, 0.005, 0.0025]  # s
ROD = {"mass": 1.3, "inertia": 0.2, "arms": (-0.5, 0.3), "speed": 0.8}


def matrices(squares):
    """Return a random mass matrix and a stiffness matrix with these squares of frequencies."""
    n = len(squares)
    root = DRAW.normal(size=(n, n)) + 3 * np.eye(n)
    Q, _ = np.linalg.qr(DRAW.normal(size=(n, n)))
    return root @ root.T, root @ Q @ np.diag(squares) @ Q.T @ root.T


@pytest.mark.parametrize("squares", [[-1.0, 2.0, 5.0], [3.0, 3.0, 3.0, 7.0], [0.0, 0.0, 1.0]])
def test_shapes_are_orthonormal_by_the_mass(squares):
    M, K = matrices(squares)
    result, shapes = modes(M, K)
    assert result == pytest.approx(squares, abs=1e-11)
    assert shapes.T @ M @ shapes == pytest.approx(np.eye(len(squares)), abs=1e-12)
    assert pytest.approx(M @ shapes * result, abs=1e-10) == K @ shapes


@pytest.mark.parametrize("n", [1, 2, 9])
def test_the_chain_has_the_known_frequencies(n):
    result, _ = modes(*chain(n, mass=0.4, stiffness=30.0))
    expected = [4 * 30.0 / 0.4 * math.sin(j * math.pi / (2 * (n + 1))) ** 2 for j in range(1, n + 1)]
    assert result == pytest.approx(expected, rel=1e-12)


def test_the_unstable_have_negative_squares():
    scene = {"mass": 2.0, "length": 0.5, "gravity": 9.81}
    assert modes(*pendulum(**scene))[0] == pytest.approx([9.81 / 0.5])
    assert modes(*inverted_pendulum(**scene))[0] == pytest.approx([-9.81 / 0.5])
    assert modes(*saddle(mass=2.0, curvature=0.3, gravity=9.81))[0] == pytest.approx([-9.81 * 0.3, 9.81 * 0.3])


def contact():
    """Return velocities, normal, arms, and {masses, inertias} of two random bodies that approach each other."""
    angle = DRAW.uniform(-math.pi, math.pi)
    n, arms = np.array([math.cos(angle), math.sin(angle)]), DRAW.normal(size=(2, 2))
    velocities = DRAW.normal(size=(2, 3))
    if speed(velocities, n, arms) < 0:
        velocities = -velocities
    masses, inertias = DRAW.uniform(0.2, 4, 2), DRAW.uniform(0.2, 4, 2)
    return velocities, n, arms, {"masses": masses, "inertias": inertias}


def speed(velocities, n, arms):
    """Return the speed, m/s, at which the two points in contact approach each other along n."""
    points = velocities[:, :2] + velocities[:, 2:] * np.column_stack([-arms[:, 1], arms[:, 0]])
    return float((points[0] - points[1]) @ n)


def momenta(v, arms, masses, inertias):
    """Return the linear momentum and the angular momentum about the contact."""
    across = arms[:, 1] * v[:, 0] - arms[:, 0] * v[:, 1]
    return [*masses @ v[:, :2], masses @ across + inertias @ v[:, 2]]


def energy(v, masses, inertias):
    return float(masses @ (v[:, 0] ** 2 + v[:, 1] ** 2) + inertias @ v[:, 2] ** 2) / 2


@pytest.mark.parametrize("restitution", [0.0, 0.4, 1.0])
def test_collisions_keep_both_momenta_and_lose_what_they_must(restitution):
    for _ in range(10):
        before, n, arms, bodies = contact()
        after, impulse = collide(before, 2.5 * n, arms, **bodies, restitution=restitution)
        masses, inertias = bodies["masses"], bodies["inertias"]
        assert momenta(after, arms, **bodies) == pytest.approx(momenta(before, arms, **bodies), abs=1e-12)
        approach = speed(before, n, arms)
        assert speed(after, n, arms) == pytest.approx(-restitution * approach, abs=1e-12)
        mu = impulse / ((1 + restitution) * approach)
        lost = energy(before, masses, inertias) - energy(after, masses, inertias)
        assert lost == pytest.approx((1 - restitution**2) / 2 * mu * approach**2, abs=1e-12)
        assert masses[1] * (after[1, :2] - before[1, :2]) == pytest.approx(impulse * n, abs=1e-12)


def test_walls_stand_and_pins_turn():
    falling = [[3.0, -2.0, 0.5], [0.0, 0.0, 0.0]]
    wall = {"masses": (2.0, math.inf), "inertias": (1.0, math.inf)}
    after, impulse = collide(falling, [0, -1], [[0, -1], [5, 0]], **wall, restitution=0.5)
    assert after == pytest.approx(np.array([[3.0, 1.0, 0.5], [0, 0, 0]])) and impulse == pytest.approx(6.0)
    after, _ = collide(falling, [0, -1], [[0, 0], [1, 0]], masses=(2.0, math.inf), inertias=(1.0, 0.5), restitution=0.0)
    assert after[1] == pytest.approx([0, 0, after[0, 1]]) and after[1, 2] < 0  # a door on its hinge


def test_the_cradle_passes_the_speeds_on():
    assert cradle([1.0, 1.0, 0, 0, 0], restitution=1.0).tolist() == [0, 0, 0, 1, 1]
    speeds = DRAW.normal(size=7)
    assert cradle(speeds, restitution=1.0) == pytest.approx(np.sort(speeds), abs=1e-14)
    assert cradle([1.0, 0.0], restitution=0.5) == pytest.approx([0.25, 0.75])
    assert cradle([1.0, 0.0, 0.0], restitution=0.0) == pytest.approx([1 / 3] * 3)
    for restitution in (0.0, 0.3, 0.9):
        after = cradle(speeds, restitution=restitution)
        assert after.sum() == pytest.approx(speeds.sum()) and (np.diff(after) > -1e-12).all()
        assert after @ after < speeds @ speeds


@pytest.mark.parametrize(("method", "expected"), [("Euler", 1), ("Heun", 2), ("RK4", 4)])
def test_methods_converge_with_their_order_by_both_equations(method, expected):
    assert convergence.order(method, STEPS) == pytest.approx((expected, expected), abs=0.1)
    by_rates, wrong = convergence.errors(method, STEPS)
    assert by_rates.shape == wrong.shape == (3,) and (np.diff(by_rates) < 0).all() and (np.diff(wrong) < 0).all()


def test_the_rebound_is_that_of_the_solved_motion():
    for stiffness, gravity in ((50.0, 9.81), (3000.0, 9.81), (40.0, 0.0)):
        expected = {"mass": 0.7, "stiffness": stiffness, "gravity": gravity}
        impulse, duration = stiff_impact.rebound(stiffness, mass=0.7, speed=1.5, gravity=gravity)
        times = np.linspace(0.0, duration, 2001)
        states = solve(stiff_impact.rates, times, [0.0, -1.5], parameters=expected, rtol=1e-12)
        assert states[-1] == pytest.approx([0.0, 1.5], abs=1e-9) and (states[1:-1, 0] < 0).all()
        pushes = [stiff_impact.push(state, **expected) for state in states]
        assert impulse == pytest.approx(np.trapezoid(pushes, times), rel=1e-5)


def test_a_stiff_spring_is_a_collision_in_the_limit():
    stiffnesses = 1e5 * 100.0 ** np.arange(5)
    rebounds = [stiff_impact.rebound(k, mass=2.0, speed=3.0, gravity=9.81) for k in stiffnesses]
    impulses, durations = np.transpose(rebounds)
    assert durations[:-1] / durations[1:] == pytest.approx(np.full(4, 10.0), rel=0.05)
    assert durations * np.sqrt(stiffnesses / 2.0) == pytest.approx(np.full(5, math.pi), rel=0.02)
    excess = impulses - 2 * 2.0 * 3.0
    assert (excess > 0).all() and (np.diff(excess) < 0).all() and excess[-1] < 1e-3


def test_two_contacts_keep_the_balances_and_the_energy():
    for ratio in (0.02, 1.0, 7.0):
        (up, turning), (first, second) = stiff_impact.two_contacts((ratio, 1.0), **ROD)
        a, b = ROD["arms"]
        assert ROD["mass"] * (up + ROD["speed"]) == pytest.approx(first + second)
        assert ROD["inertia"] * turning == pytest.approx(a * first + b * second)
        kinetic = (ROD["mass"] * up**2 + ROD["inertia"] * turning**2) / 2
        assert kinetic == pytest.approx(ROD["mass"] * ROD["speed"] ** 2 / 2, rel=1e-8)


def test_only_the_ratio_of_the_stiffnesses_matters_and_it_does():
    soft, stiff = (stiff_impact.two_contacts((k, 3 * k), **ROD)[0] for k in (1.0, 1e8))
    assert soft == pytest.approx(stiff, rel=1e-9)
    assert np.abs(stiff_impact.two_contacts((20.0, 1.0), **ROD)[0] - stiff).max() > 0.05
    even = stiff_impact.two_contacts((5.0, 5.0), **{**ROD, "arms": (-0.4, 0.4)})[0]
    assert even == pytest.approx([ROD["speed"], 0.0], abs=1e-9)


def test_a_much_stiffer_contact_collides_first():
    """In the limit the rod collides with the contacts in turn, as rigid bodies do, until it leaves both."""
    (up, turning), _ = stiff_impact.two_contacts((1e6, 1.0), **ROD)
    rod, arms = np.array([[0.0, -ROD["speed"], 0.0], [0.0, 0.0, 0.0]]), ROD["arms"]
    bodies = {"masses": (ROD["mass"], math.inf), "inertias": (ROD["inertia"], math.inf), "restitution": 1.0}
    which = 0
    while any(rod[0, 1] + arm * rod[0, 2] < -1e-12 for arm in arms):
        if rod[0, 1] + arms[which] * rod[0, 2] < 0:
            rod, _ = collide(rod, [0.0, -1.0], [[arms[which], 0.0], [0.0, 0.0]], **bodies)
        which = 1 - which
    assert [up, turning] == pytest.approx(rod[0, 1:], abs=5e-3)


SCENE = {"length": 0.8, "gravity": 9.81}
HALF = math.pi * math.sqrt(0.8 / 9.81)  # s, half a period of a small swing


def swing(theta, omega, duration, points):
    """Return the angles of the solved motion."""
    times = np.linspace(0.0, duration, points)
    return solve(lambda t, y: (y[1], -9.81 / 0.8 * math.sin(y[0])), times, [theta, omega], rtol=1e-12)[:, 0]


@pytest.mark.parametrize(("share", "omega"), [(0.4, 3.0), (0.8, -2.0), (0.98, 0.5)])
def test_it_meets_the_solved_motion_to_second_order(share, omega):
    duration, counts, errors = share * HALF, (21, 41, 81, 161), []
    for points in counts:
        solved = swing(0.3, omega, duration, points)
        result = path(solved[0], solved[-1], duration, points=points, **SCENE)
        assert result.shape == (points,) and (result[0], result[-1]) == (solved[0], solved[-1])
        errors.append(np.abs(result - solved).max())
    assert observed_order([1 / (n - 1) for n in counts], errors) == pytest.approx(2.0, abs=0.1)


def test_the_action_is_kinetic_less_potential_over_time():
    """The action of rest is -V T with V = -g l cos; that of a constant rate without gravity is l^2 th'^2/2 T."""
    assert action(np.full(5, 0.4), 2.0, **SCENE) == pytest.approx(2.0 * 9.81 * 0.8 * math.cos(0.4))
    assert action(np.linspace(0, 1, 9), 2.0, length=0.8, gravity=0.0) == pytest.approx(0.8**2 / 2 * 0.25 * 2.0)


@pytest.mark.parametrize(("share", "least"), [(0.5, True), (0.99, True), (1.01, False), (1.7, False)])
def test_small_swings_are_minima_before_half_a_period_alone(share, least):
    assert is_minimum(swing(0.0, 0.05, share * HALF, 201), share * HALF, **SCENE) is least


def test_what_is_no_motion_is_no_minimum():
    assert is_minimum(np.zeros(41), 0.5 * HALF, **SCENE)
    for points in (3, 5, 401):
        assert is_minimum(path(0.0, 0.0, 0.9 * HALF, points=points, **SCENE), 0.9 * HALF, **SCENE)
    assert not is_minimum(0.3 * np.linspace(0, 1, 41), 0.5 * HALF, **SCENE)


@pytest.mark.parametrize("share", [0.999, 1.0, 1.001, 1.3, 2.5])
def test_past_half_a_period_another_motion_has_less(share):
    """`path` obeys the equation of motion, and past half a period it has less action than rest."""
    duration, points = share * HALF, 401
    result = path(0.0, 0.0, duration, points=points, **SCENE)
    h = duration / (points - 1)
    assert np.abs(np.diff(result, 2) / h**2 + 9.81 / 0.8 * np.sin(result[1:-1])).max() < 1e-4  # 1e-11/h^2
    below = action(result, duration, **SCENE) - action(np.zeros(points), duration, **SCENE)
    assert below < -1e-9 if share > 1 else abs(below) < 1e-9
    assert is_minimum(result, duration, **SCENE) or share == 1.0
