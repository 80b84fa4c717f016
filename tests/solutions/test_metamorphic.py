"""Laws that need no answer key: turned axes, a mirror, time reversed, other units, another origin and sampling of time.

A law compares a solution with itself, so it holds whatever the right numbers are.
"""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.linalg import qr

from tam570_grader.checks import assignments

CLOSED = 1e-11  # formulas: rounding, some thousand times over
MOTION = 1e-7  # simulations: twice an integration's error, grown a hundredfold at most over these few seconds
TIMES = np.array([0.0, 0.1, 0.35, 0.5, 0.9, 1.0, 1.6, 2.0])
Q = qr(np.random.default_rng(570).normal(size=(3, 3)))[0]
Q = Q * np.linalg.det(Q)
SI = SimpleNamespace(kg=1.0, m=1.0, s=1.0)
UNITS = [SimpleNamespace(kg=8.0, m=0.5, s=2.0), SimpleNamespace(kg=0.3, m=1.7, s=0.6)]


def about_z(angle):
    return np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1.0]])


# A motion: parameters in units u, a start, the start's units, what turns round with time, what a mirror turns round.


def pendulum(s, t, y, u):
    return s.simulate(t, *y, length=0.8 * u.m, gravity=9.8 * u.m / u.s**2)


def drop(s, t, y, u):
    speed, angle = math.hypot(y[2], y[3]), math.atan2(y[3], y[2])
    ball = {"mass": 0.6 * u.kg, "drag": 0.3 * u.kg / u.s, "gravity": 9.8 * u.m / u.s**2}
    return np.asarray(s.simulate(t, speed, angle, **ball)) + [*y[:2], 0, 0]


def spring(s, t, y, u):
    at = {"mass": 0.6 * u.kg, "stiffness": 7 * u.kg / u.s**2, "gravity": 9.8 * u.m / u.s**2}
    return s.simulate(t, y[:3], y[3:], **at)


def circle(s, t, y, u):
    return s.simulate(t, y, mass=0.6 * u.kg, length=0.5 * u.m, gravity=9.8 * u.m / u.s**2)


def car(s, t, y, u, friction=0.2):
    body = {"mass": 900 * u.kg, "yaw_inertia": 1300 * u.kg * u.m**2, "front": 1.2 * u.m, "rear": 1.5 * u.m}
    return s.simulate(t, y, "rear", **body, friction=friction, gravity=9.8 * u.m / u.s**2)


def bars(s, t, y, u):
    both = {"masses": np.array([0.6, 1.1]) * u.kg, "lengths": np.array([0.7, 0.5]) * u.m}
    return s.simulate(t, y[:2], y[2:], **both, gravity=9.8 * u.m / u.s**2)


def body(s, t, y, u):
    inertia = np.array([1.0, 1.6, 2.1]) * u.kg * u.m**2
    omegas, rotations = s.simulate(t, y[3:].reshape(3, 3), y[:3], inertia=inertia)
    return np.column_stack([omegas, np.reshape(rotations, (len(t), 9))])


def bead(s, t, y, u):
    return s.simulate(t, *y, curvature=0.7 / u.m, gravity=9.8 * u.m / u.s**2)


def cylinder(s, t, y, u):
    body = {"mass": 0.6 * u.kg, "radius": 0.5 * u.m, "offset": 0.2 * u.m, "slope": 0.1}
    return s.simulate(t, *y, **body, inertia=0.04 * u.kg * u.m**2, gravity=9.8 * u.m / u.s**2)


def disk(s, t, y, u):
    inertia = np.array([0.03, 0.05]) * u.kg * u.m**2
    return s.simulate_euler(t, y, mass=0.6 * u.kg, radius=0.5 * u.m, inertia=inertia, gravity=9.8 * u.m / u.s**2)


