"""What is right in hw10: H' = 0 in vectors, Jacobi's elliptic functions, the two turns of a wheel."""

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation
from scipy.special import ellipj, ellipkinc, elliprf

PRECISE = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-11}


def turned(v):
    """The rotation by |v| about v."""
    return Rotation.from_rotvec(v).as_matrix()


def euler_equations(omega, *, inertia):
    """omega', from H' = 0: the rate of H in the body's axes is H x omega."""
    inertia = np.asarray(inertia)
    return np.cross(inertia * omega, omega) / inertia


def attitude_rate(R, omega):
    """Every row of R, an axis of space seen from the body, turns backwards."""
    return np.cross(R, omega)


def energy(omega, *, inertia):
    return 0.5 * np.sum(inertia * omega**2)


def angular_momentum(R, omega, *, inertia):
    return np.sum([moment * w * axis for moment, w, axis in zip(inertia, omega, R.T, strict=True)], axis=0)


def euler_rates_313(angles, omega):
    """By the columns that are omega, in body components, of unit rates of psi, theta and phi."""
    _, theta, phi = angles
    x, _, z = np.eye(3)
    after_phi = turned(-phi * z)
    return np.linalg.solve(np.column_stack([after_phi @ turned(-theta * x) @ z, after_phi @ x, z]), omega)


def motion(t, R, omega, *, inertia):
    """omegas and rotations of any body, by solve_ivp."""
    inertia = np.asarray(inertia)

    def rates(_, y):
        p, q, r = w = y[:3]
        across = np.array([[0, -r, q], [r, 0, -p], [-q, p, 0]])  # v @ across is v x w, five times as fast as np.cross
        return np.append(inertia * w @ across / inertia, y[3:].reshape(3, 3) @ across)

    states = solve_ivp(rates, (t[0], t[-1]), np.append(omega, R), t_eval=t, **PRECISE).y.T
    return states[:, :3], states[:, 3:].reshape(-1, 3, 3)


def tumble(t, R, omega, *, inertia):
    """omegas of three different inertias in elliptic functions, dn about the axis they go round; motion's rotations."""
    order = np.argsort(inertia)
    if np.sum((inertia * omega) ** 2) < 2 * energy(omega, inertia=inertia) * np.median(inertia):
        order = order[::-1]
    (A, B, C), (p, q, r) = inertia[order], omega[order]
    first, last = B * (C - B) / (A * (C - A)), B * (B - A) / (C * (C - A))  # p^2 + first q^2 and r^2 + last q^2 stay
    a, c = math.sqrt(p**2 + first * q**2), math.copysign(math.sqrt(r**2 + last * q**2), r)
    b, handedness = a / math.sqrt(first), np.linalg.det(np.eye(3)[order])
    rate, m = handedness * (C - A) / B * a * c / b, last * (b / c) ** 2
    sn, cn, dn, _ = ellipj(ellipkinc(math.atan2(q / b, p / a), m) + rate * (t - t[0]), m)
    omegas = np.column_stack([a * cn, b * sn, c * dn])[:, np.argsort(order)]
    return omegas, motion(t, R, omega, inertia=inertia)[1]


def symmetric_solution(t, omega, *, inertia):
    """omega whose part across the axis turns at (C/A - 1) omega_3."""
    A, _, C = inertia
    across = (omega[0] + 1j * omega[1]) * np.exp(1j * (C / A - 1) * omega[2] * (t - t[0]))
    return np.column_stack([across.real, across.imag, np.full(len(t), omega[2])])


def wobble_rate(omega, *, inertia):
    """How fast the symmetry axis e, which moves at omega x e, goes round H."""
    H, e = inertia * omega, np.array([0.0, 0.0, 1.0])
    return np.linalg.norm(H) * np.linalg.norm(np.cross(omega, e)) / np.linalg.norm(np.cross(H, e))


def growth_rate_squared(axis, spin, *, inertia):
    """Deviations of the next axis grow at a rate whose square is this."""
    omega, other = spin * np.eye(3)[axis], (axis + 1) % 3
    rows = [(np.cross(inertia * d, omega) + np.cross(inertia * omega, d)) / inertia for d in np.eye(3)]
    return np.linalg.matrix_power(rows, 2)[other, other]


def tumble_period(omega, *, inertia):
    """4 K(k) over the rate, by Carlson's integral; for pure spin that of small oscillations."""
    A, B, C = inertia
    p, q, r = np.square(omega)
    beside = B * (B - A) * (C - B) * q
    round_first, round_last = A * (B - A) * p, C * (C - B) * r
    smaller, larger = (C - A) * abs(round_last - round_first), beside + (C - A) * max(round_first, round_last)
    return 4 * math.sqrt(A * B * C) * elliprf(0.0, smaller, larger)
