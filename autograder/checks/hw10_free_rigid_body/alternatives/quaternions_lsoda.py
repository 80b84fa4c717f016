"""Show that plain Python passes: quaternions, LSODA, lists and tuples, a period by ellipkm1."""

import math

from scipy.integrate import solve_ivp
from scipy.special import ellipkm1

from tam570.rotations import matrix_from_quaternion, quaternion_from_matrix


def euler_equations(omega, *, inertia):
    (p, q, r), (A, B, C) = omega, inertia
    return [(B - C) * q * r / A, (C - A) * r * p / B, (A - B) * p * q / C]


def attitude_rate(R, omega):
    p, q, r = omega
    return [[b * r - c * q, c * p - a * r, a * q - b * p] for a, b, c in R]


def euler_rates_313(angles, omega):
    psi, theta, phi = angles
    if abs(math.sin(theta)) < 1e-12:
        raise ValueError("sin theta = 0")
    across = omega[0] * math.sin(phi) + omega[1] * math.cos(phi)
    return (
        across / math.sin(theta),
        omega[0] * math.cos(phi) - omega[1] * math.sin(phi),
        omega[2] - across * math.cos(theta) / math.sin(theta),
    )


def energy(omega, *, inertia):
    return sum(I * w**2 for I, w in zip(inertia, omega)) / 2


def angular_momentum(R, omega, *, inertia):
    return [sum(a * I * w for a, I, w in zip(row, inertia, omega)) for row in R]


def simulate(t, R, omega, *, inertia):
    def rhs(t, y):
        p, q, r, a, b, c, d = y
        return [
            *euler_equations((p, q, r), inertia=inertia),
            (-b * p - c * q - d * r) / 2,
            (a * p + c * r - d * q) / 2,
            (a * q + d * p - b * r) / 2,
            (a * r + b * q - c * p) / 2,
        ]

    start = [*omega, *quaternion_from_matrix(R)]
    y = solve_ivp(rhs, (t[0], t[-1]), start, method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9).y
    return y[:3].T.tolist(), matrix_from_quaternion(y[3:].T).tolist()


def symmetric_solution(t, omega, *, inertia):
    A, _, C = inertia
    rows = []
    for time in t:
        angle = (1 - C / A) * omega[2] * (time - t[0])
        c, s = math.cos(angle), math.sin(angle)
        rows.append((omega[0] * c + omega[1] * s, -omega[0] * s + omega[1] * c, omega[2]))
    return rows


def wobble_rate(omega, *, inertia):
    p, q, r = omega
    return math.sqrt(p * p + q * q + (inertia[2] / inertia[0] * r) ** 2)


def growth_rate_squared(axis, spin, *, inertia):
    I = inertia[axis]
    J, K = (inertia[i] for i in range(3) if i != axis)
    return -(I - J) * (I - K) / (J * K) * spin * spin


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    p, q, r = (w * w for w in omega)
    to_separatrix = C * (C - B) * r - A * (B - A) * p
    if to_separatrix == 0:
        return math.inf
    if to_separatrix > 0:
        a2 = (C - B) * (B * (B - A) * q + C * (C - A) * r)
    else:
        a2 = (B - A) * (A * (C - A) * p + B * (C - B) * q)
    return 4 * ellipkm1((C - A) * abs(to_separatrix) / a2) * math.sqrt(A * B * C / a2)


def wireframe(R, *, size):
    def corner(signs):
        return tuple(sum(a * s * l / 2 for a, s, l in zip(row, signs, size)) for row in R)

    edges = []
    for u in (1, -1):
        for v in (1, -1):
            edges.append((corner((1, u, v)), corner((-1, u, v))))
            edges.append((corner((u, -1, v)), corner((u, 1, v))))
            edges.append((corner((u, v, 1)), corner((u, v, -1))))
    return edges


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    rotations = simulate(t, R, omega, inertia=inertia)[1][::2]
    for k in (0, 1):
        ax.plot([radius * M[1][k] for M in rotations], [radius * M[2][k] for M in rotations])
    ax.axis("equal")
    ax.set(xlabel="y (m)", ylabel="z (m)")
