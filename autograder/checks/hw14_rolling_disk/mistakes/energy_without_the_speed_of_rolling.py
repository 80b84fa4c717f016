"""The centre's speed is that of tilting alone.

fails: energy_is_kinetic_and_potential
suspect: left out that comes from the spin
"""

_energy = energy


def energy(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    right = _energy(state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)
    return right - 0.5 * mass * (radius * _spin(state)) ** 2
