"""Right: R integrated and made orthogonal by singular values, the period as Landau and Lifshitz print it."""
import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation
from scipy.special import ellipkm1


def euler_equations(omega, *, inertia):
    A, B, C = inertia
    p, q, r = omega
    return (B - C) * q * r / A, (C - A) * r * p / B, (A - B) * p * q / C


def attitude_rate(R, omega):
    p, q, r = omega
    return R @ np.array([[0, -r, q], [r, 0, -p], [-q, p, 0]])


def euler_rates_313(angles, omega):
    psi, theta, phi = angles
    if abs(math.sin(theta)) < 1e-12:
        raise ValueError("gimbal lock")
    p, q, r = omega
    dpsi = (p * math.sin(phi) + q * math.cos(phi)) / math.sin(theta)
    dtheta = p * math.cos(phi) - q * math.sin(phi)
    return [dpsi, dtheta, r - dpsi * math.cos(theta)]


def energy(omega, *, inertia):
    return sum(i * w * w for i, w in zip(inertia, omega)) / 2


def angular_momentum(R, omega, *, inertia):
    return R @ (np.array(inertia) * omega)


def symmetric_solution(t, omega, *, inertia):
    A, _, C = inertia
    p, q, r = omega
    lam = (C - A) / A * r
    out = []
    for s in t:
        a = lam * (s - t[0])
        out.append([p * math.cos(a) - q * math.sin(a), p * math.sin(a) + q * math.cos(a), r])
    return out


def wobble_rate(omega, *, inertia):
    return np.linalg.norm(np.asarray(inertia) * omega) / inertia[0]


def growth_rate_squared(axis, spin, *, inertia):
    i, j, k = inertia[axis], inertia[axis - 1], inertia[axis - 2]
    return (i - j) * (k - i) / (j * k) * spin**2


def wireframe(R, *, size):
    corner = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) / 2 * size
    edges = []
    for a in range(8):
        for bit in (1, 2, 4):
            if not a & bit:
                edges.append([R @ corner[a], R @ corner[a | bit]])
    return edges


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for column in (0, 1):
        p = radius * rotations[:, :, column]
        ax.plot(p[:, 1], p[:, 2])
    ax.set_xlabel("y (m)")
    ax.set_ylabel("z (m)")
    ax.set_aspect("equal")

from scipy.special import ellipk


def simulate(t, R, omega, *, inertia):
    "R itself in the equations, made orthogonal by a singular value decomposition at the end"

    def rhs(_, s):
        return np.concatenate([euler_equations(s[:3], inertia=inertia), attitude_rate(s[3:].reshape(3, 3), s[:3]).ravel()])

    sol = solve_ivp(rhs, (t[0], t[-1]), np.concatenate([omega, np.ravel(R)]), t_eval=t, rtol=1e-9, atol=1e-9)
    out = []
    for row in sol.y[3:].T:
        U, _, V = np.linalg.svd(row.reshape(3, 3))
        out.append(U @ V)
    out[0] = R
    return [sol.y[:3].T, np.array(out)]


def tumble_period(omega, *, inertia):
    "Landau and Lifshitz, as printed"
    A, B, C = inertia
    p, q, r = omega
    E2, M2 = A * p**2 + B * q**2 + C * r**2, (A * p) ** 2 + (B * q) ** 2 + (C * r) ** 2
    if M2 < E2 * B:
        A, C = C, A
    k2 = (B - A) * (E2 * C - M2) / ((C - B) * (M2 - E2 * A))
    if k2 >= 1:
        return math.inf
    return 4 * ellipk(k2) * math.sqrt(A * B * C / ((C - B) * (M2 - E2 * A)))
