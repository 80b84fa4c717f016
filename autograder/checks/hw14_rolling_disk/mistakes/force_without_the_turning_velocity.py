"""The velocity along e1 is not turned by yaw' cos(tilt): the force along e2 is off.

fails: contact_force_moves_the_centre
"""

_force = contact_force


def contact_force(state, *, mass, radius, **disk):
    missing = mass * radius * state[5] * math.cos(state[3]) * _spin(state)
    return _force(state, mass=mass, radius=radius, **disk) + missing * _frame(state)[1]
