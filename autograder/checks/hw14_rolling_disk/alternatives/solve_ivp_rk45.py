"""Show that RK45 at 1e-9 passes for both motions, with matrices in NumPy."""

import numpy as np
from scipy.integrate import solve_ivp


def axes(state):
    yaw, tilt = state[2], state[3]
    e1 = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    axle = np.array([np.sin(yaw) * np.sin(tilt), -np.cos(yaw) * np.sin(tilt), np.cos(tilt)])
    return e1, np.cross(axle, e1), axle


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, p, q, r = state
    A, C = inertia
    s, c, m = np.sin(tilt), np.cos(tilt), mass * radius**2
    # mass matrix and right side for (yaw'', tilt'', roll'') about e1, e2, e3
    matrix = np.array([[0, A + m, 0], [A * s, 0, 0], [(C + m) * c, 0, C + m]])
    spin = r + p * c
    right = np.array(
        [
            A * p * p * s * c - (C + m) * p * s * spin - mass * gravity * radius * c,
            q * (C * spin - 2 * A * p * c),
            (C + m) * p * q * s + m * p * q * s,
        ]
    )
    second = np.linalg.solve(matrix, right)
    return np.array([-radius * r * np.cos(yaw), -radius * r * np.sin(yaw), p, q, r, *second])


def cross_matrix(v):
    return np.array([np.cross(v, e) for e in np.eye(3)]).T


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    R, w = np.reshape(state[3:12], (3, 3)), np.array(state[12:])
    A, C = inertia
    n, z = R @ [0, 0, 1], np.array([0, 0, 1])
    arm = radius * (z - n[2] * n) / np.sqrt(1 - n[2] ** 2)
    up = arm / radius
    frame_rate = w - n * (w @ n) + n * n[2] * (w @ up) / up[2]
    arm_rate = np.cross(frame_rate, arm)
    tensor = R @ np.diag([A, A, C]) @ R.T
    matrix = tensor - mass * cross_matrix(arm) @ cross_matrix(arm)
    right = -np.cross(w, tensor @ w) - mass * np.cross(arm, np.cross(w, arm_rate) + gravity * z)
    return np.concatenate([np.cross(w, arm), (cross_matrix(w) @ R).ravel(), np.linalg.solve(matrix, right)])


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    R, w = np.reshape(state[3:12], (3, 3)), np.array(state[12:])
    A, C = inertia
    n, z = R[:, 2], np.array([0, 0, 1])
    s = np.sqrt(n[0] ** 2 + n[1] ** 2)
    arm = radius * (z - n[2] * n) / s
    n_rate = np.cross(w, n)
    s_rate = -n[2] * n_rate[2] / s
    arm_rate = radius * (-n_rate[2] * n - n[2] * n_rate) / s - arm * s_rate / s
    tensor = A * np.eye(3) + (C - A) * np.outer(n, n)
    # constraint G u = 0 in u = (v, omega), G = (1, skew(arm)); Schur complement for the multipliers
    G = np.hstack([np.eye(3), cross_matrix(arm)])
    inverse = np.block([[np.eye(3) / mass, np.zeros((3, 3))], [np.zeros((3, 3)), np.linalg.inv(tensor)]])
    loads = np.concatenate([-mass * gravity * z, -np.cross(w, tensor @ w)])
    constraint_rate = np.cross(arm_rate, w)
    multipliers = -np.linalg.solve(G @ inverse @ G.T, G @ inverse @ loads + constraint_rate)
    u_rate = inverse @ (loads + G.T @ multipliers)
    return np.concatenate([np.cross(w, arm), (cross_matrix(w) @ R).ravel(), u_rate[3:]])


def matrix_state(state, *, radius):
    e1, e2, e3 = axes(state)
    yaw, tilt, roll = state[2:5]

    def about_z(a):
        return np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])

    about_x = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    R = about_z(yaw) @ about_x @ about_z(roll)
    omega = state[5] * np.array([0, 0, 1]) + state[6] * e1 + state[7] * e3
    return np.concatenate([[state[0], state[1], 0] + radius * e2, R.flatten(), omega])


def simulated(rates, t, state, disk):
    return solve_ivp(
        lambda time, y: rates(time, y, **disk),
        (t[0], t[-1]),
        state,
        t_eval=t,
        method="RK45",
        rtol=1e-9,
        atol=1e-9,
    ).y.T


def simulate_euler(t, state, **disk):
    return simulated(euler_state_derivative, t, state, disk)


def simulate_matrix(t, state, **disk):
    return simulated(matrix_state_derivative, t, state, disk)


def energy(state, *, mass, radius, inertia, gravity):
    A, C = inertia
    m = matrix_state(state, radius=radius)
    w = m[3:12].reshape(3, 3).T @ m[12:]
    v = np.cross(m[12:], radius * axes(state)[1])
    return (A * w[0] ** 2 + A * w[1] ** 2 + C * w[2] ** 2 + mass * v @ v) / 2 + mass * gravity * m[2]


def contact_force(state, *, mass, radius, inertia, gravity):
    m = matrix_state(state, radius=radius)
    w, (e1, e2, _) = m[12:], axes(state)
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    alpha = matrix_state_derivative(0, m, **disk)[12:]
    e2_rate = np.cross(state[5] * np.array([0, 0, 1]) + state[6] * e1, e2)
    acceleration = radius * (np.cross(alpha, e2) + np.cross(w, e2_rate))
    return mass * (acceleration + [0, 0, gravity])


def steady_residual(lean, precession, spin, **disk):
    tilt = lean + np.pi / 2
    return euler_state_derivative(
        0, [0, 0, 0, tilt, 0, precession, 0, spin - precession * np.cos(tilt)], **disk
    )[6]


def critical_speed(*, mass, radius, inertia, gravity):
    A, C = inertia
    return np.sqrt(mass * gravity * radius**3 * A / (C * (C + mass * radius**2)))


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    A, C = inertia
    m = mass * radius**2
    return (mass * gravity * radius * A - C * (C + m) * (speed / radius) ** 2) / (A * (A + m))


def wireframe(state, *, radius, sides):
    m = matrix_state(state, radius=radius)
    R = m[3:12].reshape(3, 3)
    still = np.array([np.cos(state[2]), np.sin(state[2]), 0])  # along the ground: the polygon need not roll
    up = np.cross(R[:, 2], still)
    angles = np.linspace(0.3, 0.3 - 2 * np.pi, sides + 1)
    rim = [m[:3] + radius * (np.cos(a) * still + np.sin(a) * up) for a in angles]
    aslant = [R[:, 0] + R[:, 1], R[:, 0] - R[:, 1]]
    across = [[m[:3] + radius / 2**0.5 * d, m[:3] - radius / 2**0.5 * d] for d in aslant]
    return [*zip(rim[1:], rim[:-1], strict=True), *across]


def free_body_diagram(state, *, mass, radius, gravity):
    x, y, yaw, tilt = map(float, state[:4])
    up = [-np.sin(yaw) * np.cos(tilt), np.cos(yaw) * np.cos(tilt), np.sin(tilt)]
    centre = [x + radius * up[0], y + radius * up[1], radius * up[2]]
    return [[[x, y, 0], None], [centre, [0, 0, -mass * gravity]]]
