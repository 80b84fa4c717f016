"""The turning about the diameter has Omega where Omega cos(lean) belongs.

fails: settling_energy_adds_up
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return inertia[0] * omega**2 / 2 + mass * gravity * radius * math.cos(lean)
