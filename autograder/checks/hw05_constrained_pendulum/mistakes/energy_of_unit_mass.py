"""The energy lacks the mass, which is right only for 1 kg.

fails: energy_is_kinetic_and_potential
"""

def energy(state, *, mass, gravity):
    return (state[2] ** 2 + state[3] ** 2) / 2 + gravity * state[1]
