"""Show that DOP853 at 1e-9 and complex exponentials pass, and axes from energy and angular momentum."""

import numpy as np
from scipy.integrate import solve_ivp


def state_derivative(t, state, *, mass, stiffness, gravity):
    force = -stiffness * np.asarray(state[:3]) - mass * np.array([0.0, 0.0, gravity])
    return np.hstack([state[3:], force / mass])


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    out = solve_ivp(
        lambda s, y: state_derivative(s, y, mass=mass, stiffness=stiffness, gravity=gravity),
        (t[0], t[-1]), np.hstack([position, velocity]), method="DOP853", t_eval=t, rtol=1e-9, atol=1e-9,
    )
    return out.y.T


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    rest = np.array([0.0, 0.0, -mass * gravity / stiffness])
    z = np.exp(-1j * w * np.asarray(t))[:, None] * (position - rest + 1j * velocity / w)
    return np.hstack([rest + z.real, w * z.imag])


def energy(state, *, mass, stiffness, gravity):
    r, v = np.asarray(state).reshape(2, 3)
    return mass * (v @ v / 2 + gravity * r[2]) + stiffness * (r @ r) / 2


def orbit(position, velocity, *, mass, stiffness, gravity):
    """A^2 + B^2 is twice the energy over the stiffness, A B the angular momentum over m w: A +- B are two roots."""
    rest = np.array([0.0, 0.0, -mass * gravity / stiffness])
    p, q = position - rest, velocity * np.sqrt(mass / stiffness)
    squares, normal = p @ p + q @ q, np.cross(p, q)
    product = np.linalg.norm(normal)
    both, gap = np.sqrt(squares + 2 * product), np.sqrt(max(squares - 2 * product, 0.0))
    phase = np.arctan2(2 * p @ q, p @ p - q @ q) / 2
    a = p * np.cos(phase) + q * np.sin(phase)
    first = a / (np.linalg.norm(a) or 1.0)
    second = np.cross(normal, first) / (product or 1.0)
    return rest, [(both + gap) / 2 * first, (both - gap) / 2 * second]


def project(points, azimuth, elevation):
    turned = (points[:, 0] + 1j * points[:, 1]) * np.exp(-1j * azimuth)
    up = points[:, 2] * np.cos(elevation) - turned.real * np.sin(elevation)
    return np.stack([turned.imag, up], axis=1)


def plot_projection(ax, t, position, velocity, azimuth, elevation, **known):
    states = simulate(t, position, velocity, **known)
    ax.plot(*project(states[:, :3], azimuth, elevation).T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")


def free_body_diagram(state, *, mass, stiffness, gravity):
    r = tuple(map(float, state[:3]))
    forces = [(r, (0.0, 0.0, -1.0))]
    return forces + [(r, tuple(-one for one in r))] if any(r) else forces
