"""The energy lacks the centre's motion by tilt'.

fails: energy_is_kinetic_and_potential
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right - 0.5 * mass * (radius * tilt_rate) ** 2
