"""Right: multipliers from one time to the next with Gram and Schmidt's R, the growth rate by differences of steady_residual."""
import numpy as np
from numpy import cos, cross, sin
from scipy.integrate import solve_ivp

Z = np.array([0.0, 0.0, 1.0])


def Rx(a):
    return np.array([[1, 0, 0], [0, cos(a), -sin(a)], [0, sin(a), cos(a)]])


def Rz(a):
    return np.array([[cos(a), -sin(a), 0], [sin(a), cos(a), 0], [0, 0, 1]])


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def _rates(state, mass, radius, inertia, gravity):
    """omega, rates of its e components, rate of the frame along e3"""
    th, dpsi, dth, dphi = state[3], state[5], state[6], state[7]
    A, C = inertia
    k = mass * radius**2
    w1, w2, w3 = dth, dpsi * sin(th), dphi + dpsi * cos(th)
    W3 = dpsi * cos(th)
    d1 = (A * W3 * w2 - (C + k) * w2 * w3 - mass * gravity * radius * cos(th)) / (A + k)
    d2 = (C * w3 - A * W3) * w1 / A
    d3 = k * w1 * w2 / (C + k)
    return (w1, w2, w3), (d1, d2, d3), W3


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    _, _, psi, th, _, dpsi, dth, dphi = state
    _, (d1, d2, d3), W3 = _rates(state, mass, radius, inertia, gravity)
    ddpsi = (d2 - W3 * dth) / sin(th)
    ddphi = d3 - ddpsi * cos(th) + dpsi * sin(th) * dth
    u = -radius * dphi
    return [u * cos(psi), u * sin(psi), dpsi, dth, dphi, ddpsi, d1, ddphi]


def _frame(axle):
    e1 = np.array([-axle[1], axle[0], 0]) / np.hypot(axle[0], axle[1])
    return e1, cross(axle, e1)


def matrix_state_derivative(t, state, *, mass, radius, inertia, gravity):
    state = np.asarray(state)
    R, w = state[3:12].reshape(3, 3), state[12:]
    e3 = R[:, 2]
    e1, e2 = _frame(e3)
    # the frame turns at z psi' + e1 th'; the axle's rate tells both
    st = np.hypot(e3[0], e3[1])
    W = (w @ e2) / st * Z + (w @ e1) * e1
    de2 = cross(W, e2)
    I = R @ np.diag([inertia[0], inertia[0], inertia[1]]) @ R.T
    lhs = I + mass * radius**2 * (np.eye(3) - np.outer(e2, e2))
    rhs = -cross(w, I @ w) - mass * radius * cross(e2, radius * cross(w, de2) + gravity * Z)
    dw = np.linalg.solve(lhs, rhs)
    return np.concatenate([radius * cross(w, e2), (hat(w) @ R).ravel(), dw])


def multiplier_state_derivative(t, state, *, mass, radius, inertia, gravity):
    R, w = np.reshape(state[3:12], (3, 3)), state[12:15]
    n = R[:, 2]
    dn = cross(w, n)
    up = Z - n[2] * n
    s = np.linalg.norm(up)
    e2 = up / s
    dup = -dn[2] * n - n[2] * dn
    de2 = (dup - (dup @ e2) * e2) / s
    r, dr = -radius * e2, -radius * de2
    I = R @ np.diag([inertia[0], inertia[0], inertia[1]]) @ R.T
    E, O = np.eye(3), np.zeros((3, 3))
    M = np.block([[mass * E, O, -E], [O, I, -hat(r)], [E, -hat(r), O]])
    b = np.concatenate([-mass * gravity * Z, -cross(w, I @ w), -cross(w, dr)])
    x = np.linalg.solve(M, b)
    return np.concatenate([cross(r, w), (hat(w) @ R).ravel(), x[3:6]])


