"""Show that plain Python passes: complex numbers, steps that shrink as the car slows, forces of zero left out."""

import cmath
import math


def free_axle(locked, front, rear):
    if locked == "front":
        return -rear
    if locked == "rear":
        return front
    raise ValueError(f"{locked}?")


def axle_load(locked, *, mass, front, rear, gravity):
    return mass * gravity * abs(free_axle(locked, front, rear)) / (front + rear)


def dragging_velocity(u, r, locked, front, rear):
    free_axle(locked, front, rear)
    return u + 1j * r * (front + rear) * (1 if locked == "front" else -1)


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    N = axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    v = dragging_velocity(state[3], state[4], locked, front, rear)
    F = -friction * N * v / abs(v) if v else 0j
    return F.real, F.imag


def rates(heading, u, r, p, sL, m, J, R):
    v = u + 1j * sL * r
    F = -R * v / abs(v) if v else 0j
    G = (u - 1j * p * r) * cmath.exp(1j * heading)
    return G, r, F.real / m - p * r * r, (sL * F.imag + m * p * u * r) / J


def constants(locked, mass, yaw_inertia, front, rear, friction, gravity):
    p = free_axle(locked, front, rear)
    R = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return p, (front + rear) * (1 if locked == "front" else -1), mass, yaw_inertia + mass * p * p, R


def state_derivative(t, state, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    c = constants(locked, mass, yaw_inertia, front, rear, friction, gravity)
    G, r, du, dr = rates(state[2], state[3], state[4], *c)
    return G.real, G.imag, r, du, dr


def simulate(t, state, locked, **car):
    p, sL, m, J, R = c = constants(locked, **car)
    x, y, heading, u, r = map(float, state)
    z = [x + 1j * y, heading, u, r]
    slowest = 1e-7 * abs(u + 1j * sL * r)

    def step(z, h):
        k1 = rates(*z[1:], *c)
        k2 = rates(*[a + h / 2 * b for a, b in zip(z[1:], k1[1:])], *c)
        k3 = rates(*[a + h / 2 * b for a, b in zip(z[1:], k2[1:])], *c)
        k4 = rates(*[a + h * b for a, b in zip(z[1:], k3[1:])], *c)
        return [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(z, k1, k2, k3, k4)]

    rows, now, rest = [tuple(state)], t[0], abs(u + 1j * sL * r) == 0
    for then in t[1:]:
        while now < then and not rest:
            v = abs(z[2] + 1j * sL * z[3])
            quick = R / v * max(1 / m, sL * sL / J) + abs(z[3]) * (1 + m * sL * sL / J) + m * abs(p) * abs(z[2]) / J
            h = min(then - now, 0.02 / quick)
            z, now = step(z, h), now + h
            if h < 1e-14 * abs(now):
                now = then
            rest = abs(z[2] + 1j * sL * z[3]) < slowest
        if rest:
            z[2] = z[3] = 0.0
        now = then
        rows.append((z[0].real, z[0].imag, z[1], z[2], z[3]))
    return rows


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    v = state[3] - 1j * free_axle(locked, front, rear) * state[4]
    return mass * abs(v) ** 2 / 2 + yaw_inertia * state[4] ** 2 / 2


def yaw_growth_rate(speed, locked, **car):
    p, sL, m, J, R = constants(locked, **car)
    return m * p * speed / J - R * sL**2 / speed / J


def critical_speed(locked, *, front, rear, friction, gravity):
    return math.inf if free_axle(locked, front, rear) < 0 else math.sqrt(friction * gravity) * math.sqrt(front + rear)


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    p, sL, m, J, R = constants(locked, **car)
    return yaw_rate0 * (speed / speed0) ** (m * sL**2 / J) * math.exp(m * m * p / (2 * R * J) * (speed0**2 - speed**2))


def free_body_diagram(state, locked, *, mass, front, rear, friction, gravity):
    x, y, heading, speed, yaw_rate = map(float, state)
    free, along = free_axle(locked, front, rear), cmath.exp(1j * heading)
    drags, slide = (front if locked == "front" else -rear), dragging_velocity(speed, yaw_rate, locked, front, rear)
    forces = [(free, 1j)] + ([(drags, -slide)] if slide and friction * gravity else [])
    pairs = [(x + 1j * y + place * along, force * along) for place, force in forces]
    return [((place.real, place.imag), (force.real, force.imag)) for place, force in pairs]
