"""Show that a method that keeps the constraint by construction passes: RATTLE, composed to fourth order."""

import math

import numpy as np

CUBE = 2 ** (1 / 3)
WEIGHTS = (1 / (2 - CUBE), -CUBE / (2 - CUBE), 1 / (2 - CUBE))


def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    n = -mass * (vx * vx + vy * vy) / length + mass * gravity * y / length
    return n * x / length, n * y / length


def acceleration(state, *, mass, length, gravity):
    fx, fy = constraint_force(state, mass=mass, length=length, gravity=gravity)
    return [fx / mass, fy / mass - gravity]


def consistent_state(state, *, length):
    x, y, vx, vy = map(float, state)
    d = math.sqrt(x * x + y * y)
    if d == 0.0:
        raise ValueError
    u = (x * vx + y * vy) / d**2
    return [length * x / d, length * y / d, vx - u * x, vy - u * y]


def energy(state, *, mass, gravity):
    return mass * (math.hypot(state[2], state[3]) ** 2 / 2 + gravity * state[1])


def _rattle(x, y, vx, vy, h, length, gravity):
    # the point of the circle next to r + h v + h^2 a/2 along the old radius
    px, py = x + h * vx, y + h * vy - h * h * gravity / 2
    b, c = (px * x + py * y) / length, px * px + py * py - length**2
    s = c / (b + math.sqrt(b * b - c))
    nx, ny = px - s * x / length, py - s * y / length
    wx, wy = (nx - x) / h, (ny - y) / h - h * gravity / 2
    u = (wx * nx + wy * ny) / length**2
    return nx, ny, wx - u * nx, wy - u * ny


def simulate(t, state, *, mass, length, gravity):
    rate = math.hypot(state[2], state[3]) / length + math.sqrt(gravity / length)
    q = tuple(state)
    rows = [q]
    for span in np.diff(t):
        steps = math.ceil(span * rate / 0.02)
        for _ in range(steps):
            for w in WEIGHTS:
                q = _rattle(*q, w * span / steps, length, gravity)
        rows.append(q)
    return rows


def wireframe(state, *, length):
    return np.array([[0.0, 0.0], state[:2]])[None]


def free_body_diagram(state, *, mass, length, gravity):
    at = tuple(map(float, state[:2]))
    forces = [(at, (0.0, -1.0))] if gravity else []
    return [*forces, (at, (-at[0], -at[1]))]
