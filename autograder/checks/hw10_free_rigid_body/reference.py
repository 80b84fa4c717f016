"""Reference functions of hw10: H' = 0 in vectors, Jacobi's elliptic functions, the two turns of a wheel."""

import math

import numpy as np

from tam570.integrate import solve

ALIKE = 1e-3  # of the mean: smaller differences enter a series up to the fifth power, with an error of 1e-18


def turned(v):
    """Return the rotation by |v| about v (Rodrigues)."""
    half_turns, across = np.linalg.norm(v) / np.pi, np.cross(np.eye(3), v)
    return np.eye(3) + np.sinc(half_turns) * across + np.sinc(half_turns / 2) ** 2 / 2 * across @ across


def euler_equations(omega, *, inertia):
    """Return omega' from H' = 0: the rate of H in the body's axes is H x omega."""
    inertia = np.asarray(inertia)
    return np.cross(inertia * omega, omega) / inertia


def attitude_rate(R, omega):
    """Return dR/dt: every row of R, an axis of space seen from the body, turns backwards."""
    return np.cross(R, omega)


def energy(omega, *, inertia):
    return 0.5 * np.sum(inertia * omega**2)


def angular_momentum(R, omega, *, inertia):
    return np.sum([moment * w * axis for moment, w, axis in zip(inertia, omega, R.T, strict=True)], axis=0)


def euler_rates_313(angles, omega):
    """Solve with the columns that are omega, in body components, for unit rates of psi, theta and phi."""
    _, theta, phi = angles
    x, _, z = np.eye(3)
    after_phi = turned(-phi * z)
    return np.linalg.solve(np.column_stack([after_phi @ turned(-theta * x) @ z, after_phi @ x, z]), omega)


def motion(t, R, omega, *, inertia):
    """Return omegas and rotations of any body, with errors of 1e-11 of their size at most."""
    A, B, C = map(float, inertia)

    def rates(_, state):
        """Return H x omega, and the rates of the rows of R, which turn backwards, in plain floats, which are fast."""
        p, q, r, *R = state.tolist()
        turns = [turn for x, y, z in (R[:3], R[3:6], R[6:]) for turn in (y * r - z * q, z * p - x * r, x * q - y * p)]
        return (B - C) * q * r / A, (C - A) * r * p / B, (A - B) * p * q / C, *turns

    states = solve(rates, t, np.append(omega, R), method="python")
    return states[:, :3], states[:, 3:].reshape(-1, 3, 3)


def carlson(x, y, z):
    """Return R_F(x, y, z), at most one of them zero, by duplication (Numer. Math. 33, 1979; DLMF 19.36.1)."""
    mean = (x + y + z) / 3
    while max(abs(mean - x), abs(mean - y), abs(mean - z)) > ALIKE * mean:
        root = math.sqrt(x * y) + math.sqrt(y * z) + math.sqrt(z * x)
        x, y, z = (x + root) / 4, (y + root) / 4, (z + root) / 4
        mean = (x + y + z) / 3
    X, Y = 1 - x / mean, 1 - y / mean
    Z = -X - Y
    second, third = X * Y - Z * Z, X * Y * Z
    return (1 - second / 10 + third / 14 + second**2 / 24 - 3 * second * third / 44) / math.sqrt(mean)


def first_kind(phi, m):
    """Return F(phi | m)."""
    half_turns = round(phi / math.pi)
    c, s = math.cos(phi - half_turns * math.pi), math.sin(phi - half_turns * math.pi)
    return s * carlson(c * c, c * c + (1 - m) * s * s, 1.0) + 2 * half_turns * carlson(0.0, 1 - m, 1.0)


def amplitude(u, m):
    """Return am(u | m) by Gauss's mean, from its end back (Abramowitz and Stegun 16.4)."""
    a, b, ratios = 1.0, math.sqrt(1 - m), []
    while a - b > 1e-15 * a:
        a, b, difference = (a + b) / 2, math.sqrt(a * b), (a - b) / 2
        ratios.append(difference / a)
    phi = 2 ** len(ratios) * a * u
    for ratio in reversed(ratios):
        phi = (phi + np.arcsin(ratio * np.sin(phi))) / 2
    return phi


def tumble(t, R, omega, *, inertia):
    """Return omegas in elliptic functions for three inertias, dn about the axis they circle; rotations of `motion`."""
    order = np.argsort(inertia)
    if np.sum((inertia * omega) ** 2) < 2 * energy(omega, inertia=inertia) * np.median(inertia):
        order = order[::-1]
    (A, B, C), (p, q, r) = inertia[order], omega[order]
    first, last = B * (C - B) / (A * (C - A)), B * (B - A) / (C * (C - A))  # p^2 + first q^2 and r^2 + last q^2 stay
    a, c = math.sqrt(p**2 + first * q**2), math.copysign(math.sqrt(r**2 + last * q**2), r)
    b, handedness = a / math.sqrt(first), np.linalg.det(np.eye(3)[order])
    rate, m = handedness * (C - A) / B * a * c / b, last * (b / c) ** 2
    phi = amplitude(first_kind(math.atan2(q / b, p / a), m) + rate * (t - t[0]), m)
    omegas = np.column_stack([a * np.cos(phi), b * np.sin(phi), c * np.sqrt(1 - m * np.sin(phi) ** 2)])
    omegas = omegas[:, np.argsort(order)]
    return omegas, motion(t, R, omega, inertia=inertia)[1]


def symmetric_solution(t, omega, *, inertia):
    """Turn the part of omega across the axis at (C/A - 1) omega_3."""
    A, _, C = inertia
    across = (omega[0] + 1j * omega[1]) * np.exp(1j * (C / A - 1) * omega[2] * (t - t[0]))
    return np.column_stack([across.real, across.imag, np.full(len(t), omega[2])])


def wobble_rate(omega, *, inertia):
    """Return how fast the symmetry axis e, which moves at omega x e, goes round H."""
    H, e = inertia * omega, np.array([0.0, 0.0, 1.0])
    return np.linalg.norm(H) * np.linalg.norm(np.cross(omega, e)) / np.linalg.norm(np.cross(H, e))


def growth_rate_squared(axis, spin, *, inertia):
    """Return the square of the rate at which deviations of the next axis grow."""
    omega, other = spin * np.eye(3)[axis], (axis + 1) % 3
    rows = [(np.cross(inertia * d, omega) + np.cross(inertia * omega, d)) / inertia for d in np.eye(3)]
    return np.linalg.matrix_power(rows, 2)[other, other]


def tumble_period(omega, *, inertia):
    """Return 4 K(k) over the rate, by Carlson's integral; for pure spin the period of small oscillations."""
    A, B, C = inertia
    p, q, r = np.square(omega)
    beside = B * (B - A) * (C - B) * q
    round_first, round_last = A * (B - A) * p, C * (C - B) * r
    smaller, larger = (C - A) * abs(round_last - round_first), beside + (C - A) * max(round_first, round_last)
    return 4 * math.sqrt(A * B * C) * carlson(0.0, smaller, larger) if smaller else math.inf
