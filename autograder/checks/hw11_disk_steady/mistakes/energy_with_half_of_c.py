"""The energy has C/2 where A belongs, as for a thin disk.

fails: settling_energy_adds_up
"""

def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    c = math.cos(lean)
    return 0.25 * inertia[1] * (omega * c) ** 2 + mass * gravity * radius * c
