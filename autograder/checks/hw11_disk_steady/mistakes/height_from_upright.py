"""The potential energy is 0 where the disk stands upright.

fails: settling_energy_adds_up
suspect: the potential 0 where G of the upright disk is
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return mass * gravity * radius * (1.5 * math.cos(lean) - 1.0)
