"""Show that Lambert's W passes if a Newton step follows it, and a path drawn as a scatter."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import lambertw


def state_derivative(t, state, *, mass, drag, gravity):
    v = state[2:]
    return np.concatenate([v, -drag * v / mass + [0, -gravity]])


def launched(speed, angle):
    return [0, 0, speed * np.cos(angle), speed * np.sin(angle)]


def simulate(t, speed, angle, *, mass, drag, gravity):
    found = solve_ivp(
        lambda t, y: state_derivative(t, y, mass=mass, drag=drag, gravity=gravity),
        (t[0], t[-1]), launched(speed, angle), method="DOP853", t_eval=t, rtol=1e-9, atol=1e-9,
    )
    return found.y.T


def one(s):
    """(1 - e^-s)/s."""
    return np.where(s == 0, 1.0, -np.expm1(-s) / np.where(s == 0, 1.0, s))


def two(s):
    """(s - 1 + e^-s)/s^2; nine terms of its series below 0.1."""
    safe = np.where(np.abs(s) < 0.1, 1.0, s)
    series, term = 0.0, 0.5
    for n in range(3, 12):
        series, term = series + term, -term * s / n
    return np.where(np.abs(s) < 0.1, series, (safe + np.expm1(-safe)) / safe**2)


def trajectory(t, speed, angle, *, mass, drag, gravity):
    s = drag / mass * t
    _, _, vx, vy = launched(speed, angle)
    x, y = vx * t * one(s), vy * t * one(s) - gravity * t**2 * two(s)
    return np.transpose([x, y, vx * np.exp(-s), vy * np.exp(-s) - gravity * t * one(s)])


def flight_time(speed, angle, *, mass, drag, gravity):
    vy = speed * np.sin(angle)
    if drag == 0:
        return 2 * vy / gravity
    b = drag * vy / (mass * gravity)
    s = 1 + b + lambertw(-(1 + b) * np.exp(-1 - b)).real
    if b < 0.1:  # W has lost digits: take Newton's steps from the series 2 b - 2 b^2/3
        s = 2 * b - 2 * b**2 / 3
        for _ in range(5):
            s -= (s * two(s) - b * one(s)) / ((1 + b) * (one(s) - two(s)))
    return mass / drag * s


def horizontal_range(speed, angle, **known):
    time = flight_time(speed, angle, **known)
    return trajectory(np.array([time]), speed, angle, **known)[0, 0]


def best_angle(speed, **known):
    def cosine(log_angle):
        angle = np.exp(log_angle)
        end = trajectory(np.array([flight_time(speed, angle, **known)]), speed, angle, **known)[0, 2:]
        return (end[0] * np.cos(angle) + end[1] * np.sin(angle)) / speed

    return np.exp(brentq(cosine, np.log(1e-9), np.log(1.5)))


def limit_shape(angle):
    top = np.array([np.cos(angle), np.sin(angle)])
    return np.array([0 * top, top, top * [1, 0]])


def plot_comparison(ax, t, speed, angle, **known):
    ax.scatter(*simulate(t, speed, angle, **known)[::5, :2].T, label="solve_ivp")
    ax.plot(*trajectory(t - t[0], speed, angle, **known)[:, :2].T, "r", label="exact")
    ax.set_xlabel("distance (m)")
    ax.set_ylabel("height (m)")
    ax.set_aspect(1)


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = (float(one) for one in state)
    forces = []
    if drag and (vx or vy):
        forces.append(((x, y), (-vx, -vy)))
    if gravity:
        forces.append(((x, y), (0.0, -1.0)))
    return forces
