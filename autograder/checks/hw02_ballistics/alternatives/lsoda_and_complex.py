"""Show that the plane as complex numbers passes, LSODA, and markers at every eighth time."""

import cmath
import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root_scalar


def state_derivative(t, state, *, mass, drag, gravity):
    return np.r_[state[2], state[3], -drag / mass * state[2], -drag / mass * state[3] - gravity]


def simulate(t, speed, angle, *, mass, drag, gravity):
    def rates(_, state):
        return [state[2], state[3], -drag / mass * state[2], -drag / mass * state[3] - gravity]

    start = [0, 0, speed * np.cos(angle), speed * np.sin(angle)]
    return solve_ivp(rates, (t[0], t[-1]), start, method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9).y.T


def phi(n, z):
    """phi_n(z), the mean of e^(z (1 - u)) u^(n - 1)/(n - 1)! over 0 < u < 1."""
    if abs(z) < 1:
        return sum(z**j / math.factorial(j + n) for j in range(20))
    return (np.exp(z) - 1) / z if n == 1 else (np.exp(z) - 1 - z) / z**2


def trajectory(t, speed, angle, *, mass, drag, gravity):
    start, fall = cmath.rect(speed, angle), -1j * gravity
    rows = []
    for ti in t:
        z = -drag / mass * ti
        r = start * ti * phi(1, z) + fall * ti**2 * phi(2, z)
        v = start * np.exp(z) + fall * ti * phi(1, z)
        rows.append((r.real, r.imag, v.real, v.imag))
    return rows


def flight_time(speed, angle, *, mass, drag, gravity):
    vy = speed * math.sin(angle)

    def height(t):
        return vy * phi(1, -drag / mass * t) - gravity * t * phi(2, -drag / mass * t)

    free = 2 * vy / gravity
    return root_scalar(height, bracket=(free / 2.01, free * (1 + 1e-12)), xtol=1e-15 * free, rtol=1e-14).root


def horizontal_range(speed, angle, *, mass, drag, gravity):
    t = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return np.float64(speed * math.cos(angle) * t * phi(1, -drag / mass * t))


def best_angle(speed, *, mass, drag, gravity):
    """From the duration s of the best flight, which determines b = c vy/(m g) and then c v/(m g) explicitly."""
    target = drag * speed / (mass * gravity)

    def surplus(log_s):
        s = math.exp(log_s)
        b = s * phi(2, -s) / phi(1, -s)
        return math.log(b * b * math.exp(-s) + b * (s - b)) + s - 2 * math.log(target)

    if target < 1e-7:
        return np.pi / 4
    s = math.exp(root_scalar(surplus, bracket=(math.log(target) - 25 if target < 1 else -5, 4)).root)
    return np.arcsin(s * phi(2, -s) / phi(1, -s) / target)


def limit_shape(angle):
    corner = cmath.exp(1j * angle)
    return np.array([0, corner, corner.real], complex).view(float).reshape(3, 2)


def plot_comparison(ax, t, speed, angle, *, mass, drag, gravity):
    known = {"mass": mass, "drag": drag, "gravity": gravity}
    fine = np.linspace(t[0], t[-1], 1001)
    ax.plot(*np.array(trajectory(fine, speed, angle, **known)).T[:2])
    ax.plot(*simulate(t, speed, angle, **known)[::8].T[:2], "rx")
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


def free_body_diagram(state, *, mass, drag, gravity):
    x, y, vx, vy = state
    return [[[x, y], [0, -mass * gravity]], [[x, y], [-drag * vx, -drag * vy]]]
