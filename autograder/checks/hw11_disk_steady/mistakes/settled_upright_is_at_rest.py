"""The energy of the limit upright lacks its kinetic part, as if the coin stood still.

fails: settling_energy_adds_up
"""

_right = settling_energy


def settling_energy(lean, **disk):
    return _right(lean, **disk) if lean else disk["mass"] * disk["gravity"] * disk["radius"]
