"""The disk is said to have no kinetic energy, for its centre is at rest.

fails: settling_energy_adds_up
suspect: the potential energy alone
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return mass * gravity * radius * math.cos(lean)
