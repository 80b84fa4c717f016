"""Show that fixed Runge-Kutta steps pass, and a best angle from the slope of the range."""

import math

import numpy as np
from scipy.optimize import brentq


def state_derivative(t, state, *, mass, drag, gravity):
    force = -drag * np.asarray(state[2:]) - np.array([0.0, mass * gravity])
    return np.append(state[2:], force / mass)


def simulate(t, speed, angle, **known):
    rows = [np.array([0.0, 0.0, speed * math.cos(angle), speed * math.sin(angle)])]
    for start, end in zip(t[:-1], t[1:], strict=True):
        steps = math.ceil((end - start) * (1 + known["drag"] / known["mass"]) / 0.05)
        y, h = rows[-1], (end - start) / steps
        for _ in range(steps):
            k1 = state_derivative(0, y, **known)
            k2 = state_derivative(0, y + h / 2 * k1, **known)
            k3 = state_derivative(0, y + h / 2 * k2, **known)
            k4 = state_derivative(0, y + h * k3, **known)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        rows.append(y)
    return np.array(rows)


@np.vectorize
def lost(s):
    """1 - e^-s."""
    return -math.expm1(-s)


@np.vectorize
def lag(s):
    """s - (1 - e^-s), of which s^2/2 is the beginning."""
    if s > 0.3 or s < -0.3:
        return s - lost(s)
    return math.fsum((-1) ** n * s**n / math.factorial(n) for n in range(2, 18))


def trajectory(t, speed, angle, *, mass, drag, gravity):
    vx, vy = speed * math.cos(angle), speed * math.sin(angle)
    if drag == 0:
        return np.column_stack([vx * t, vy * t - gravity * t**2 / 2, vx + 0 * t, vy - gravity * t])
    tau = mass / drag
    s = t / tau
    x, y = vx * tau * lost(s), vy * tau * lost(s) - gravity * tau**2 * lag(s)
    return np.column_stack([x, y, vx * np.exp(-s), vy * np.exp(-s) - gravity * tau * lost(s)])


def flight_time(speed, angle, *, mass, drag, gravity):
    vy = speed * math.sin(angle)
    if drag == 0:
        return 2 * vy / gravity
    b = drag * vy / (mass * gravity)
    s = brentq(lambda s: (b * lost(s) - lag(s)) / s, b, min(2 * b, 1 + b) * (1 + 1e-12), xtol=1e-15 * b)
    return s * mass / drag


def horizontal_range(speed, angle, *, mass, drag, gravity):
    t = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * (t if drag == 0 else mass / drag * float(lost(drag * t / mass)))


def best_angle(speed, *, mass, drag, gravity):
    def slope(log_angle):
        """d(range)/d(angle) over the range, from T' = vy'/g (1 - e^-s)/(1 - (1 + b) e^-s)."""
        angle = math.exp(log_angle)
        t = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
        vx, vy = speed * math.cos(angle), speed * math.sin(angle)
        _, _, end_x, end_y = trajectory(np.array([t]), speed, angle, mass=mass, drag=drag, gravity=gravity)[0]
        return (vx * end_x + vy * end_y) / speed**2

    return math.exp(brentq(slope, math.log(1e-10), math.log(1.57), xtol=1e-12))


def limit_shape(angle):
    return [[0.0, 0.0], [math.cos(angle), math.sin(angle)], [math.cos(angle), 0.0]]


def plot_comparison(ax, t, speed, angle, **known):
    for how in (simulate, trajectory):
        states = how(t, speed, angle, **known)
        ax.plot(states[:, 0], states[:, 1], label=how.__name__)
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")
    ax.set_aspect("equal", adjustable="datalim")


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = state
    return [[[x, y], [0, -mass * gravity]], [[x, y], [-drag * vx, -drag * vy]]]
