"""m a^2 is added to A for the rate along e2, but the contact lies on e2.

fails: energy_is_kinetic_and_potential
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right + 0.5 * mass * (radius * yaw_rate * math.sin(tilt)) ** 2
