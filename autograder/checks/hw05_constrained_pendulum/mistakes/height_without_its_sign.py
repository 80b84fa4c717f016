"""The energy takes the size of the height, which has lost its sign.

fails: energy_is_kinetic_and_potential
"""

_right_energy = energy


def energy(state, **parameters):
    return _right_energy(np.array([state[0], abs(state[1]), *state[2:]]), **parameters)
