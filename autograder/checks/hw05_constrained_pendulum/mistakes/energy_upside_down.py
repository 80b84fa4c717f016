"""The height counted downwards.

fails: energy_is_kinetic_and_potential
suspect: wrong sign
"""

def energy(state, *, mass, gravity):
    return mass * (state[2] ** 2 + state[3] ** 2) / 2 - mass * gravity * state[1]
