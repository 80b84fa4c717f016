"""The weight's potential energy has the wrong sign.

fails: energy_is_kinetic_and_potential
"""

def energy(state, *, mass, gravity):
    return mass * (state[2] ** 2 + state[3] ** 2) / 2 - mass * gravity * state[1]
