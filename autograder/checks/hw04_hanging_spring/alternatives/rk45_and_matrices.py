"""Right: RK45 at rtol 1e-9, atol 1e-9, the closed form by complex exponentials, the projection by rotation matrices."""

import numpy as np
from scipy.integrate import solve_ivp


def _system(mass, stiffness, gravity):
    A = np.zeros((6, 6))
    A[:3, 3:] = np.eye(3)
    A[3:, :3] = -stiffness / mass * np.eye(3)
    return A, np.array([0, 0, 0, 0, 0, -gravity])


def state_derivative(t, state, *, mass, stiffness, gravity):
    A, b = _system(mass, stiffness, gravity)
    return A @ state + b


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    A, b = _system(mass, stiffness, gravity)
    sol = solve_ivp(lambda s, y: A @ y + b, (t[0], t[-1]), np.r_[position, velocity], rtol=1e-9, atol=1e-9, dense_output=True)
    return sol.sol(t).T


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    rest = np.array([0, 0, -gravity / w**2])
    z = (position - rest - 1j * velocity / w) * np.exp(1j * w * np.asarray(t))[:, None]
    return np.hstack([rest + z.real, -w * z.imag])


def energy(state, *, mass, stiffness, gravity):
    rest = np.array([0, 0, -mass * gravity / stiffness])
    r, v = state[:3] - rest, state[3:]
    return (mass * v @ v + stiffness * r @ r - stiffness * rest @ rest) / 2


def orbit(position, velocity, *, mass, stiffness, gravity):
    rest = np.array([0, 0, -gravity / (stiffness / mass)])
    conjugate = np.column_stack([position - rest, velocity * np.sqrt(mass / stiffness)])
    values, vectors = np.linalg.eigh(conjugate.T @ conjugate)
    return rest, (conjugate @ vectors[:, ::-1]).T


def project(points, azimuth, elevation):
    c, s = np.cos(azimuth), np.sin(azimuth)
    turned = points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]).T
    c, s = np.cos(elevation), np.sin(elevation)
    return turned @ np.array([[0, 1, 0], [-s, 0, c]]).T


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    states = simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    ax.plot(*project(states[:, :3], azimuth, elevation).T, label="path")
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
    ax.legend()


def free_body_diagram(state, *, mass, stiffness, gravity):
    r = tuple(map(float, state[:3]))
    forces = [(r, (0.0, 0.0, -1.0))]
    return forces + [(r, tuple(-one for one in r))] if any(r) else forces
