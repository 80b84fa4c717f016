"""Right: DOP853 at rtol 1e-9, atol 1e-9 on the Cartesian acceleration; the samples are put back onto the circle."""

import numpy as np
from scipy.integrate import solve_ivp


def constraint_force(state, *, mass, length, gravity):
    r, v = state[:2], state[2:]
    weight = np.array([0, -mass * gravity])
    return -(mass * v @ v + r @ weight) / (r @ r) * r


def acceleration(state, *, mass, length, gravity):
    return constraint_force(state, mass=mass, length=length, gravity=gravity) / mass + np.array([0, -gravity])


def consistent_state(state, *, length):
    r, v = state[:2], state[2:]
    distance = np.linalg.norm(r)
    if distance == 0:
        raise ValueError("no nearest point")
    n = r / distance
    return np.concatenate([length * n, v - (v @ n) * n])


def energy(state, *, mass, gravity):
    return mass * (state[2:] @ state[2:]) / 2 + mass * gravity * state[1]


def simulate(t, state, *, mass, length, gravity):
    def f(s, y):
        return np.concatenate([y[2:], acceleration(y, mass=mass, length=length, gravity=gravity)])

    y = solve_ivp(f, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=1e-9, atol=1e-9).y.T
    return np.array([consistent_state(row, length=length) for row in y])


def wireframe(state, *, length):
    return [[(0, 0), (state[0], state[1])]]


def free_body_diagram(state, *, mass, length, gravity):
    x, y = state[0], state[1]
    return [[[x, y], [x / length, y / length]], [[x, y], [0, -mass * gravity]]]
