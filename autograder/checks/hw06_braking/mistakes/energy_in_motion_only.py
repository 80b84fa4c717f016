"""Where the car turns on the spot, or does not turn, the kinetic energy is taken for that of a car at rest.

fails: kinetic_energy_of_G_and_of_turning
"""

_right = kinetic_energy


def kinetic_energy(state, locked, **body):
    return _right(state, locked, **body) * bool(state[3] * state[4])
