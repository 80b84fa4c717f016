"""roll' stands for the total spin, but yaw' has a part along the axle too.

fails: energy_is_kinetic_and_potential
"""


_energy = energy


def energy(state, **disk):
    return _energy([*state[:7], state[7] - state[5] * math.cos(state[3])], **disk)
