"""Plain Python: complex numbers for the plane, Runge-Kutta steps that are doubled to see the error."""

import cmath
import math
from itertools import pairwise


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """Energy is I^C(phi) phi'^2 / 2 + V: Lagrange's equation for it."""
    across, inwards = offset * math.sin(phi), radius - offset * math.cos(phi)
    moment = mass * gravity * (inwards * math.sin(slope) - across * math.cos(slope))
    return (moment - mass * radius * across * phi_dot**2) / (inertia + mass * (across**2 + inwards**2))


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * abs(radius - offset * cmath.exp(1j * phi)) ** 2


def naive_contact_acceleration(phi, **c):
    return acceleration(phi, 0.0, **c)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * math.sin(phi) * phi_dot**2


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    c = {"mass": mass, "radius": radius, "offset": offset, "inertia": inertia, "slope": slope}
    turning = acceleration(phi, phi_dot, gravity=gravity, **c)
    # G = radius phi - 1j offset exp(-1j phi), x along and y off the ramp, differentiated twice
    arm = offset * cmath.exp(-1j * phi)
    a = radius * turning - arm * turning + 1j * arm * phi_dot**2
    force = mass * (a - gravity * complex(math.sin(slope), -math.cos(slope)))
    return [force.real, force.imag]


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    turning = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia) * phi_dot**2 / 2
    place = radius * phi - 1j * offset * cmath.exp(-1j * phi)
    return turning + mass * gravity * (place.imag * math.cos(slope) - place.real * math.sin(slope))


def simulate(t, phi, phi_dot, **c):
    def step(p, w, h):
        a = acceleration(p, w, **c)
        b = acceleration(p + h / 2 * w, w + h / 2 * a, **c)
        d = acceleration(p + h / 2 * w + h * h / 4 * a, w + h / 2 * b, **c)
        e = acceleration(p + h * w + h * h / 2 * b, w + h * d, **c)
        return p + h * w + h * h / 6 * (a + b + d), w + h / 6 * (a + 2 * b + 2 * d + e)

    t = [float(one) for one in t]
    p, w = float(phi), float(phi_dot)
    rows, h, angle, rate = [[p, w]], (t[1] - t[0]) / 10, abs(p), abs(w)
    for now, end in pairwise(t):
        while now < end:
            last = now + h >= end
            size = end - now if last else h
            once = step(p, w, size)
            twice = step(*step(p, w, size / 2), size / 2)
            angle, rate = max(angle, abs(twice[0])), max(rate, abs(twice[1]))
            errors = [abs(one - two) for one, two in zip(once, twice, strict=True)]
            error = max(errors[0] / (angle + 1e-300), errors[1] / (rate + 1e-300))
            if error <= 1e-11:
                now = end if last else now + size
                p, w = (two + (two - one) / 15 for one, two in zip(once, twice, strict=True))
            grown = size * min(4, max(0.2, 0.9 * (1e-11 / (error + 1e-30)) ** 0.2))
            h = max(h, grown) if last and error <= 1e-11 else grown
        rows.append([p, w])
    return rows


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    contact = (0.0, -radius)
    down = (math.sin(slope), -math.cos(slope))
    heavy = (-offset * math.sin(phi), -offset * math.cos(phi))
    return [(contact, (-1.0, 0.0)), (contact, (0.0, mass)), (heavy, down)]
