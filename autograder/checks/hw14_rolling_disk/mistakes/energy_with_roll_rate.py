"""The kinetic energy takes the roll rate for the total spin.

fails: energy_is_kinetic_and_potential
suspect: roll' taken for the total spin
"""


_energy = energy


def energy(state, **disk):
    return _energy([*state[:7], state[7] - state[5] * math.cos(state[3])], **disk)