def moving(run, start, units, flip, mirror=None):
    """Lengths, angles and rates of the state in `units`: a pair of powers of metre and second each."""
    flip, mirror = np.array(flip), mirror and np.array(mirror)
    return SimpleNamespace(run=run, start=np.array(start), units=units, flip=flip, mirror=mirror)


X, V, A, W = (1, 0), (1, -1), (0, 0), (0, -1)
MOTIONS = {
    "hw01_simple_pendulum": moving(pendulum, [1.1, -2.0], [A, W], [1, -1], [-1, -1]),
    "hw02_ballistics": moving(drop, [0, 0, 4.0, 3.0], [X, X, V, V], [1, 1, -1, -1]),
    "hw04_hanging_spring": moving(spring, [0.4, -0.3, 0.2, 1.0, 0.5, -2.0], [X, X, X, V, V, V], [1, 1, 1, -1, -1, -1]),
    "hw05_constrained_pendulum": moving(circle, [0.3, -0.4, 1.6, 1.2], [X, X, V, V], [1, 1, -1, -1], [-1, 1, -1, 1]),
    "hw06_braking": moving(car, [1, 2, 0.3, 15.0, 0.2], [X, X, A, V, W], [1, 1, 1, -1, -1], [1, -1, -1, 1, -1]),
    "hw07_double_pendulum": moving(bars, [0.7, -0.4, 1.0, 0.5], [A, A, W, W], [1, 1, -1, -1], [-1, -1, -1, -1]),
    "hw10_free_rigid_body": moving(body, [0.4, 1.5, -0.6, *np.eye(3).ravel()], [W] * 3 + [A] * 9, [-1] * 3 + [1] * 9),
    "hw12_bead_on_wire": moving(bead, [0.6, 1.2], [X, V], [1, -1], [-1, -1]),
    "hw13_rolling_cylinder": moving(cylinder, [0.4, 1.2], [A, W], [1, -1]),
    "hw14_rolling_disk": moving(
        disk, [0.1, 0.2, 0.3, 1.4, 0.5, 0.4, 0.2, -8.0], [X, X, A, A, A, W, W, W], [1] * 5 + [-1] * 3
    ),
}


def run(s, slug, t=TIMES, start=None, u=SI, **off):
    it = MOTIONS[slug]
    return np.asarray(it.run(s, t, it.start.copy() if start is None else start, u, **off))


def shifted(s, slug):
    """The motion does not know what time it is."""
    return run(s, slug, TIMES + 3.25), run(s, slug)  # added without rounding that would matter


def sampled(s, slug):
    """Rows at common times agree, finely and coarsely sampled."""
    fine = np.unique(np.concatenate([TIMES, np.linspace(0, 2, 57)]))
    return run(s, slug), run(s, slug, fine)[np.searchsorted(fine, TIMES)]


def reversed_in_time(s, slug):
    """From the end with its rates turned round the motion goes back; friction is off."""
    flip, off = MOTIONS[slug].flip, {"friction": 0.0} if slug == "hw06_braking" else {}
    there = run(s, slug, **off)
    return run(s, slug, 2.0 - TIMES[::-1], there[-1] * flip, **off)[::-1] * flip, there


def mirrored(s, slug):
    it = MOTIONS[slug]
    return run(s, slug, start=it.start * it.mirror), run(s, slug) * it.mirror


def rescaled(s, slug):
    """Kilograms, metres and seconds of other sizes: every quantity scales by its dimension."""
    it, results = MOTIONS[slug], []
    for u in UNITS:
        size = np.array([u.m**length * u.s**time for length, time in it.units])
        results.append(run(s, slug, TIMES * u.s, it.start * size, u) / size)
    return results, [run(s, slug)] * 2


def turned(s, slug):
    return TURNED[slug](s)


def turned_moments(s):
    vectors = np.array([[1, 2, 3], [2, -1, 1], [0, 1, 2], [3, 1, 1], [1, 1, -2], [2, 0, 1.0]])
    rates = [[s.rate(letter, *rows, mass=0.6) for letter in "abc"] for rows in (vectors @ Q.T, vectors)]
    return rates[0], rates[1] @ Q.T


