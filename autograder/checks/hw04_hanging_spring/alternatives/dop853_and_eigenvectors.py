"""Right: solve_ivp DOP853 at rtol 1e-9, atol 1e-9, the ellipse from the eigenvectors of Fradkin's tensor."""

import numpy as np
from scipy.integrate import solve_ivp


def state_derivative(t, state, *, mass, stiffness, gravity):
    r, v = state[:3], state[3:]
    force = -stiffness * r + mass * gravity * np.array([0, 0, -1])
    return np.concatenate([v, force / mass])


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    start = np.concatenate([position, velocity])
    found = solve_ivp(
        lambda s, y: state_derivative(s, y, mass=mass, stiffness=stiffness, gravity=gravity),
        (t[0], t[-1]), start, method="DOP853", t_eval=t, rtol=1e-9, atol=1e-9,
    )
    return found.y.T


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    rest = np.array([0, 0, -mass * gravity / stiffness])
    c, s = np.cos(w * t), np.sin(w * t)
    r = rest + np.outer(c, position - rest) + np.outer(s, velocity / w)
    v = -w * np.outer(s, position - rest) + np.outer(c, velocity)
    return np.hstack([r, v])


def energy(state, *, mass, stiffness, gravity):
    r, v = state[:3], state[3:]
    return mass / 2 * v @ v + stiffness / 2 * r @ r + mass * gravity * r[2]


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -gravity / np.sqrt(stiffness / mass) ** 2])
    r = position - centre
    values, vectors = np.linalg.eigh(np.outer(r, r) + mass / stiffness * np.outer(velocity, velocity))
    lengths = np.sqrt(np.maximum(values, 0))
    return centre, np.array([lengths[2] * vectors[:, 2], lengths[1] * vectors[:, 1]])


def project(points, azimuth, elevation):
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    up = np.array([-np.sin(elevation) * np.cos(azimuth), -np.sin(elevation) * np.sin(azimuth), np.cos(elevation)])
    return np.column_stack([points @ right, points @ up])


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    path = project(simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)[:, :3], azimuth, elevation)
    ax.plot(path[:, 0], path[:, 1])
    ax.set_aspect("equal")
    ax.set_xlabel("horizontal (m)")
    ax.set_ylabel("vertical (m)")


def free_body_diagram(state, *, mass, stiffness, gravity):
    x, y, z = [float(one) for one in state[:3]]
    return [[[x, y, z], [-stiffness * x, -stiffness * y, -stiffness * z]], [[x, y, z], [0, 0, -mass * gravity]]]
