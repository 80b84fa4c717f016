"""Omega, about the vertical, for the rate at which the disk turns about its diameter.

fails: settling_energy_adds_up
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return inertia[0] * omega**2 / 2 + mass * gravity * radius * math.cos(lean)
