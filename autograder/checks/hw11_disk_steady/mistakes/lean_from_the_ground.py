"""The energy has the sine where the cosine belongs; the lean is measured from the vertical.

fails: settling_energy_adds_up
"""


def settling_energy(lean, *, mass, radius, inertia, gravity):
    return 1.5 * mass * gravity * radius * math.sin(lean)
