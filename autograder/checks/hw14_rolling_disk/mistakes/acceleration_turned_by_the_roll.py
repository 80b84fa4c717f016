"""The components of the acceleration along e1, e2, e3 are brought to space by R, which rolls.

fails: contact_force_moves_the_centre
"""


_force = contact_force


def contact_force(state, *, mass, gravity, **disk):
    weight = np.array([0.0, 0.0, mass * gravity])
    along = _frame(state) @ (_force(state, mass=mass, gravity=gravity, **disk) - weight)
    return np.reshape(matrix_state(state, radius=disk["radius"])[3:12], (3, 3)) @ along + weight
