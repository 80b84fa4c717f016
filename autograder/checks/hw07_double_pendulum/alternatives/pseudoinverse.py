"""Show that a pseudoinverse of all ten equations passes, SciPy's generalized eigenvalues, a path as a LineCollection."""

import math

import numpy as np
from matplotlib.collections import LineCollection
from scipy.integrate import solve_ivp
from scipy.linalg import eigh


def wireframe(theta, *, lengths):
    bars = np.asarray(lengths)[:, None] * np.column_stack([np.sin(theta), -np.cos(theta)])
    ends = np.cumsum(np.vstack([np.zeros(2), bars]), axis=0)
    return [ends[:2].tolist(), ends[1:].tolist()]


def mass_matrix(theta, *, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    k = m2 * l1 * l2 / 2 * math.cos(theta[0] - theta[1])
    return [[m1 * l1**2 / 3 + m2 * l1**2, k], [k, m2 * l2**2 / 3]]


def velocity_terms(theta, omega, *, masses, lengths):
    k = masses[1] * lengths[0] * lengths[1] / 2 * math.sin(theta[0] - theta[1])
    return k * np.array([1, -1]) * np.square(omega)[::-1]


def gravity_terms(theta, *, masses, lengths, gravity):
    return gravity * np.array([masses[0] / 2 + masses[1], masses[1] / 2]) * lengths * np.sin(theta)


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """Unknowns a1x a1y a2x a2y al1 al2 Ax Ay Bx By: forces, moments about the mass centres, ceiling, elbow."""
    (m1, m2), (l1, l2) = masses, lengths
    (s1, s2), (c1, c2), (w1, w2) = np.sin(theta), np.cos(theta), np.square(omega)
    A, b, h, k = np.zeros((10, 10)), np.zeros(10), l1 / 2, l2 / 2
    A[0, [0, 6, 8]] = A[1, [1, 7, 9]] = m1, -1, 1
    A[2, [2, 8]] = A[3, [3, 9]] = m2, -1
    b[[1, 3]] = -m1 * gravity, -m2 * gravity
    A[4, [4, 6, 7, 8, 9]] = m1 * l1**2 / 12, h * c1, h * s1, h * c1, h * s1
    A[5, [5, 8, 9]] = m2 * l2**2 / 12, k * c2, k * s2
    A[6, [0, 4]], A[7, [1, 4]], b[6:8] = (1, -h * c1), (1, -h * s1), (-h * s1 * w1, h * c1 * w1)
    A[8, [2, 4, 5]], A[9, [3, 4, 5]] = (1, -l1 * c1, -k * c2), (1, -l1 * s1, -k * s2)
    b[8:] = -l1 * s1 * w1 - k * s2 * w2, l1 * c1 * w1 + k * c2 * w2
    x = np.linalg.pinv(A) @ b
    return x[4:6], x[6:].reshape(2, 2)


def angular_acceleration(theta, omega, *, gravity, **bars):
    loads = velocity_terms(theta, omega, **bars) + gravity_terms(theta, **bars, gravity=gravity)
    return -np.linalg.solve(mass_matrix(theta, **bars), loads)


def energy(theta, omega, *, masses, lengths, gravity):
    weights = gravity * np.array([masses[0] / 2 + masses[1], masses[1] / 2])
    return omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2 - weights @ (lengths * np.cos(theta))


def angular_momentum(theta, omega, **bars):
    return np.sum(mass_matrix(theta, **bars) @ omega)


def small_oscillation_frequencies(*, gravity, **bars):
    stiffness = np.diag(gravity_terms(np.full(2, np.pi / 2), **bars, gravity=gravity))
    return np.sqrt(eigh(stiffness, mass_matrix(np.zeros(2), **bars), eigvals_only=True))


def simulate(t, theta, omega, **pendulum):
    def rates(_, y):
        return [*y[2:], *angular_acceleration(y[:2], y[2:], **pendulum)]

    return solve_ivp(rates, (t[0], t[-1]), [*theta, *omega], method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9).y.T


def plot_tip_path(ax, t, theta, omega, *, lengths, **parameters):
    rows = simulate(t, theta, omega, lengths=lengths, **parameters)
    tips = np.array([wireframe(row[:2], lengths=lengths)[1][1] for row in rows])
    ax.add_collection(LineCollection(np.stack([tips[:-1], tips[1:]], axis=1), array=t[:-1]))
    ax.autoscale_view()
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    if bar not in (1, 2):
        raise ValueError("bar is 1 or 2")
    start, end = np.array(wireframe(theta, lengths=lengths)[bar - 1])
    forces = [[start, None], [(start + end) / 2, [0, -masses[bar - 1] * gravity]]]
    return [*forces, [end, None]] if bar == 1 else forces
