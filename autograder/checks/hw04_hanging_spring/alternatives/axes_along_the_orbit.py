"""Show that axes found on a simulated orbit pass, where the distance stops changing."""

import numpy as np
from scipy.integrate import solve_ivp

def state_derivative(t, state, *, mass, stiffness, gravity):
    return np.concatenate([state[3:], -stiffness / mass * state[:3] - np.array([0, 0, gravity])])

def simulate(t, position, velocity, *, mass, stiffness, gravity):
    return solve_ivp(lambda t, s: state_derivative(t, s, mass=mass, stiffness=stiffness, gravity=gravity), (t[0], t[-1]), np.concatenate([position, velocity]), t_eval=t, rtol=1e-9, atol=1e-9).y.T

def solution(t, position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    c = np.array([0, 0, -mass * gravity / stiffness])
    C, S = np.cos(k * t)[:, None], np.sin(k * t)[:, None]
    A, B = position - c, velocity / k
    return np.hstack([c + A * C + B * S, k * (B * C - A * S)])

def energy(state, *, mass, stiffness, gravity):
    return 0.5 * mass * state[3:] @ state[3:] + 0.5 * stiffness * state[:3] @ state[:3] + mass * gravity * state[2]

def orbit(position, velocity, *, mass, stiffness, gravity):
    """Simulate a period and a bit; the axes are where the distance from the centre stops changing."""
    from scipy.optimize import brentq
    k = np.sqrt(stiffness / mass)
    c = np.array([0, 0, -mass * gravity / stiffness])
    A, B = position - c, velocity / k
    size = np.sqrt(A @ A + B @ B)
    if size <= 1e-13 * np.linalg.norm(c): return c, np.zeros((2, 3))
    if abs(A @ B) < 1e-9 * size**2:      # starts at the end of an axis already (circles too)
        return (c, np.array([A, B])) if A @ A >= B @ B else (c, np.array([B, A]))
    s = solve_ivp(lambda t, s: state_derivative(t, s, mass=mass, stiffness=stiffness, gravity=gravity), (0, 2.2 * np.pi / k), np.concatenate([position, velocity]), dense_output=True, rtol=1e-9, atol=1e-9).sol
    f = lambda t: (s(t)[:3] - c) @ s(t)[3:]
    ts = np.linspace(0, 2.2 * np.pi / k, 200)
    rows = s(ts)
    g = np.sum((rows[:3] - c[:, None]) * rows[3:], axis=0)
    found = [s(brentq(f, a, b, xtol=1e-14))[:3] - c for a, b, p, q in zip(ts, ts[1:], g, g[1:]) if p * q < 0]
    return c, np.array([max(found, key=np.linalg.norm), min(found, key=np.linalg.norm)])


def project(points, azimuth, elevation):
    ca, sa, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
    return points @ np.array([[-sa, ca, 0], [-se * ca, -se * sa, ce]]).T


def plot_projection(ax, t, position, velocity, azimuth, elevation, *, mass, stiffness, gravity):
    path = np.array([[float(q) for q in row] for row in np.asarray(simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity))])[:, :3]
    flat = np.array([[float(q) for q in row] for row in np.asarray(project(path, azimuth, elevation))])
    ax.plot(flat[:, 0], flat[:, 1])
    ax.set_xlabel("right (m)")
    ax.set_ylabel("up (m)")
    ax.set_aspect("equal")


def free_body_diagram(state, *, mass, stiffness, gravity):
    x, y, z = [float(one) for one in state[:3]]
    return [[[x, y, z], [-stiffness * x, -stiffness * y, -stiffness * z]], [[x, y, z], [0, 0, -mass * gravity]]]
