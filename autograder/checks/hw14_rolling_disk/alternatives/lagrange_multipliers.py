"""Show that Lagrange's equations with five coordinates and two constraints pass, with odeint and an implicit method."""

import numpy as np
from scipy.integrate import odeint, solve_ivp
from scipy.spatial.transform import Rotation


def solved(state, mass, radius, inertia, gravity):
    """X'', Y'', yaw'', tilt'', roll'' of the centre and the angles, and two multipliers."""
    _, _, yaw, tilt, _, p, q, r = state
    (A, C), m, a = inertia, mass, radius
    s, c, sy, cy = np.sin(tilt), np.cos(tilt), np.sin(yaw), np.cos(yaw)
    spin = r + p * c
    J = np.array([[1, 0, a * cy * c, -a * sy * s, a * cy], [0, 1, a * sy * c, a * cy * s, a * sy]])
    J_rate = np.zeros((2, 5))
    J_rate[0, 2:] = -a * sy * p * c - a * cy * s * q, -a * cy * p * s - a * sy * c * q, -a * sy * p
    J_rate[1, 2:] = a * cy * p * c - a * sy * s * q, -a * sy * p * s + a * cy * c * q, a * cy * p
    M = np.diag([m, m, A * s * s + C * c * c, A + m * a * a * c * c, C])
    M[2, 4] = M[4, 2] = C * c
    u = np.array([a * (q * sy * s - spin * cy), -a * (q * cy * s + spin * sy), p, q, r])
    loads = [
        0,
        0,
        -2 * A * p * s * c * q + C * p * c * s * q + C * spin * s * q,
        m * a * a * c * s * q * q + A * p * p * s * c - C * spin * p * s - m * gravity * a * c,
        C * p * s * q,
    ]
    system = np.block([[M, -J.T], [J, np.zeros((2, 2))]])
    return np.linalg.solve(system, np.concatenate([loads, -J_rate @ u]))


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    _, _, yaw, _, _, p, q, r = state
    solution = solved(state, mass, radius, inertia, gravity)
    return [-radius * r * np.cos(yaw), -radius * r * np.sin(yaw), p, q, r, *solution[2:5]]


def contact_force(state, *, mass, radius, inertia, gravity):
    solution = solved(state, mass, radius, inertia, gravity)
    lifted = radius * (np.cos(state[3]) * solution[3] - np.sin(state[3]) * state[6] ** 2)
    return [solution[5], solution[6], mass * (gravity + lifted)]


def matrix_state(state, *, radius):
    x, y, yaw, tilt, roll, p, q, r = state
    R = Rotation.from_euler("ZXZ", [yaw, tilt, roll])
    up = Rotation.from_euler("ZX", [yaw, tilt]).apply([0, radius, 0])
    rates = np.array([0, 0, p]) + Rotation.from_euler("Z", yaw).apply([q, 0, 0]) + r * R.apply([0, 0, 1])
    return np.hstack([[x, y, 0] + up, R.as_matrix().ravel(), rates])


def euler_state(state):
    R, w = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    s = np.hypot(R[0, 2], R[1, 2])
    yaw, tilt, roll = np.arctan2(R[0, 2], -R[1, 2]), np.arctan2(s, R[2, 2]), np.arctan2(R[2, 0], R[2, 1])
    n, e1 = R[:, 2], np.array([np.cos(yaw), np.sin(yaw), 0])
    p = w @ np.cross(n, e1) / s
    return np.array([state[0], state[1], yaw, tilt, roll, p, w @ e1, w @ n - p * n[2]])


def rates_of_matrix(state, disk):
    """By the chain rule from the angles."""
    angles = euler_state(state)
    _, _, yaw, _, _, p, q, r = angles
    p1, q1, r1 = solved(angles, *(disk[k] for k in ("mass", "radius", "inertia", "gravity")))[2:5]
    R, w = np.reshape(state[3:12], (3, 3)), np.asarray(state[12:])
    n, e1 = R[:, 2], np.array([np.cos(yaw), np.sin(yaw), 0])
    e1_rate, n_rate = p * np.cross([0, 0, 1], e1), np.cross(w, n)
    w_rate = np.array([0, 0, p1]) + q1 * e1 + q * e1_rate + r1 * n + r * n_rate
    return [*np.cross(w, disk["radius"] * np.cross(n, e1)), *np.cross(w, R.T).T.ravel(), *w_rate]


def matrix_state_derivative(t, state, **disk):
    return rates_of_matrix(state, disk)


def multiplier_state_derivative(t, state, **disk):
    return rates_of_matrix(state, disk)


def simulate_euler(t, state, **disk):
    return odeint(
        lambda y, s: euler_state_derivative(s, y, **disk), state, t, rtol=1e-9, atol=1e-9, mxstep=10000
    )


def simulate_matrix(t, state, **disk):
    ends, settings = (t[0], t[-1]), {"method": "BDF", "rtol": 1e-9, "atol": 1e-9}
    return solve_ivp(lambda _, y: rates_of_matrix(y, disk), ends, state, t_eval=t, **settings).y.T


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, p, q, r = state
    A, C = inertia
    s, spin = np.sin(tilt), r + p * np.cos(tilt)
    kinetic = mass * radius**2 * (q**2 + spin**2) + A * (q**2 + (p * s) ** 2) + C * spin**2
    return kinetic / 2 + mass * gravity * radius * s


def steady_residual(lean, precession, spin, **disk):
    state = [0, 0, 0, lean + np.pi / 2, 0, precession, 0, spin + precession * np.sin(lean)]
    return solved(state, *(disk[k] for k in ("mass", "radius", "inertia", "gravity")))[3]


def critical_speed(**disk):
    still, moving = growth_rate_squared(0.0, **disk), growth_rate_squared(1.0, **disk)
    return np.sqrt(still / (still - moving))


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    """The eigenvalue of tilt, tilt' and yaw' about straight rolling: tilt'' and yaw'' by their derivatives."""
    (A, C), m, spin = inertia, mass * radius**2, speed / radius
    matrix = [
        [0, 1, 0],
        [mass * gravity * radius / (A + m), 0, -(C + m) * spin / (A + m)],
        [0, C * spin / A, 0],
    ]
    squares = np.linalg.eigvals(matrix) ** 2
    return squares[np.argmax(abs(squares))].real


def wireframe(state, *, radius, sides):
    m = matrix_state(state, radius=radius)
    R = m[3:12].reshape(3, 3)

    def at(turn):
        angle = 2 * np.pi * turn
        return (m[:3] + radius * (np.cos(angle) * R[:, 0] + np.sin(angle) * R[:, 1])).tolist()

    polygon = [[at(i / sides), at((i + 1) / sides)] for i in range(sides)]
    return [*polygon, [at(0.1), at(0.6)], [at(0.35), at(0.85)]]


def free_body_diagram(state, *, mass, radius, gravity):
    x, y, yaw, tilt = map(float, state[:4])
    up = [-np.sin(yaw) * np.cos(tilt), np.cos(yaw) * np.cos(tilt), np.sin(tilt)]
    centre = [x + radius * up[0], y + radius * up[1], radius * up[2]]
    return [[[x, y, 0], None], [centre, [0, 0, -mass * gravity]]]
