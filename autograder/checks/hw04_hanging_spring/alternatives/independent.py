"""Right: the ellipse by the angle of its axes, RK45 at 1e-9, the path drawn as a scatter."""
import matplotlib.pyplot as plt  # noqa: F401
import numpy as np
from scipy.integrate import solve_ivp


def state_derivative(t, state, *, mass, stiffness, gravity):
    r, v = np.array(state[:3]), np.array(state[3:])
    return np.concatenate([v, -stiffness / mass * r - np.array([0, 0, gravity])])


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    sol = solve_ivp(
        lambda s, z: state_derivative(s, z, mass=mass, stiffness=stiffness, gravity=gravity),
        (t[0], t[-1]), [*position, *velocity], t_eval=t, rtol=1e-9, atol=1e-9,
    )
    return sol.y.T


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    c = np.array([0, 0, -mass * gravity / stiffness])
    rows = []
    for s in t:
        r = c + (position - c) * np.cos(w * s) + velocity / w * np.sin(w * s)
        v = velocity * np.cos(w * s) - w * (position - c) * np.sin(w * s)
        rows.append([*r, *v])
    return rows


def energy(state, *, mass, stiffness, gravity):
    x, y, z, a, b, c = state
    return mass * (a * a + b * b + c * c) / 2 + stiffness * (x * x + y * y + z * z) / 2 + mass * gravity * z


def project(points, azimuth, elevation):
    sa, ca, se, ce = np.sin(azimuth), np.cos(azimuth), np.sin(elevation), np.cos(elevation)
    return [(-sa * x + ca * y, -se * ca * x - se * sa * y + ce * z) for x, y, z in points]


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    z = simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    p = np.array(project(z[:, :3], azimuth, elevation))
    ax.scatter(p[::8, 0], p[::8, 1])
    ax.set_xlabel("right (m)")
    ax.set_ylabel("up (m)")
    ax.set_aspect("equal", adjustable="datalim")


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    a, b = position - centre, velocity * np.sqrt(mass / stiffness)
    s = 0.5 * np.arctan2(2 * a @ b, a @ a - b @ b)
    p, q = a * np.cos(s) + b * np.sin(s), b * np.cos(s) - a * np.sin(s)
    return centre, ((p, q) if p @ p >= q @ q else (q, p))


def free_body_diagram(state, *, mass, stiffness, gravity):
    r = tuple(map(float, state[:3]))
    forces = [(r, (0.0, 0.0, -1.0))]
    return forces + [(r, tuple(-one for one in r))] if any(r) else forces
