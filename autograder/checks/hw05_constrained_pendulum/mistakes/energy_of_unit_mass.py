"""The energy of one kilogram.

fails: energy_is_kinetic_and_potential
suspect: 1 kg
"""

def energy(state, *, mass, gravity):
    return (state[2] ** 2 + state[3] ** 2) / 2 + gravity * state[1]
