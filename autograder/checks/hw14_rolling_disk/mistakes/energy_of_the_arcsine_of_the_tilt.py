"""The spin in the energy has |cos(tilt)| where cos(tilt) belongs, a root that is never negative.

fails: energy_is_kinetic_and_potential
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right + 0.5 * (inertia[1] + mass * radius**2) * ((_spin(state) + (abs(math.cos(tilt)) - math.cos(tilt)) * yaw_rate) ** 2 - _spin(state) ** 2)
