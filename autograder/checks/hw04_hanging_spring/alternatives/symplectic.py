"""Show that a symplectic method with fixed steps passes, and NumPy scalars as results."""

import math

import numpy as np

CUBE = 2 ** (1 / 3)
WEIGHTS = (1 / (2 - CUBE), -CUBE / (2 - CUBE), 1 / (2 - CUBE))


def _acceleration(r, mass, stiffness, gravity):
    return -stiffness / mass * r - np.array([0, 0, gravity])


def state_derivative(t, state, *, mass, stiffness, gravity):
    return (*state[3:], *_acceleration(np.array(state[:3]), mass, stiffness, gravity))


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    k, g = stiffness / mass, np.array([0, 0, gravity])
    longest = 0.02 / math.sqrt(k)
    r, v = position.copy(), velocity.copy()
    rows = [np.concatenate([r, v])]
    for span in np.diff(t):
        steps = math.ceil(span / longest)
        for _ in range(steps):
            for w in WEIGHTS:
                h = w * span / steps
                r += h / 2 * v
                v += h * (-k * r - g)
                r += h / 2 * v
        rows.append(np.concatenate([r, v]))
    return np.array(rows)


def solution(t, position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    t = np.asarray(t)[:, None]
    g = np.array([0, 0, -gravity])
    r = np.cos(k * t) * position + np.sin(k * t) * velocity / k + (1 - np.cos(k * t)) / k**2 * g
    v = np.cos(k * t) * velocity - k * np.sin(k * t) * position + np.sin(k * t) / k * g
    return np.concatenate([r, v], axis=1)


def energy(state, *, mass, stiffness, gravity):
    parts = np.square(state)
    return mass * parts[3:].sum() / 2 + stiffness * parts[:3].sum() / 2 + mass * gravity * state[2]


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = -np.array([0, 0, gravity * mass / stiffness])
    u, s, vt = np.linalg.svd(np.array([position - centre, velocity / np.sqrt(stiffness / mass)]))
    return centre, -np.diag(s) @ vt[:2]


def project(points, azimuth, elevation):
    right = (-math.sin(azimuth), math.cos(azimuth), 0)
    towards = (math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation))
    return np.transpose([np.dot(points, right), np.dot(points, np.cross(towards, right))])


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    states = simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    x, y = project(states[:, :3], azimuth, elevation).T
    ax.plot(x, y, ".-")
    ax.set_xlabel("to the right (m)")
    ax.set_ylabel("upwards (m)")
    ax.set_aspect(1)


def free_body_diagram(state, *, mass, stiffness, gravity):
    x, y, z = [float(one) for one in state[:3]]
    return [[[x, y, z], [-stiffness * x, -stiffness * y, -stiffness * z]], [[x, y, z], [0, 0, -mass * gravity]]]
