"""Show that Lie-group steps of a fixed size pass, and a period by quadrature."""

import math

import numpy as np
from scipy.integrate import quad

from tam570.rotations import exp, matrix_from_euler, skew, unskew


def euler_equations(omega, *, inertia):
    A, B, C = inertia
    return np.array([B - C, C - A, A - B]) / inertia * omega[[1, 2, 0]] * omega[[2, 0, 1]]


def attitude_rate(R, omega):
    return R @ skew(omega)


def euler_rates_313(angles, omega):
    _, theta, phi = angles
    s, c = np.sin(theta), np.cos(theta)
    if np.abs(s) < 1e-12:
        raise ValueError("undetermined")
    inverse = np.array([[np.sin(phi), np.cos(phi), 0], [s * np.cos(phi), -s * np.sin(phi), 0], [-c * np.sin(phi), -c * np.cos(phi), s]])
    return inverse @ omega / s


def energy(omega, *, inertia):
    return np.dot(omega, np.multiply(inertia, omega)) / 2


def angular_momentum(R, omega, *, inertia):
    return R.dot(inertia * omega)


def step(p, q, r, h, a, b, c):
    """RK4 for Euler's equations, in plain numbers; a = (B - C)/A and so on."""
    k1, l1, m1 = a * q * r, b * r * p, c * p * q
    x, y, z = p + h / 2 * k1, q + h / 2 * l1, r + h / 2 * m1
    k2, l2, m2 = a * y * z, b * z * x, c * x * y
    x, y, z = p + h / 2 * k2, q + h / 2 * l2, r + h / 2 * m2
    k3, l3, m3 = a * y * z, b * z * x, c * x * y
    x, y, z = p + h * k3, q + h * l3, r + h * m3
    k4, l4, m4 = a * y * z, b * z * x, c * x * y
    return (
        p + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4),
        q + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4),
        r + h / 6 * (m1 + 2 * m2 + 2 * m3 + m4),
    )


def simulate(t, R, omega, *, inertia):
    A, B, C = (float(x) for x in inertia)
    ratios = (B - C) / A, (C - A) / B, (A - B) / C
    w = tuple(float(x) for x in omega)
    speed = math.hypot(*w) * max(1.0, max(inertia) / min(inertia)) ** 0.5 + 1e-300
    omegas, rotations = [w], [np.array(R)]
    for start, end in zip(t[:-1], t[1:]):
        n = max(2, math.ceil((end - start) * speed / 0.02))
        h = (end - start) / n
        nodes = [w]
        for _ in range(2 * n):
            w = step(*w, h / 2, *ratios)
            nodes.append(w)
        nodes = np.array(nodes)
        first, middle, last = nodes[:-1:2], nodes[1::2], nodes[2::2]
        turns = h / 6 * (first + 4 * middle + last) + h * h / 12 * np.cross(first, last)
        R = rotations[-1]
        for turn in exp(turns):
            R = R @ turn
        omegas.append(w)
        rotations.append(R)
    return np.array(omegas), np.array(rotations)


def symmetric_solution(t, omega, *, inertia):
    rate = (inertia[2] / inertia[1] - 1) * omega[2]
    turns = matrix_from_euler("313", np.outer(rate * (np.asarray(t) - t[0]), [1, 0, 0]))
    return turns @ omega


def wobble_rate(omega, *, inertia):
    A = inertia[0]
    return math.sqrt(sum((I / A * w) ** 2 for I, w in zip(inertia, omega)))


def growth_rate_squared(axis, spin, *, inertia):
    spinning = spin * np.eye(3)[axis]
    h = 1e-5
    j, k = (axis + 1) % 3, (axis + 2) % 3
    slope_j = euler_equations(spinning + h * np.eye(3)[k], inertia=inertia)[j] / h
    slope_k = euler_equations(spinning + h * np.eye(3)[j], inertia=inertia)[k] / h
    return slope_j * slope_k


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    p, q, r = omega**2
    last, first = C * (C - B) * r, A * (B - A) * p
    a2 = B * (B - A) * (C - B) * q + (C - A) * max(first, last)
    b2 = (C - A) * abs(last - first)
    if b2 == 0:
        return math.inf
    # Gauss's integral, cut where it is steep
    value = quad(lambda x: 1 / math.sqrt(a2 * math.cos(x) ** 2 + b2 * math.sin(x) ** 2), 0, math.pi / 2,
                 points=[math.pi / 2 - c * math.sqrt(b2 / a2) for c in (1, 10, 100) if c * math.sqrt(b2 / a2) < 1.5] or None,
                 epsabs=0, epsrel=1e-10, limit=400)[0]
    return 4 * math.sqrt(A * B * C) * value


def wireframe(R, *, size):
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) - 0.5
    pairs = [(i, i | bit) for bit in (1, 2, 4) for i in range(8) if not i & bit]
    places = (corners * size) @ np.transpose(R)
    return [[places[i], places[j]] for i, j in pairs]


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    fine = np.linspace(t[0], t[-1], 500)
    _, y, z = radius * simulate(fine, R, omega, inertia=inertia)[1].transpose(1, 2, 0)
    ax.plot(y[0], z[0], "b-", y[1], z[1], "r--")
    ax.set_aspect(1)
    ax.set_xlabel("space y (m)")
    ax.set_ylabel("space z (m)")
