"""The kinetic energy leaves out G's velocity to the side.

fails: kinetic_energy_of_G_and_of_turning
"""


def kinetic_energy(state, locked, *, mass, yaw_inertia, front, rear):
    _axles(locked, front, rear)
    return mass * state[3] ** 2 / 2 + yaw_inertia * state[4] ** 2 / 2
