"""The energy lacks the turning about the axle.

fails: energy_is_kinetic_and_potential
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right - 0.5 * inertia[1] * _spin(state) ** 2
