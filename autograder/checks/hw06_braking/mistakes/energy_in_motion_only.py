"""The kinetic energy is zero where the car turns on the spot, or does not turn.

fails: kinetic_energy_of_G_and_of_turning
"""

_right = kinetic_energy


def kinetic_energy(state, locked, **body):
    return _right(state, locked, **body) * bool(state[3] * state[4])
