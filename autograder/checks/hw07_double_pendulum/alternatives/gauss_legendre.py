"""Show that a symplectic method in conjugate momenta passes, and a path drawn as a LineCollection."""

import numpy as np
from matplotlib.collections import LineCollection

ROOT = np.sqrt(15)
A = np.array([
    [5 / 36, 2 / 9 - ROOT / 15, 5 / 36 - ROOT / 30],
    [5 / 36 + ROOT / 24, 2 / 9, 5 / 36 - ROOT / 24],
    [5 / 36 + ROOT / 30, 2 / 9 + ROOT / 15, 5 / 36],
])
WEIGHTS = np.array([5 / 18, 4 / 9, 5 / 18])


def entries(masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    return (m1 / 3 + m2) * l1**2, m2 * l1 * l2 / 2, m2 * l2**2 / 3


def mass_matrix(theta, *, masses, lengths):
    a, b, d = entries(masses, lengths)
    off = b * np.cos(theta[0] - theta[1])
    return np.array([a, off, off, d]).reshape(2, 2)


def velocity_terms(theta, omega, *, masses, lengths):
    _, b, _ = entries(masses, lengths)
    return b * np.sin(theta[0] - theta[1]) * np.array([1, -1]) * np.square(omega)[::-1]


def gravity_terms(theta, *, masses, lengths, gravity):
    arms = np.array([masses[0] / 2 + masses[1], masses[1] / 2]) * lengths
    return gravity * arms * np.sin(theta)


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads = loads + gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return np.linalg.inv(mass_matrix(theta, masses=masses, lengths=lengths)) @ -loads


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """Multipliers: J M^-1 J^T F = known, with accelerations per weight to keep a light bar in scale."""
    (m1, m2), (l1, l2) = masses, lengths
    e1, e2 = np.column_stack([np.sin(theta), -np.cos(theta)])
    n1, n2 = np.column_stack([np.cos(theta), np.sin(theta)])
    zero, one = np.zeros(2), np.eye(2)
    J = np.vstack([
        np.column_stack([one, -l1 / 2 * n1, 0 * one, zero]),
        np.column_stack([-one, -l1 / 2 * n1, one, -l2 / 2 * n2]),
    ])  # ceiling; elbow
    inverse = np.diag(1 / np.array([m1, m1, m1 * l1**2 / 12, m2, m2, m2 * l2**2 / 12]))
    free = np.array([0, -gravity, 0, 0, -gravity, 0])
    spins = l1 / 2 * omega[0] ** 2 * e1, l2 / 2 * omega[1] ** 2 * e2
    known = np.concatenate([-spins[0], -spins[0] - spins[1]]) - J @ free
    F = np.linalg.solve(J @ inverse @ J.T, known)
    alpha = angular_acceleration(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    return alpha, F.reshape(2, 2)


def energy(theta, omega, *, masses, lengths, gravity):
    arms = np.array([masses[0] / 2 + masses[1], masses[1] / 2]) * lengths
    M = mass_matrix(theta, masses=masses, lengths=lengths)
    return 0.5 * np.einsum("i,ij,j", omega, M, omega) - gravity * arms @ np.cos(theta)


def angular_momentum(theta, omega, *, masses, lengths):
    return np.sum(mass_matrix(theta, masses=masses, lengths=lengths) @ omega)


def hamilton(z, masses, lengths, gravity):
    """Derivatives of angles and momenta; z is (stages, 4)."""
    a, b, d = entries(masses, lengths)
    th1, th2, p1, p2 = z.T
    off = b * np.cos(th1 - th2)
    det = a * d - off**2
    om1, om2 = (d * p1 - off * p2) / det, (a * p2 - off * p1) / det
    turning = b * np.sin(th1 - th2) * om1 * om2
    pull1 = gravity * (masses[0] / 2 + masses[1]) * lengths[0] * np.sin(th1)
    pull2 = gravity * masses[1] / 2 * lengths[1] * np.sin(th2)
    return np.column_stack([om1, om2, -turning - pull1, turning - pull2])


def step(z, h, system):
    slopes = np.tile(hamilton(z[None], *system), (3, 1))
    for _ in range(30):
        before = slopes
        slopes = hamilton(z + h * A @ slopes, *system)
        if np.max(np.abs(slopes - before)) <= 1e-13 * np.max(np.abs(slopes)):
            break
    return z + h * WEIGHTS @ slopes


def simulate(t, theta, omega, *, masses, lengths, gravity):
    system, bars = (masses, lengths, gravity), {"masses": masses, "lengths": lengths}
    z = np.concatenate([theta, mass_matrix(theta, **bars) @ omega])
    rows = [[*theta, *omega]]
    rate = np.sqrt(gravity / np.min(lengths)) + np.max(np.abs(omega))
    for span in np.diff(t):
        n = int(np.ceil(span * rate / 0.03))
        for _ in range(n):
            z = step(z, span / n, system)
        rows.append([*z[:2], *np.linalg.solve(mass_matrix(z[:2], **bars), z[2:])])
    return np.array(rows)


def small_oscillation_frequencies(*, masses, lengths, gravity):
    M = mass_matrix(np.zeros(2), masses=masses, lengths=lengths)
    scale = np.diag(1 / np.sqrt(np.diag(M)))
    K = np.diag(gravity * np.array([masses[0] / 2 + masses[1], masses[1] / 2]) * lengths)
    squares = np.linalg.eigvals(np.linalg.solve(scale @ M @ scale, scale @ K @ scale))
    return np.sqrt(np.sort(squares.real))


def wireframe(theta, *, lengths):
    ends = np.cumsum(np.asarray(lengths)[:, None] * np.column_stack([np.sin(theta), -np.cos(theta)]), axis=0)
    return np.stack([np.vstack([np.zeros(2), ends[0]]), ends])


def plot_tip_path(ax, t, theta, omega, **known):
    th1, th2, _, _ = simulate(t, theta, omega, **known).T
    l1, l2 = known["lengths"]
    tips = np.column_stack([l1 * np.sin(th1) + l2 * np.sin(th2), -l1 * np.cos(th1) - l2 * np.cos(th2)])
    ax.add_collection(LineCollection(np.stack([tips[:-1], tips[1:]], axis=1), array=t[:-1]))
    ax.autoscale_view()
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
