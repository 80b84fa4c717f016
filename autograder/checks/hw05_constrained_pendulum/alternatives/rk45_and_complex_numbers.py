"""Show that the plane as complex numbers passes, RK45 at 1e-9 on position and rate of turning."""

import numpy as np
from scipy.integrate import solve_ivp


def constraint_force(state, *, mass, length, gravity):
    r, v = complex(*state[:2]), complex(*state[2:])
    n = r / length
    pull = -mass * abs(v) ** 2 / length + mass * gravity * n.imag
    return np.array([(pull * n).real, (pull * n).imag])


def acceleration(state, *, mass, length, gravity):
    r, v = complex(*state[:2]), complex(*state[2:])
    a = -gravity * r.real / length**2 * 1j * r - abs(v) ** 2 / length**2 * r
    return a.real, a.imag


def consistent_state(state, *, length):
    r, v = complex(*state[:2]), complex(*state[2:])
    if r == 0:
        raise ValueError("the origin")
    n = r / abs(r)
    v = 1j * n * (v * n.conjugate()).imag
    return [length * n.real, length * n.imag, v.real, v.imag]


def energy(state, *, mass, gravity):
    return mass * abs(complex(*state[2:])) ** 2 / 2 + mass * gravity * state[1]


def simulate(t, state, *, mass, length, gravity):
    x, y, vx, vy = state

    def f(s, q):
        return [-q[2] * q[1], q[2] * q[0], -gravity / length * q[0]]

    start = [x / length, y / length, (x * vy - y * vx) / length**2]
    a, b, w = solve_ivp(f, (t[0], t[-1]), start, method="RK45", t_eval=t, rtol=1e-9, atol=1e-9).y
    n = (a + 1j * b) / abs(a + 1j * b)
    v = 1j * n * w
    return length * np.column_stack([n.real, n.imag, v.real, v.imag])


def wireframe(state, *, length):
    return np.reshape([0, 0, state[0], state[1]], (1, 2, 2))


def free_body_diagram(state, *, mass, length, gravity):
    x, y = state[0], state[1]
    return [[[x, y], [x / length, y / length]], [[x, y], [0, -mass * gravity]]]
