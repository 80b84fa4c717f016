"""Right: unknown accelerations and side force from numpy.linalg.solve; RK45; growth by differences, (d) by quad; lists."""

import math

import numpy as np
from scipy.integrate import quad, solve_ivp

AXLES = {"front": lambda a, b: (a, -b), "rear": lambda a, b: (-b, a)}  # locked, free; forward of G


def positions(locked, front, rear):
    try:
        return AXLES[locked](front, rear)
    except KeyError:
        raise ValueError(locked)


def axle_load(locked, *, mass, front, rear, gravity):
    a, b = positions(locked, front, rear)
    return float(np.linalg.solve([[1, 1], [a, b]], [mass * gravity, 0])[0])


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    a, b = positions(locked, front, rear)
    angle = math.atan2((a - b) * state[4], state[3])
    size = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    if state[3] == 0 and state[4] == 0:
        return [0, 0]
    return [-size * math.cos(angle), -size * math.sin(angle)]


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    a, b = positions(locked, front, rear)
    f, g = friction_force(state, locked, mass=mass, front=front, rear=rear, friction=friction, gravity=gravity)
    _, _, th, u, r = state
    v = -b * r
    # unknowns u', v', r', side force S
    A = [[mass, 0, 0, 0], [0, mass, 0, -1], [0, 0, yaw_inertia, -b], [0, 1, b, 0]]
    du, dv, dr, S = np.linalg.solve(A, [f + mass * r * v, g - mass * r * u, a * g, 0])
    return [u * math.cos(th) - v * math.sin(th), u * math.sin(th) + v * math.cos(th), r, du, dr]


def simulate(t, state, locked, **car):
    energy = lambda s: kinetic_energy(s, locked, **{k: car[k] for k in ("mass", "yaw_inertia", "front", "rear")})
    start = energy(state)
    if start == 0:
        return [list(state) for _ in t]
    rest = lambda _, s: energy(s) / start - 1e-10
    rest.terminal = True
    f = lambda _, s: state_derivative(0, s, locked, **car)
    run = solve_ivp(f, (t[0], t[-1]), state, rtol=1e-9, atol=1e-9, events=rest, dense_output=True)
    rows = []
    for now in t:
        row = run.sol(min(now, run.t[-1])).tolist()
        if now > run.t[-1]:
            row[3] = row[4] = 0
        rows.append(row)
    return rows


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    _, b = positions(locked, front, rear)
    V = np.array([state[3], -b * state[4], state[4]])
    return V @ np.diag([mass, mass, yaw_inertia]) @ V / 2


def yaw_growth_rate(speed, locked, **car):
    e = 1e-4 * speed / (car["front"] + car["rear"])
    f = lambda r: state_derivative(0, [0, 0, 0, speed, r], locked, **car)[4]
    return (f(e) - f(-e)) / (2 * e)


def critical_speed(locked, *, front, rear, friction, gravity):
    positions(locked, front, rear)
    return {"front": np.inf, "rear": (friction * gravity * (rear + front)) ** 0.5}[locked]


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    N = axle_load(locked, **{k: car[k] for k in ("mass", "front", "rear", "gravity")})
    slowing = -car["friction"] * N / car["mass"]
    exponent = quad(lambda u: yaw_growth_rate(u, locked, **car) / slowing, speed0, speed, epsabs=1e-9, epsrel=1e-9)[0]
    return yaw_rate0 * math.exp(exponent)


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
