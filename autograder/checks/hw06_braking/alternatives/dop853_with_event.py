"""Show that a stop found by an event passes."""

import math

import numpy as np
from scipy.integrate import solve_ivp


def geometry(locked, front, rear):
    if locked == "front":
        return rear, front  # the free axle is behind G
    if locked == "rear":
        return front, rear
    raise ValueError("locked must be front or rear")


def axle_load(locked, *, mass, front, rear, gravity):
    d, _ = geometry(locked, front, rear)
    return mass * gravity * d / (front + rear)


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    N = axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    l = front + rear
    v = np.array([state[3], l * state[4] if locked == "front" else -l * state[4]])
    size = np.linalg.norm(v)
    return np.zeros(2) if size == 0 else -friction * N * v / size


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    d, q = geometry(locked, front, rear)
    sign = 1 if locked == "front" else -1
    F1, F2 = friction_force(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    x, y, th, u, om = state
    w = sign * d * om
    udot = F1 / mass + sign * d * om**2
    omdot = (sign * (d + q) * F2 - sign * mass * d * u * om) / (yaw_inertia + mass * d**2)
    return np.array([u * np.cos(th) - w * np.sin(th), u * np.sin(th) + w * np.cos(th), om, udot, omdot])


def simulate(t, state, locked, **car):
    l = car["front"] + car["rear"]
    geometry(locked, car["front"], car["rear"])

    def stopped(_, s):
        return np.hypot(s[3], l * s[4]) - 1e-6

    stopped.terminal = True
    run = solve_ivp(
        lambda s, y: state_derivative(s, y, locked, **car), (t[0], t[-1]), state,
        method="DOP853", rtol=1e-9, atol=1e-9, t_eval=t, events=stopped,
    )
    states = np.empty((len(t), 5))
    n = run.y.shape[1]
    states[:n] = run.y.T
    if n < len(t):
        states[n:] = run.y_events[0][0]
        states[n:, 3:] = 0
    return states


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    d, _ = geometry(locked, front, rear)
    return 0.5 * mass * (state[3] ** 2 + (d * state[4]) ** 2) + 0.5 * yaw_inertia * state[4] ** 2


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    d, _ = geometry(locked, front, rear)
    sign, l = (-1 if locked == "front" else 1), front + rear
    return (sign * mass * d * speed - friction * mass * gravity * d * l / speed) / (yaw_inertia + mass * d**2)


def critical_speed(locked, *, front, rear, friction, gravity):
    geometry(locked, front, rear)
    return math.inf if locked == "front" else np.sqrt(friction * gravity * (front + rear))


def small_yaw_rate(speed, speed0, yaw_rate0, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    d, _ = geometry(locked, front, rear)
    J, l = yaw_inertia + mass * d**2, front + rear
    sign = -1 if locked == "front" else 1
    return yaw_rate0 * (speed / speed0) ** (mass * l**2 / J) * np.exp(
        sign * mass * l * (speed0**2 - speed**2) / (2 * friction * gravity * J)
    )


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    if locked not in ("front", "rear"):
        raise ValueError("locked")
    x, y, heading, speed, yaw_rate = (float(one) for one in state)
    c, s = np.cos(heading), np.sin(heading)
    free, other = (-rear, front) if locked == "front" else (front, -rear)
    lateral = (other - free) * yaw_rate
    slide = [speed * c - lateral * s, speed * s + lateral * c]
    size = friction * mass * gravity
    drag = [[x + other * c, y + other * s], [-size * slide[0], -size * slide[1]]]
    return [drag, [[x + free * c, y + free * s], [s, -c]]]
