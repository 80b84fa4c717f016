"""The kinetic energy has C/4 for A/2, at the right precession.

fails: settling_energy_adds_up
suspect: C/2 for A
"""

def settling_energy(lean, *, mass, radius, inertia, gravity):
    omega = common_precession(lean, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    c = math.cos(lean)
    return 0.25 * inertia[1] * (omega * c) ** 2 + mass * gravity * radius * c
