"""The energy for a lean that is measured from the ground.

fails: settling_energy_adds_up
suspect: the sine for the cosine
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return 1.5 * mass * gravity * radius * math.sin(lean)
