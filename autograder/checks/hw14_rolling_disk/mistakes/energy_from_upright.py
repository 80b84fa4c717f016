"""The potential is 0 where the disk is upright.

fails: energy_is_kinetic_and_potential
suspect: the potential 0 where the disk is upright
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right - mass * gravity * radius
