"""The centre's speed is that of the spin alone.

fails: energy_is_kinetic_and_potential
suspect: left out that comes from tilt'
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right - 0.5 * mass * (radius * tilt_rate) ** 2