def matrix_state(state, *, radius):
    x, y, psi, th, phi, dpsi, dth, dphi = state
    R = Rz(psi) @ Rx(th) @ Rz(phi)
    e1 = np.array([cos(psi), sin(psi), 0])
    e3 = R[:, 2]
    G = np.array([x, y, 0]) + radius * cross(e3, e1)
    return [*G, *R.flatten(), *(dpsi * Z + dth * e1 + dphi * e3)]


def simulate_euler(t, state, *, mass, radius, inertia, gravity):
    kw = dict(mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    sol = solve_ivp(
        lambda s, z: euler_state_derivative(s, z, **kw),
        (t[0], t[-1]), state, t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9,
    )
    return sol.y.T


def energy(state, *, mass, radius, inertia, gravity):
    (w1, w2, w3), _, _ = _rates(state, mass, radius, inertia, gravity)
    A, C = inertia
    kin = 0.5 * mass * radius**2 * (w1**2 + w3**2) + 0.5 * (A * (w1**2 + w2**2) + C * w3**2)
    return kin + mass * gravity * radius * sin(state[3])


def contact_force(state, *, mass, radius, inertia, gravity):
    (w1, w2, w3), (d1, d2, d3), W3 = _rates(state, mass, radius, inertia, gravity)
    acc = radius * np.array([-d3 + w2 * w1, -W3 * w3 - w1 * w1, d1 + w2 * w3])
    return mass * (Rz(state[2]) @ Rx(state[3]) @ acc + gravity * Z)


def steady_residual(lean, precession, spin, *, mass, radius, inertia, gravity):
    th = lean + np.pi / 2
    state = [0, 0, 0, th, 0, precession, 0, spin - precession * cos(th)]
    return euler_state_derivative(0, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)[6]


def wireframe(state, *, radius, sides):
    m = np.array(matrix_state(state, radius=radius))
    G, R = m[:3], m[3:12].reshape(3, 3)

    def rim(a):
        return G + radius * R @ np.array([cos(a), sin(a), 0])

    step = 2 * np.pi / sides
    lines = [(rim(i * step), rim((i + 1) * step)) for i in range(sides)]
    lines += [(rim(0), rim(np.pi)), (rim(np.pi / 2), rim(-np.pi / 2))]
    return lines


def simulate_matrix(t, state, *, mass, radius, inertia, gravity):
    "by the multipliers, from one wanted time to the next, R renewed by a QR-free Gram-Schmidt"
    kw = dict(mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    rows = [np.array(state, float)]
    for a, b in zip(t[:-1], t[1:]):
        y = solve_ivp(lambda s, z: multiplier_state_derivative(s, z, **kw), (a, b), rows[-1], rtol=1e-9, atol=1e-9).y[:, -1]
        R = y[3:12].reshape(3, 3)
        x = R[:, 0] / np.linalg.norm(R[:, 0])
        yv = R[:, 1] - (R[:, 1] @ x) * x
        yv /= np.linalg.norm(yv)
        y[3:12] = np.column_stack([x, yv, np.cross(x, yv)]).ravel()
        rows.append(y)
    return rows


def critical_speed(*, mass, radius, inertia, gravity):
    from scipy.optimize import brentq
    if gravity == 0:
        return 0.0
    f = lambda v: growth_rate_squared(v, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return brentq(f, 0, 10 * (gravity * radius) ** 0.5 * max(1, (inertia[0] / inertia[1])), xtol=1e-14)


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    "by a linearisation of steady_residual with the yaw rate that the e2 balance gives"
    A, C = inertia
    h = 1e-5
    spin = speed / radius
    # A d(omega2) = C spin d(tilt)
    f = lambda d: steady_residual(d, C / A * spin * d / cos(d), spin, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return (f(h) - f(-h)) / (2 * h)


def free_body_diagram(state, *, mass, radius, gravity):
    x, y, yaw, tilt = (float(one) for one in state[:4])
    flat = radius * np.cos(tilt)
    centre = (x - flat * np.sin(yaw), y + flat * np.cos(yaw), radius * np.sin(tilt))
    ground = [((x, y, 0.0), axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return [*ground, (centre, (0, 0, -gravity))]
