"""Right: everything from ten equations for two free bars in plain units; DOP853; a general eigenvalue problem."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eig


def along(th):
    return np.array([np.sin(th), -np.cos(th)])


def across(th):
    return np.array([np.cos(th), np.sin(th)])


def mass_matrix(theta, *, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    M = np.zeros((2, 2))
    for i in range(2):
        for k in range(2):
            unit = np.eye(2)
            v1 = [l1 / 2 * across(theta[0]) * w[0] for w in unit]
            v2 = [l1 * across(theta[0]) * w[0] + l2 / 2 * across(theta[1]) * w[1] for w in unit]
            spin = unit[i] * unit[k]
            M[i, k] = m1 * v1[i] @ v1[k] + m2 * v2[i] @ v2[k]
            M[i, k] += (m1 * l1**2 * spin[0] + m2 * l2**2 * spin[1]) / 12
    return M


def velocity_terms(theta, omega, *, masses, lengths):
    (_, m2), (l1, l2) = masses, lengths
    centripetal = -l1 * omega[0] ** 2 * along(theta[0]) - l2 / 2 * omega[1] ** 2 * along(theta[1])
    return np.array([m2 * l1 * across(theta[0]) @ centripetal, m2 * l2 / 2 * across(theta[1]) @ centripetal])


def gravity_terms(theta, *, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    up = np.array([0, gravity])
    return np.array([(m1 / 2 + m2) * l1 * across(theta[0]) @ up, m2 * l2 / 2 * across(theta[1]) @ up])


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    bars = {"masses": masses, "lengths": lengths}
    right = -velocity_terms(theta, omega, **bars) - gravity_terms(theta, gravity=gravity, **bars)
    return np.linalg.solve(mass_matrix(theta, **bars), right)


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    (a1, a2), (n1, n2) = map(along, theta), map(across, theta)
    A, b = np.zeros((10, 10)), np.zeros(10)
    # unknowns: aG1 aG2 al1 al2 F1 F2
    A[0:2, 0:2], A[0:2, 6:8], A[0:2, 8:10], b[1] = m1 * np.eye(2), -np.eye(2), np.eye(2), -m1 * gravity
    A[2:4, 2:4], A[2:4, 8:10], b[3] = m2 * np.eye(2), -np.eye(2), -m2 * gravity
    A[4, 4], A[4, 6:8], A[4, 8:10] = m1 * l1**2 / 12, l1 / 2 * n1, l1 / 2 * n1
    A[5, 5], A[5, 8:10] = m2 * l2**2 / 12, l2 / 2 * n2
    A[6:8, 0:2], A[6:8, 4], b[6:8] = np.eye(2), -l1 / 2 * n1, -l1 / 2 * omega[0] ** 2 * a1
    A[8:10, 0:2], A[8:10, 2:4] = np.eye(2), -np.eye(2)
    A[8:10, 4], A[8:10, 5] = l1 / 2 * n1, l2 / 2 * n2
    b[8:10] = l1 / 2 * omega[0] ** 2 * a1 + l2 / 2 * omega[1] ** 2 * a2
    x = np.linalg.solve(A, b)
    return x[4:6], x[6:].reshape(2, 2)


def energy(theta, omega, *, masses, lengths, gravity):
    (m1, m2), (l1, l2) = masses, lengths
    heights = l1 / 2 * along(theta[0])[1], l1 * along(theta[0])[1] + l2 / 2 * along(theta[1])[1]
    kinetic = omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2
    return kinetic + gravity * (m1 * heights[0] + m2 * heights[1])


def angular_momentum(theta, omega, *, masses, lengths):
    (m1, m2), (l1, l2) = masses, lengths
    r1, v1 = l1 / 2 * along(theta[0]), l1 / 2 * omega[0] * across(theta[0])
    r2, v2 = 2 * r1 + l2 / 2 * along(theta[1]), 2 * v1 + l2 / 2 * omega[1] * across(theta[1])
    orbital = m1 * (r1[0] * v1[1] - r1[1] * v1[0]) + m2 * (r2[0] * v2[1] - r2[1] * v2[0])
    return orbital + m1 * l1**2 / 12 * omega[0] + m2 * l2**2 / 12 * omega[1]


def simulate(t, theta, omega, **known):
    def rates(_, y):
        return np.r_[y[2:], angular_acceleration(y[:2], y[2:], **known)]

    found = solve_ivp(rates, (t[0], t[-1]), np.r_[theta, omega], "DOP853", t_eval=t, rtol=1e-9, atol=1e-9)
    return found.y.T


def small_oscillation_frequencies(*, masses, lengths, gravity):
    M = mass_matrix(np.zeros(2), masses=masses, lengths=lengths)
    K = np.diag(gravity_terms(np.full(2, np.pi / 2), masses=masses, lengths=lengths, gravity=gravity))
    return np.sort(np.sqrt(eig(K, M)[0].real))


def wireframe(theta, *, lengths):
    elbow = lengths[0] * along(theta[0])
    return [[(0, 0), elbow], [elbow, elbow + lengths[1] * along(theta[1])]]


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    states = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    tips = np.array([wireframe(state[:2], lengths=lengths)[1][1] for state in states])
    ax.plot(*tips.T)
    ax.plot(*tips[:1].T, "o", label="start")
    ax.axis("equal")
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    elbow = (lengths[0] * np.sin(theta[0]), -lengths[0] * np.cos(theta[0]))
    far = (elbow[0] + lengths[1] * np.sin(theta[1]), elbow[1] - lengths[1] * np.cos(theta[1]))
    ends = {1: ((0.0, 0.0), elbow), 2: (elbow, far)}
    if bar not in ends:
        raise ValueError(f"no bar {bar}")
    (a, b), (c, d) = ends[bar]
    forces = [(((a + c) / 2, (b + d) / 2), (0, -1)), (elbow, (1, 0)), (elbow, (0, 1))]
    return forces + [((0, 0), (1, 0)), ((0, 0), (0, 1))] if bar == 1 else forces
