"""Right: angular momentum balances of both bars about the ceiling and of bar 2 about the elbow, by cross products."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigvals


def cross(r, a):
    return r[0] * a[1] - r[1] * a[0]


def kinematics(theta, omega, alpha, lengths):
    """Elbow, mass centres, their velocities and accelerations."""
    along = [np.array([np.sin(th), -np.cos(th)]) for th in theta]
    across = [np.array([np.cos(th), np.sin(th)]) for th in theta]
    v = [length * om * n for length, om, n in zip(lengths, omega, across)]
    a = [l * (al * n - om**2 * e) for l, om, al, e, n in zip(lengths, omega, alpha, along, across)]
    elbow = lengths[0] * along[0]
    places = [elbow / 2, elbow + lengths[1] / 2 * along[1]]
    return elbow, places, [v[0] / 2, v[0] + v[1] / 2], [a[0] / 2, a[0] + a[1] / 2]


def balances(theta, omega, alpha, masses, lengths, gravity):
    """Rate of angular momentum minus moment of the weights: both bars about the ceiling, bar 2 about the elbow."""
    elbow, places, _, accelerations = kinematics(theta, omega, alpha, lengths)
    up = np.array([0.0, gravity])
    spin = [m * l**2 / 12 * al for m, l, al in zip(masses, lengths, alpha)]
    pulls = [m * (a + up) for m, a in zip(masses, accelerations)]
    about_ceiling = sum(cross(r, pull) for r, pull in zip(places, pulls)) + sum(spin)
    about_elbow = cross(places[1] - elbow, pulls[1]) + spin[1]
    return np.array([about_ceiling, about_elbow])


STILL = np.zeros(2)


def mass_matrix(theta, *, masses, lengths):
    return np.transpose([balances(theta, STILL, unit, masses, lengths, 0.0) for unit in np.eye(2)])


def velocity_terms(theta, omega, *, masses, lengths):
    return balances(theta, omega, STILL, masses, lengths, 0.0)


def gravity_terms(theta, *, masses, lengths, gravity):
    return balances(theta, STILL, STILL, masses, lengths, gravity)


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    f = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    g = gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return np.linalg.solve(mass_matrix(theta, masses=masses, lengths=lengths), -f - g)


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    # unknowns: alpha1, alpha2, F0x, F0y, F1x, F1y; the constraints are in the accelerations
    elbow, places, _, rest = kinematics(theta, omega, STILL, lengths)
    matrix, known = np.zeros((6, 6)), np.zeros(6)
    for bar in range(2):
        for column, unit in enumerate(np.eye(2)):
            matrix[2 * bar : 2 * bar + 2, column] = masses[bar] * kinematics(theta, STILL, unit, lengths)[3][bar]
        known[2 * bar : 2 * bar + 2] = -masses[bar] * (rest[bar] + [0.0, gravity])
        matrix[4 + bar, bar] = masses[bar] * lengths[bar] ** 2 / 12
    matrix[0:2, 2:4], matrix[0:2, 4:6], matrix[2:4, 4:6] = -np.eye(2), np.eye(2), -np.eye(2)
    top, bottom, upper = -places[0], elbow - places[0], elbow - places[1]
    for k, unit in enumerate(np.eye(2)):
        matrix[4, 2 + k], matrix[4, 4 + k] = -cross(top, unit), cross(bottom, unit)
        matrix[5, 4 + k] = -cross(upper, unit)
    unknown = np.linalg.solve(matrix, known)
    return unknown[:2], unknown[2:].reshape(2, 2)


def energy(theta, omega, *, masses, lengths, gravity):
    _, places, velocities, _ = kinematics(theta, omega, STILL, lengths)
    bars = zip(masses, lengths, omega, places, velocities)
    return sum(m * (v @ v / 2 + l**2 * om**2 / 24 + gravity * r[1]) for m, l, om, r, v in bars)


def angular_momentum(theta, omega, *, masses, lengths):
    _, places, velocities, _ = kinematics(theta, omega, STILL, lengths)
    bars = zip(masses, lengths, omega, places, velocities)
    return sum(m * (cross(r, v) + l**2 / 12 * om) for m, l, om, r, v in bars)


def simulate(t, theta, omega, *, masses, lengths, gravity):
    def rates(_, y):
        alpha = angular_acceleration(y[:2], y[2:], masses=masses, lengths=lengths, gravity=gravity)
        return np.concatenate([y[2:], alpha])

    start = np.concatenate([theta, omega])
    return solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9).y.T


def small_oscillation_frequencies(*, masses, lengths, gravity):
    small = 1e-4  # rad: the moments are odd in it, and sin(x) / x is 1 - x^2/6
    step = np.sin(small) * np.eye(2)
    K = np.transpose([gravity_terms(np.arcsin(unit), masses=masses, lengths=lengths, gravity=gravity) for unit in step])
    squares = eigvals(K / np.sin(small), mass_matrix(STILL, masses=masses, lengths=lengths)).real
    return np.sort(np.sqrt(np.abs(squares)))


def wireframe(theta, *, lengths):
    elbow, places, _, _ = kinematics(theta, STILL, STILL, lengths)
    return [[np.zeros(2), elbow], [elbow, 2 * places[1] - elbow]]


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    motion = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    tips = np.array([wireframe(row[:2], lengths=lengths)[1][1] for row in motion])
    ax.plot(*tips.T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    elbow = (lengths[0] * np.sin(theta[0]), -lengths[0] * np.cos(theta[0]))
    far = (elbow[0] + lengths[1] * np.sin(theta[1]), elbow[1] - lengths[1] * np.cos(theta[1]))
    ends = {1: ((0.0, 0.0), elbow), 2: (elbow, far)}
    if bar not in ends:
        raise ValueError(f"no bar {bar}")
    (a, b), (c, d) = ends[bar]
    forces = [(((a + c) / 2, (b + d) / 2), (0, -1)), (elbow, (1, 0)), (elbow, (0, 1))]
    return forces + [((0, 0), (1, 0)), ((0, 0), (0, 1))] if bar == 1 else forces
