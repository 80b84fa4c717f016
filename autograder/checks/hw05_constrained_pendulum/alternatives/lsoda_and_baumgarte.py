"""Show that LSODA with Baumgarte's stabilisation passes without projection."""

import numpy as np
from scipy.integrate import solve_ivp


def _solved(state, mass, length, gravity):
    x, y, vx, vy = state
    A = np.array([[mass, 0, -x], [0, mass, -y], [x, y, 0]])
    ax, ay, pull = np.linalg.solve(A, [0, -mass * gravity, -vx * vx - vy * vy])
    return np.array([ax, ay]), pull * np.array([x, y])


def constraint_force(state, *, mass, length, gravity):
    return _solved(state, mass, length, gravity)[1]


def acceleration(state, *, mass, length, gravity):
    return _solved(state, mass, length, gravity)[0]


def consistent_state(state, *, length):
    r, v = state[:2], state[2:]
    if not np.any(r):
        raise ValueError("at the origin")
    r = length * r / np.hypot(*r)
    return np.append(r, v - r * (r @ v) / length**2)


def energy(state, *, mass, gravity):
    x, y, vx, vy = state
    return 0.5 * mass * (vx**2 + vy**2) + mass * gravity * y


def simulate(t, state, *, mass, length, gravity):
    b = 2 * (np.sqrt(gravity / length) + np.hypot(*state[2:]) / length)

    def f(s, q):
        x, y, vx, vy = q
        rr, rv, vv = x * x + y * y, x * vx + y * vy, vx * vx + vy * vy
        pull = (gravity * y - vv - 2 * b * rv - b * b * (rr - length**2) / 2) / rr
        return vx, vy, pull * x, pull * y - gravity

    return solve_ivp(f, (t[0], t[-1]), state, method="LSODA", t_eval=t, rtol=1e-11, atol=1e-12).y.T


def wireframe(state, *, length):
    return np.array([[np.zeros(2), state[:2]]])


def free_body_diagram(state, *, mass, length, gravity):
    x, y = state[0], state[1]
    return [[[x, y], [x / length, y / length]], [[x, y], [0, -mass * gravity]]]
