"""The acceleration of the centre is subtracted from the weight; it must be added.

fails: contact_force_moves_the_centre
"""

_force = contact_force


def contact_force(state, **disk):
    return 2.0 * np.array([0.0, 0.0, disk["mass"] * disk["gravity"]]) - _force(state, **disk)
