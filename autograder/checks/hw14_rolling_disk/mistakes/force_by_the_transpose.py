"""You turned the acceleration from e1, e2, e3 to x, y, z with the transposed matrix.

fails: contact_force_moves_the_centre
"""

_force = contact_force


def contact_force(state, *, mass, gravity, **disk):
    weight = np.array([0.0, 0.0, mass * gravity])
    acceleration = _frame(state) @ (_force(state, mass=mass, gravity=gravity, **disk) - weight)
    return _frame(state) @ acceleration + weight
