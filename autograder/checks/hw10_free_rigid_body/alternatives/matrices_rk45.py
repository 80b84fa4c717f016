"""Show that RK45 on nine elements of R passes without orthogonalisation, and a period by ellipk."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipk


def hat(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def euler_equations(omega, *, inertia):
    I = np.diag(inertia)
    return np.linalg.solve(I, -np.cross(omega, I @ omega))


def attitude_rate(R, omega):
    return R @ hat(omega)


def euler_rates_313(angles, omega):
    psi, theta, phi = angles
    if abs(np.sin(theta)) < 1e-12:
        raise ValueError("gimbal lock")
    B = np.array(
        [
            [np.sin(theta) * np.sin(phi), np.cos(phi), 0],
            [np.sin(theta) * np.cos(phi), -np.sin(phi), 0],
            [np.cos(theta), 0, 1],
        ]
    )
    return np.linalg.solve(B, omega)


def energy(omega, *, inertia):
    return 0.5 * omega @ np.diag(inertia) @ omega


def angular_momentum(R, omega, *, inertia):
    return R @ np.diag(inertia) @ omega


def simulate(t, R, omega, *, inertia):
    def rhs(t, y):
        return np.concatenate(
            [euler_equations(y[:3], inertia=inertia), attitude_rate(y[3:].reshape(3, 3), y[:3]).ravel()]
        )

    start = np.concatenate([omega, R.ravel()])
    y = solve_ivp(rhs, (t[0], t[-1]), start, t_eval=t, rtol=1e-9, atol=1e-9).y.T
    return y[:, :3], y[:, 3:].reshape(-1, 3, 3)


def symmetric_solution(t, omega, *, inertia):
    rate = (inertia[2] - inertia[0]) / inertia[0] * omega[2]
    size, phase = np.hypot(omega[0], omega[1]), np.arctan2(omega[1], omega[0])
    angle = rate * (t - t[0]) + phase
    return np.array([size * np.cos(angle), size * np.sin(angle), 0 * t + omega[2]]).T


def wobble_rate(omega, *, inertia):
    return np.linalg.norm(inertia * omega) / inertia[0]


def growth_rate_squared(axis, spin, *, inertia):
    A, B, C = inertia
    if axis == 0:
        return (A - B) * (C - A) / (B * C) * spin**2
    if axis == 1:
        return (B - C) * (A - B) / (C * A) * spin**2
    return (C - A) * (B - C) / (A * B) * spin**2


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    T2, H2 = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    if H2 == T2 * B:
        return np.inf
    if H2 < T2 * B:
        A, C = C, A
    m = (B - A) * (T2 * C - H2) / ((C - B) * (H2 - T2 * A))
    return 4 * ellipk(m) * np.sqrt(A * B * C / ((C - B) * (H2 - T2 * A)))


def wireframe(R, *, size):
    a, b, c = np.asarray(size) / 2
    ring = [(a, b), (a, -b), (-a, -b), (-a, b)]
    edges = []
    for i in range(4):
        (x, y), (u, v) = ring[i], ring[i - 1]
        edges += [[(x, y, c), (u, v, c)], [(x, y, -c), (u, v, -c)], [(x, y, -c), (x, y, c)]]
    return np.einsum("ij,ekj->eki", R, np.array(edges))


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t[::10], R, omega, inertia=inertia)
    for point in ([0, radius, 0], [radius, 0, 0]):
        places = rotations @ np.array(point)
        ax.plot(places[::-1, 1], places[::-1, 2])
    ax.set_aspect("equal")
    ax.set_xlabel("y (m)")
    ax.set_ylabel("z (m)")
