"""The potential is 0 where G of the upright disk is; it should be 0 with G on the ground.

fails: settling_energy_adds_up
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return mass * gravity * radius * (1.5 * math.cos(lean) - 1.0)
