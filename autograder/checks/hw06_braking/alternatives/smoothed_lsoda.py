"""Show that friction smoothed below 0.2 mm/s passes, which LSODA carries beyond the stop."""

from math import cos, exp, hypot, inf, log, sin, sqrt

import numpy as np
from scipy.integrate import solve_ivp


def arms(locked, front, rear):
    if locked not in {"front", "rear"}:
        raise ValueError
    return (front + rear, -rear) if locked == "front" else (-(front + rear), front)


def axle_load(locked, *, mass, front, rear, gravity):
    arm, free = arms(locked, front, rear)
    return abs(free / arm) * mass * gravity


def friction_force(state, locked, *, smooth=0.0, **car):
    friction = car.pop("friction")
    N, (arm, _) = axle_load(locked, **car), arms(locked, car["front"], car["rear"])
    vx, vy = state[3], arm * state[4]
    v = sqrt(vx * vx + vy * vy + smooth**2)
    if v == 0:
        return 0.0, 0.0
    return -friction * N * vx / v, -friction * N * vy / v


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity, smooth=0.0):
    fx, fy = friction_force(
        state, locked, smooth=smooth, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity
    )
    arm, free = arms(locked, front, rear)
    th, u, r = state[2:]
    turning = (arm * fy + mass * free * u * r) / (yaw_inertia + mass * free**2)
    return (u * cos(th) + free * r * sin(th), u * sin(th) - free * r * cos(th), r, fx / mass - free * r * r, turning)


def simulate(t, state, locked, **car):
    f = lambda s, y: state_derivative(s, y, locked, smooth=2e-4, **car)
    return solve_ivp(f, (t[0], t[-1]), state, method="LSODA", t_eval=t, rtol=1e-9, atol=1e-9).y.T


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    free = arms(locked, front, rear)[1]
    return mass * hypot(state[3], free * state[4]) ** 2 / 2 + yaw_inertia * state[4] ** 2 / 2


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    arm, free = arms(locked, front, rear)
    N = axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return (mass * free * speed - friction * N * arm * arm / speed) / (yaw_inertia + mass * free**2)


def critical_speed(locked, *, front, rear, friction, gravity):
    arm, free = arms(locked, front, rear)
    return inf if free < 0 else sqrt(friction * gravity * -arm)


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    """The linear equation in ln r over the speed, by solve_ivp."""
    N = axle_load(locked, **{k: car[k] for k in ("mass", "front", "rear", "gravity")})
    a = car["friction"] * N / car["mass"]
    f = lambda u, y: [-yaw_growth_rate(u, locked, **car) / a]
    return yaw_rate0 * np.exp(solve_ivp(f, (speed0, speed), [0.0], rtol=1e-9, atol=1e-9, method="DOP853").y[0, -1])


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    (arm, free), (x, y, heading, speed, yaw_rate) = arms(locked, front, rear), state
    along, aside = np.array([[cos(heading), sin(heading)], [-sin(heading), cos(heading)]])
    axle, slide = [x, y] + free * along, speed * along + arm * yaw_rate * aside
    forces = [(axle, aside)] if yaw_rate else []  # going straight nothing pushes it sideways
    return [*forces, (axle + arm * along, -slide)] if slide.any() and friction * gravity else forces
