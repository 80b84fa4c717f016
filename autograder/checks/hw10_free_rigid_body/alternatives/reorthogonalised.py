"""Right: DOP853 from sample to sample, R replaced by the nearest rotation each time; the period by Gauss's mean."""

import numpy as np
from scipy.integrate import solve_ivp


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
        M, w = y[:9].reshape(3, 3), y[9:]
        return np.hstack([(M @ hat(w)).ravel(), np.cross(inertia * w, w) / inertia])

    omegas, rotations = [np.array(omega)], [np.array(R)]
    for start, end in zip(t[:-1], t[1:]):
        y = np.hstack([rotations[-1].ravel(), omegas[-1]])
        y = solve_ivp(rhs, (start, end), y, method="DOP853", rtol=1e-9, atol=1e-9).y[:, -1]
        U, _, V = np.linalg.svd(y[:9].reshape(3, 3))
        rotations.append(U @ V)
        omegas.append(y[9:])
    return omegas, rotations


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
    p, q, r = np.abs(omega)
    last, first = C * (C - B) * r**2, A * (B - A) * p**2
    a = np.sqrt(B * (B - A) * (C - B) * q**2 + (C - A) * max(first, last))
    b = np.sqrt((C - A) * abs(last - first))
    if b == 0:
        return float("inf")
    for _ in range(60):
        a, b = (a + b) / 2, np.sqrt(a * b)
    return 2 * np.pi * np.sqrt(A * B * C) / a


def wireframe(R, *, size):
    a, b, c = np.asarray(size) / 2
    ring = [(a, b), (a, -b), (-a, -b), (-a, b)]
    edges = []
    for i in range(4):
        (x, y), (u, v) = ring[i], ring[i - 1]
        edges += [[(x, y, c), (u, v, c)], [(x, y, -c), (u, v, -c)], [(x, y, -c), (x, y, c)]]
    return np.einsum("ij,ekj->eki", R, np.array(edges))


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for point in ([0, radius, 0], [radius, 0, 0]):
        places = rotations @ np.array(point)
        ax.plot(places[:, 1], places[:, 2])
    ax.set_aspect("equal")
    ax.set_xlabel("y (m)")
    ax.set_ylabel("z (m)")
