"""Right: RK45 at rtol 1e-9, atol 1e-9 on the state, by the given length; the rows are put back onto the circle."""

import numpy as np
from scipy.integrate import solve_ivp

def constraint_force(state, *, mass, length, gravity):
    r, v = state[:2], state[2:]
    multiplier = mass * (gravity * r[1] - v @ v) / length**2
    return multiplier * r

def acceleration(state, *, mass, length, gravity):
    F = constraint_force(state, mass=mass, length=length, gravity=gravity)
    return F / mass + np.array([0, -gravity])

def consistent_state(state, *, length):
    r, v = state[:2], state[2:]
    d = np.linalg.norm(r)
    if d == 0:
        raise ValueError("no direction at the origin")
    u = r / d
    return np.concatenate([length * u, v - (v @ u) * u])

def energy(state, *, mass, gravity):
    x, y, vx, vy = state
    return 0.5 * mass * (vx**2 + vy**2) + mass * gravity * y

def simulate(t, state, *, mass, length, gravity):
    def rates(_, s):
        return np.concatenate([s[2:], acceleration(s, mass=mass, length=length, gravity=gravity)])
    sol = solve_ivp(rates, (t[0], t[-1]), state, t_eval=t, rtol=1e-9, atol=1e-9)
    out = np.array([consistent_state(s, length=length) for s in sol.y.T])
    out[0] = state
    return out

def wireframe(state, *, length):
    return np.array([[[0, 0], state[:2]]])


def free_body_diagram(state, *, mass, length, gravity):
    at = tuple(map(float, state[:2]))
    forces = [(at, (0.0, -1.0))] if gravity else []
    return [*forces, (at, (-at[0], -at[1]))]
