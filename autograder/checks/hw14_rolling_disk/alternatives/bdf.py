"""Show that an implicit method (BDF) passes, and multipliers from a linear system."""

import numpy as np
from scipy.integrate import solve_ivp

Z = np.array([0.0, 0.0, 1.0])


def frame(yaw, tilt):
    sy, cy, s, c = np.sin(yaw), np.cos(yaw), np.sin(tilt), np.cos(tilt)
    e1 = np.array([cy, sy, 0.0])
    e3 = np.array([sy * s, -cy * s, c])
    e2 = np.array([-sy * c, cy * c, s])
    return e1, e2, e3


def rates123(tilt, p, q, w3, mass, radius, inertia, gravity):
    A, C = inertia
    k = mass * radius**2
    s, c = np.sin(tilt), np.cos(tilt)
    r = q * c / s
    dp = (A * r * q - (C + k) * q * w3 - mass * gravity * radius * c) / (A + k)
    dq = (C * p * w3 - A * r * p) / A
    dw = k * p * q / (C + k)
    return dp, dq, dw


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, dyaw, dtilt, droll = state
    s, c = np.sin(tilt), np.cos(tilt)
    q, w3 = dyaw * s, droll + dyaw * c
    dp, dq, dw = rates123(tilt, dtilt, q, w3, mass, radius, inertia, gravity)
    ddyaw = (dq - dyaw * c * dtilt) / s
    ddroll = dw - ddyaw * c + dyaw * s * dtilt
    contact = [-radius * droll * np.cos(yaw), -radius * droll * np.sin(yaw)]
    return np.array([*contact, dyaw, dtilt, droll, ddyaw, dp, ddroll])


def body(R):
    e3 = R[:, 2]
    s = np.hypot(e3[0], e3[1])
    e1 = np.cross(Z, e3) / s
    return e1, np.cross(e3, e1), e3


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    state = np.asarray(state, float)
    R, w = state[3:12].reshape(3, 3), state[12:]
    e1, e2, e3 = body(R)
    A, C = inertia
    tensor = A * np.eye(3) + (C - A) * np.outer(e3, e3)
    s, c = e2[2], e3[2]
    de3 = np.cross(w, e3)
    dc = de3[2]
    ds = -c * dc / s
    de2 = (-dc * e3 - c * de3) / s - e2 * ds / s
    K = tensor + mass * radius**2 * (np.eye(3) - np.outer(e2, e2))
    rhs = -np.cross(w, tensor @ w) - mass * radius * np.cross(e2, radius * np.cross(w, de2) + gravity * Z)
    dw = np.linalg.solve(K, rhs)
    return np.concatenate([np.cross(w, radius * e2), (skew(w) @ R).ravel(), dw])


def skew(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0.0]])


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    state = np.asarray(state, float)
    R, w = state[3:12].reshape(3, 3), state[12:]
    e1, e2, e3 = body(R)
    A, C = inertia
    tensor = R @ np.diag([A, A, C]) @ R.T
    p, q, cot = w @ e1, w @ e2, e3[2] / e2[2]
    fr = p * e1 + q * e2 + q * cot * e3
    de2 = np.cross(fr, e2)
    J = np.hstack([np.eye(3), radius * skew(e2)])  # v + a e2 x w = 0
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = mass * np.eye(3), tensor
    KKT = np.block([[M, -J.T], [J, np.zeros((3, 3))]])
    b = np.concatenate([-mass * gravity * Z, -np.cross(w, tensor @ w), radius * np.cross(w, de2)])
    sol = np.linalg.solve(KKT, b)
    return np.concatenate([np.cross(w, radius * e2), (skew(w) @ R).ravel(), sol[3:6]])


def matrix_state(state, *, radius):
    x, y, yaw, tilt, roll, dyaw, dtilt, droll = state
    e1, e2, e3 = frame(yaw, tilt)
    Rf = np.column_stack([e1, e2, e3])
    cr, sr = np.cos(roll), np.sin(roll)
    R = Rf @ np.array([[cr, -sr, 0], [sr, cr, 0], [0, 0, 1.0]])
    w = dtilt * e1 + dyaw * Z + droll * e3
    return np.concatenate([np.array([x, y, 0.0]) + radius * e2, R.ravel(), w])


def motion(rates, t, state, disk):
    found = solve_ivp(
        lambda s, y: rates(s, y, **disk), (t[0], t[-1]), state, t_eval=t, rtol=1e-9, atol=1e-9, method="BDF"
    )
    return found.y.T


def simulate_euler(t, state, **disk):
    return motion(euler_state_derivative, t, state, disk)


def simulate_matrix(t, state, **disk):
    return motion(matrix_state_derivative, t, state, disk)


def energy(state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, dyaw, dtilt, droll = state
    A, C = inertia
    q, w3 = dyaw * np.sin(tilt), droll + dyaw * np.cos(tilt)
    k = mass * radius**2
    return 0.5 * ((A + k) * dtilt**2 + A * q**2 + (C + k) * w3**2) + mass * gravity * radius * np.sin(tilt)


def contact_force(state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, dyaw, dtilt, droll = state
    s, c = np.sin(tilt), np.cos(tilt)
    q, w3, p = dyaw * s, droll + dyaw * c, dtilt
    r = dyaw * c
    dp, dq, dw = rates123(tilt, p, q, w3, mass, radius, inertia, gravity)
    e1, e2, e3 = frame(yaw, tilt)
    a = radius * ((-dw + q * p) * e1 - (r * w3 + p * p) * e2 + (dp + q * w3) * e3)
    return mass * (a + gravity * Z)


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    return rates123(lean + np.pi / 2, 0.0, precession * np.cos(lean), spin, mass, radius, inertia, gravity)[0]


def critical_speed(*, mass, radius, inertia, gravity):
    A, C = inertia
    return np.sqrt(mass * gravity * radius**3 * A / (C * (C + mass * radius**2)))


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    A, C = inertia
    k = mass * radius**2
    return (mass * gravity * radius - C * (C + k) / A * (speed / radius) ** 2) / (A + k)


def wireframe(state, *, radius, sides):
    m = matrix_state(state, radius=radius)
    G, R = m[:3], m[3:12].reshape(3, 3)
    th = 2 * np.pi * np.arange(sides + 1) / sides
    rim = G + radius * (np.outer(np.cos(th), R[:, 0]) + np.outer(np.sin(th), R[:, 1]))
    seg = [[rim[i], rim[i + 1]] for i in range(sides)]
    seg.append([G - radius * R[:, 0], G + radius * R[:, 0]])
    seg.append([G - radius * R[:, 1], G + radius * R[:, 1]])
    return np.array(seg)


def free_body_diagram(state, *, mass, radius, gravity):
    x, y, yaw, tilt = (float(one) for one in state[:4])
    up = [-np.sin(yaw) * np.cos(tilt), np.cos(yaw) * np.cos(tilt), np.sin(tilt)]
    centre = [x + radius * up[0], y + radius * up[1], radius * up[2]]
    return [[[x, y, 0], None], [centre, [0, 0, -mass * gravity]]]
