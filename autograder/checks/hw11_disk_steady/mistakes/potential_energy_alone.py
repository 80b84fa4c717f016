"""The energy lacks its kinetic part.

fails: settling_energy_adds_up
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return mass * gravity * radius * math.cos(lean)
