"""Right: Lambert's W away from its branch point and Newton next to it, the range maximised over the logarithm of the angle."""
import math

import matplotlib.pyplot as plt  # noqa: F401
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def state_derivative(t, state, *, mass, drag, gravity):
    x, y, vx, vy = state
    return [vx, vy, -drag / mass * vx, -drag / mass * vy - gravity]


def simulate(t, speed, angle, *, mass, drag, gravity):
    start = [0, 0, speed * np.cos(angle), speed * np.sin(angle)]
    sol = solve_ivp(
        lambda s, z: state_derivative(s, z, mass=mass, drag=drag, gravity=gravity),
        [t[0], t[-1]],
        start,
        method="DOP853",
        t_eval=t,
        rtol=1e-9,
        atol=1e-9,
    )
    return np.transpose(sol.y)


def _phi1(z):
    return math.expm1(z) / z if z else 1.0


def _phi2(z):
    if abs(z) > 0.5:
        return (math.expm1(z) - z) / z**2
    term, total = 0.5, 0.0
    for k in range(3, 30):
        total += term
        term *= z / k
    return total


def trajectory(t, speed, angle, *, mass, drag, gravity):
    k, vx, vy = drag / mass, speed * math.cos(angle), speed * math.sin(angle)
    rows = []
    for s in t:
        z = -k * s
        p1, p2 = _phi1(z), _phi2(z)
        rows.append(
            (
                vx * s * p1,
                vy * s * p1 - gravity * s * s * p2,
                vx * math.exp(z),
                vy * math.exp(z) - gravity * s * p1,
            )
        )
    return rows


def horizontal_range(speed, angle, *, mass, drag, gravity):
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * time * _phi1(-drag / mass * time)


def limit_shape(angle):
    c, s = np.cos(angle), np.sin(angle)
    return [(0, 0), (c, s), (c, 0)]


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    params = {"mass": mass, "drag": drag, "gravity": gravity}
    a = np.array(simulate(t, speed, angle, **params))
    b = np.array(trajectory(t - t[0], speed, angle, **params))
    ax.plot(a[:, 0], a[:, 1], label="numerical")
    ax.plot(b[:, 0], b[:, 1], "--", label="closed form")
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")
    ax.axis("equal")
    ax.legend()

from scipy.optimize import minimize_scalar
from scipy.special import lambertw


def flight_time(speed, angle, *, mass, drag, gravity):
    vy, k = speed * math.sin(angle), drag / mass
    a = k * vy / gravity
    if a < 1e-2:  # Newton on y = 0 from the parabola
        s = 2 * vy / gravity
        for _ in range(20):
            p1, p2 = _phi1(-k * s), _phi2(-k * s)
            y = vy * s * p1 - gravity * s * s * p2
            s -= y / (vy * math.exp(-k * s) - gravity * s * p1)
        return s
    u = 1 + a  # kT = u (1 - e^-kT)
    return (u + lambertw(-u * math.exp(-u)).real) / k


def best_angle(speed, *, mass, drag, gravity):
    res = minimize_scalar(
        lambda q: -horizontal_range(speed, math.exp(q), mass=mass, drag=drag, gravity=gravity),
        bounds=(math.log(1e-9), math.log(math.pi / 2)), method="bounded", options={"xatol": 1e-10},
    )
    return math.exp(res.x)


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = state
    return [[[x, y], [0, -mass * gravity]], [[x, y], [-drag * vx, -drag * vy]]]
