"""Right: a multiplier, DOP853 at 1e-9 with every row put back on the circle, lists and tuples."""
import matplotlib.pyplot as plt  # noqa: F401
import numpy as np
from scipy.integrate import solve_ivp


def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    lam = mass * (gravity * y - vx**2 - vy**2) / length**2
    return [lam * x, lam * y]


def acceleration(state, *, mass, length, gravity):
    fx, fy = constraint_force(state, mass=mass, length=length, gravity=gravity)
    return (fx / mass, fy / mass - gravity)


def consistent_state(state, *, length):
    r, v = np.array(state[:2]), np.array(state[2:])
    d = np.hypot(*r)
    if d == 0:
        raise ValueError("no nearest point")
    n = r / d
    return [*(length * n), *(v - (v @ n) * n)]


def energy(state, *, mass, gravity):
    return mass * (state[2] ** 2 + state[3] ** 2) / 2 + mass * gravity * state[1]


def simulate(t, state, *, mass, length, gravity):
    def rhs(_, s):
        # the radius there is, not the one there should be: then no spurious tangential force
        r = np.hypot(s[0], s[1])
        ax, ay = acceleration(s, mass=mass, length=r, gravity=gravity)
        return [s[2], s[3], ax, ay]

    sol = solve_ivp(rhs, (t[0], t[-1]), state, method="DOP853", t_eval=t, rtol=1e-9, atol=1e-9)
    return [state] + [consistent_state(row, length=length) for row in sol.y.T[1:]]


def wireframe(state, *, length):
    return [[(0, 0), (state[0], state[1])]]


def free_body_diagram(state, *, mass, length, gravity):
    at = tuple(map(float, state[:2]))
    forces = [(at, (0.0, -1.0))] if gravity else []
    return [*forces, (at, (-at[0], -at[1]))]
