"""Show that prints, warnings, a plot on import, a dataclass, a cache and long doubles pass."""
from __future__ import annotations
import numpy as np
from scipy.integrate import solve_ivp


def _solve(phi, w, mass, radius, offset, inertia, slope, gravity):
    """unknowns phi'', along, normal"""
    s, c = np.sin(phi), np.cos(phi)
    # a_G = phi'' (r - e c, e s) + w^2 (e s, e c)
    gx, gy = -offset * s, radius - offset * c  # from C to G
    M = np.array([
        [mass * (radius - offset * c), -1, 0],
        [mass * offset * s, 0, -1],
        # about G, rolling down (clockwise) positive: r_C/G = (-gx, -gy), moment = ry Fx - rx Fy
        [inertia, gy, -gx],
    ])
    b = np.array([
        mass * gravity * np.sin(slope) - mass * offset * s * w**2,
        -mass * gravity * np.cos(slope) - mass * offset * c * w**2,
        0.0,
    ])
    return np.linalg.solve(M, b)


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    return _solve(phi, phi_dot, mass, radius, offset, inertia, slope, gravity)[0]


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    moment = mass * gravity * (radius * np.sin(slope) - offset * np.sin(phi + slope))
    return moment / contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return mass * radius * offset * np.sin(phi) * phi_dot**2


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    return tuple(_solve(phi, phi_dot, mass, radius, offset, inertia, slope, gravity)[1:])


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    ic = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    x, y = radius * phi - offset * np.sin(phi), -offset * np.cos(phi)
    return ic * phi_dot**2 / 2 + mass * gravity * (y * np.cos(slope) - x * np.sin(slope))


def simulate(t, phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    kw = dict(mass=mass, radius=radius, offset=offset, inertia=inertia, slope=slope, gravity=gravity)
    sol = solve_ivp(
        lambda _, z: (z[1], acceleration(z[0], z[1], **kw)),
        (t[0], t[-1]), (phi, phi_dot), t_eval=t, rtol=1e-9, atol=1e-9,
    )
    return sol.y.T

import warnings
from dataclasses import dataclass
from functools import lru_cache
import matplotlib.pyplot as plt


@dataclass
class Par:
    mass: float
    radius: float = 1.0


print("hello", Par(1.0))
plt.plot([1, 2], [3, 4])
plt.show()


@lru_cache
def _sl(slope):
    return np.longdouble(np.sin(slope))


def contact_inertia(phi, *, mass, radius, offset, inertia):
    print("called with", phi)
    warnings.warn("something")
    return np.longdouble(inertia + mass * (radius**2 + offset**2 - 2 * radius * offset * np.cos(phi)))


if __name__ == "__main__":
    print(simulate(np.linspace(0, 1, 3), 0, 0, mass=1, radius=1, offset=0.1, inertia=1, slope=0.1, gravity=9.8))
    input("press enter")


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    weight = [mass * gravity * np.sin(slope), -mass * gravity * np.cos(slope)]
    return [[[0, -radius], None], [[-offset * np.sin(phi), -offset * np.cos(phi)], weight]]
