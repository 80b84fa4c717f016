"""Right: LSODA at rtol 1e-9, atol 1e-9, lists and tuples, the axes from the angle at which the distance is largest."""

import math

import numpy as np
from scipy.integrate import solve_ivp


def state_derivative(t, state, *, mass, stiffness, gravity):
    x, y, z, vx, vy, vz = state
    return [vx, vy, vz, -stiffness * x / mass, -stiffness * y / mass, -stiffness * z / mass - gravity]


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    def f(s, y):
        return state_derivative(s, y, mass=mass, stiffness=stiffness, gravity=gravity)

    out = solve_ivp(f, [t[0], t[-1]], [*position, *velocity], method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9)
    return out.y.T.tolist()


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = math.sqrt(stiffness / mass)
    rest = (0.0, 0.0, -mass * gravity / stiffness)
    rows = []
    for time in t:
        c, s = math.cos(w * time), math.sin(w * time)
        r = [e + (p - e) * c + v / w * s for p, v, e in zip(position, velocity, rest)]
        u = [v * c - (p - e) * w * s for p, v, e in zip(position, velocity, rest)]
        rows.append((*r, *u))
    return rows


def energy(state, *, mass, stiffness, gravity):
    x, y, z, vx, vy, vz = state
    return np.float64(0.5 * mass * (vx * vx + vy * vy + vz * vz) + 0.5 * stiffness * (x * x + y * y + z * z) + mass * gravity * z)


def orbit(position, velocity, *, mass, stiffness, gravity):
    rest = np.array([0, 0, -mass * gravity / stiffness])
    p, q = position - rest, velocity * math.sqrt(mass / stiffness)
    phase = 0.5 * math.atan2(2 * p @ q, p @ p - q @ q)
    first = p * math.cos(phase) + q * math.sin(phase)
    second = q * math.cos(phase) - p * math.sin(phase)
    return [list(rest), [list(first), list(second)]]


def project(points, azimuth, elevation):
    ca, sa, ce, se = math.cos(azimuth), math.sin(azimuth), math.cos(elevation), math.sin(elevation)
    return [(-sa * x + ca * y, -se * ca * x - se * sa * y + ce * z) for x, y, z in points]


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    fine = np.linspace(t[0], t[-1], 500)
    states = np.array(solution(fine - fine[0], position, velocity, mass=mass, stiffness=stiffness, gravity=gravity))
    ax.plot(*zip(*project(states[:, :3], azimuth, elevation)), "k")
    ax.axis("equal")
    ax.set_xlabel("right (m)")
    ax.set_ylabel("up (m)")


def free_body_diagram(state, *, mass, stiffness, gravity):
    x, y, z = [float(one) for one in state[:3]]
    return [[[x, y, z], [-stiffness * x, -stiffness * y, -stiffness * z]], [[x, y, z], [0, 0, -mass * gravity]]]
