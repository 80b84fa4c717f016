"""Right: the classical Runge-Kutta method with small fixed steps of its own between the times asked for."""

import math

import numpy as np


def weight_moment(phi, m, r, e, s, g):
    return m * g * (r * math.sin(s) - e * math.sin(phi + s))


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * ((radius - offset * math.cos(phi)) ** 2 + (offset * math.sin(phi)) ** 2)


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    C = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    return weight_moment(phi, mass, radius, offset, slope, gravity) / C


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * phi_dot * phi_dot * radius * offset * math.sin(phi)


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    M = weight_moment(phi, mass, radius, offset, slope, gravity)
    M -= missing_moment(phi, phi_dot, mass=mass, radius=radius, offset=offset)
    return M / contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    p = acceleration(phi, phi_dot, mass=mass, radius=radius, offset=offset, inertia=inertia, slope=slope, gravity=gravity)
    c, s = math.cos(phi), math.sin(phi)
    ax = radius * p - offset * c * p + offset * s * phi_dot**2
    ay = offset * s * p + offset * c * phi_dot**2
    return np.float64(mass) * ax - mass * gravity * math.sin(slope), mass * ay + mass * gravity * math.cos(slope)


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    vx, vy = (radius - offset * math.cos(phi)) * phi_dot, offset * math.sin(phi) * phi_dot
    fallen = radius * phi * math.sin(slope) + offset * math.cos(phi + slope)
    return 0.5 * mass * (vx**2 + vy**2) + 0.5 * inertia * phi_dot**2 - mass * gravity * fallen


def simulate(t, phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    # all in plain floats: (a0 + a1 sin(phi + slope) + a2 sin(phi) w^2) / (b0 - b1 cos(phi))
    a0, a1, a2 = mass * gravity * radius * math.sin(slope), -mass * gravity * offset, -mass * radius * offset
    b0, b1 = inertia + mass * (radius**2 + offset**2), 2 * mass * radius * offset

    def f(p, w):
        return (a0 + a1 * math.sin(p + slope) + a2 * math.sin(p) * w * w) / (b0 - b1 * math.cos(p))

    fastest = abs(phi_dot) + math.sqrt(gravity / radius) * (2 + math.sqrt(gravity / radius) * (t[-1] - t[0]) * math.sin(slope))
    rows = [(phi, phi_dot)]
    for now, then in zip(t, t[1:]):
        p, w = rows[-1]
        n = math.ceil((then - now) * fastest / 0.01)
        h = (then - now) / n
        for _ in range(n):
            p1, w1 = w, f(p, w)
            p2, w2 = w + h / 2 * w1, f(p + h / 2 * p1, w + h / 2 * w1)
            p3, w3 = w + h / 2 * w2, f(p + h / 2 * p2, w + h / 2 * w2)
            p4, w4 = w + h * w3, f(p + h * p3, w + h * w3)
            p, w = p + h / 6 * (p1 + 2 * p2 + 2 * p3 + p4), w + h / 6 * (w1 + 2 * w2 + 2 * w3 + w4)
        rows.append((p, w))
    return rows


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    contact = (0.0, -radius)
    down = (np.sin(slope), -np.cos(slope))
    heavy = (-offset * np.sin(phi), -offset * np.cos(phi))
    return [(contact, (-1.0, 0.0)), (contact, (0.0, mass)), (heavy, down)]
