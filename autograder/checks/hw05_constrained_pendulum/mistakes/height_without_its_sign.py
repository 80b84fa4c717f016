"""The potential energy of the height's absolute value.

fails: energy_is_kinetic_and_potential
suspect: the height without its sign
"""

_right_energy = energy


def energy(state, **parameters):
    return _right_energy(np.array([state[0], abs(state[1]), *state[2:]]), **parameters)
