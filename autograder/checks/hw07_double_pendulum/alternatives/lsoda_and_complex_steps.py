"""Right: Lagrange's equations from the energies by complex steps, LSODA, Cholesky."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigh


def centres(theta, lengths):
    """x, y of both mass centres, as functions that take complex angles."""
    l1, l2 = lengths
    x, y = np.sin(theta), -np.cos(theta)
    return np.array([l1 / 2 * x[0], l1 / 2 * y[0], l1 * x[0] + l2 / 2 * x[1], l1 * y[0] + l2 / 2 * y[1]])


def jacobian(theta, lengths):
    h = 1e-30
    return np.column_stack([centres(theta + 1j * h * e, lengths).imag / h for e in np.eye(2)])


def bend(theta, omega, lengths):
    """The mass centres' accelerations at constant omega: differences of the Jacobian, taken exactly."""
    return -np.array([[0.5, 0], [0.5, 0], [1, 0.5], [1, 0.5]]) * np.array([
        [lengths[0] * np.sin(theta[0]), 0], [-lengths[0] * np.cos(theta[0]), 0],
        [lengths[0] * np.sin(theta[0]), lengths[1] * np.sin(theta[1])],
        [-lengths[0] * np.cos(theta[0]), -lengths[1] * np.cos(theta[1])],
    ]) @ np.square(omega)


def weights(masses):
    return np.repeat(masses, 2)


def mass_matrix(theta, *, masses, lengths):
    J = jacobian(np.asarray(theta, complex), lengths)
    return J.T @ (weights(masses)[:, None] * J) + np.diag(masses * np.square(lengths) / 12)


def velocity_terms(theta, omega, *, masses, lengths):
    return jacobian(theta + 0j, lengths).T @ (weights(masses) * bend(theta, omega, lengths))


def gravity_terms(theta, *, masses, lengths, gravity):
    return jacobian(theta + 0j, lengths).T @ (weights(masses) * gravity * [0, 1, 0, 1])


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads += gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    return -np.linalg.solve(mass_matrix(theta, masses=masses, lengths=lengths), loads)


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    alpha = angular_acceleration(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    a = jacobian(theta + 0j, lengths) @ alpha + bend(theta, omega, lengths)
    needed = (weights(masses) * (a + gravity * np.array([0, 1, 0, 1]))).reshape(2, 2)
    return tuple(alpha), [needed[0] + needed[1], needed[1]]


def energy(theta, omega, *, masses, lengths, gravity):
    potential = weights(masses) * gravity * [0, 1, 0, 1] @ centres(theta, lengths)
    return np.float64(omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2 + potential)


def angular_momentum(theta, omega, *, masses, lengths):
    v, r = jacobian(theta + 0j, lengths) @ omega, centres(theta, lengths)
    orbital = masses[0] * (r[0] * v[1] - r[1] * v[0]) + masses[1] * (r[2] * v[3] - r[3] * v[2])
    return orbital + np.sum(masses * np.square(lengths) * omega) / 12


def simulate(t, theta, omega, **known):
    def rates(_, y):
        return [*y[2:], *angular_acceleration(y[:2], y[2:], **known)]

    return solve_ivp(
        rates, (t[0], t[-1]), [*theta, *omega], method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9
    ).y.T


def small_oscillation_frequencies(*, masses, lengths, gravity):
    K = np.diag(gravity_terms(np.full(2, np.pi / 2), masses=masses, lengths=lengths, gravity=gravity))
    return np.sqrt(eigh(K, mass_matrix(np.zeros(2), masses=masses, lengths=lengths), eigvals_only=True))


def wireframe(theta, *, lengths):
    x1, y1, x2, y2 = centres(np.asarray(theta), np.asarray(lengths))
    elbow = 2 * np.array([x1, y1])
    return np.array([[[0, 0], elbow], [elbow, 2 * np.array([x2, y2]) - elbow]])


def plot_tip_path(ax, t, theta, omega, **known):
    fine = np.linspace(t[0], t[-1], 2 * len(t))
    states = simulate(fine, theta, omega, **known)
    x, y = np.array([wireframe(row[:2], lengths=known["lengths"])[1, 1] for row in states]).T
    ax.plot(x, y)
    ax.set_aspect("equal", "box")
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    l1, l2 = lengths
    e1, e2 = ([np.sin(th), -np.cos(th)] for th in theta)
    if bar == 1:
        return [[[0, 0], None], [[l1 / 2 * e for e in e1], [0, -masses[0] * gravity]], [[l1 * e for e in e1], None]]
    if bar == 2:
        middle = [l1 * a + l2 / 2 * b for a, b in zip(e1, e2)]
        return [[[l1 * e for e in e1], None], [middle, [0, -masses[1] * gravity]]]
    raise ValueError("bar is 1 or 2")