def turned_spring(s):
    it, turn = MOTIONS["hw04_hanging_spring"], np.kron(np.eye(2), about_z(0.9))
    return spring(s, TIMES, turn @ it.start, SI), spring(s, TIMES, it.start, SI) @ turn.T


def turned_axis(s):
    n, r = np.array([0.3, -1.2, 0.7]), np.array([1.0, 2.0, -0.5])
    return [s.rotation_matrix(Q @ n, 1.3), np.tile(s.rotate(Q @ r, Q @ n, 1.3), (3, 1))], [
        Q @ s.rotation_matrix(n, 1.3) @ Q.T,
        np.tile(Q @ s.rotate(r, n, 1.3), (3, 1)),
    ]


def turned_book(s):
    R = np.asarray(s.space_sequence([("x", 0.7), ("y", -1.1), ("z", 0.4)]))
    (n, angle), (m, same) = s.axis_angle(R), s.axis_angle(Q @ R @ Q.T)
    return [*m, same], [*(Q @ n), angle]


def turned_body(s):
    inertia, omega, start = np.array([1.0, 1.6, 2.1]), np.array([0.4, 1.5, -0.6]), about_z(0.3)
    omegas, rotations = s.simulate(TIMES, start, omega, inertia=inertia)
    same, turns = s.simulate(TIMES, Q @ start, omega, inertia=inertia)
    momenta = [s.angular_momentum(R, omega, inertia=inertia) for R in (Q @ start, start)]
    renamed = [1, 2, 0]  # body axes named in another order
    other, _ = s.simulate(TIMES, np.eye(3), omega[renamed], inertia=inertia[renamed])
    return np.concatenate([np.ravel(x) for x in (same, turns, other, momenta[0])]), np.concatenate(
        [np.ravel(x) for x in (omegas, Q @ rotations, np.asarray(omegas)[:, renamed], Q @ momenta[1])]
    )


def turned_disk(s):
    start = MOTIONS["hw14_rolling_disk"].start
    there, turn = np.array(disk(s, TIMES, start, SI)), about_z(0.9)[:2, :2]
    yawed = np.array([*(turn @ start[:2]), start[2] + 0.9, *start[3:]])
    return disk(s, TIMES, yawed, SI), np.column_stack([there[:, :2] @ turn.T, there[:, 2] + 0.9, there[:, 3:]])


TURNED = {
    "hw03_angular_momentum_rate": turned_moments,
    "hw04_hanging_spring": turned_spring,
    "hw08_axis_angle": turned_axis,
    "hw09_book": turned_book,
    "hw10_free_rigid_body": turned_body,
    "hw14_rolling_disk": turned_disk,
}
IRREVERSIBLE = {"hw02_ballistics"}  # it starts at the origin alone, so not at an end
LAWS = [
    *((law, slug) for law in (shifted, sampled, rescaled) for slug in MOTIONS),
    *((reversed_in_time, slug) for slug in MOTIONS if slug not in IRREVERSIBLE),
    *((mirrored, slug) for slug, it in MOTIONS.items() if it.mirror is not None),
    *((turned, slug) for slug in TURNED),
]


@pytest.mark.parametrize("law, slug", LAWS, ids=[f"{law.__name__}-{slug[:4]}" for law, slug in LAWS])
def test_the_solution_obeys(law, slug):
    """The largest difference over the largest number in its place, or over 1."""
    results, expected = (np.asarray(x, dtype=float) for x in law(assignments.solution(slug), slug))
    assert results.shape == expected.shape
    differences = np.abs(results - expected) / np.maximum(1.0, np.max(np.abs(expected), axis=0))
    assert differences.max() < (CLOSED if law is turned and slug not in MOTIONS else MOTION)
