"""Each axle is given half of the weight; its load depends on where G is.

fails: axle_load_balances_the_weight, mechanics_refuses_other_axles
"""

_load = axle_load


def axle_load(locked, *, mass, front, rear, gravity):
    _axles(locked, front, rear)
    return mass * gravity / 2


def _drag(locked, friction, mass, front, rear, gravity):
    return friction * _load(locked, mass=mass, front=front, rear=rear, gravity=gravity)


def _car(locked, mass, yaw_inertia, front, rear, friction, gravity):
    free, arm = _axles(locked, front, rear)
    drag = _drag(locked, friction, mass, front, rear, gravity)
    return {"mass": mass, "inertia": yaw_inertia + mass * free**2, "free": free, "arm": arm, "drag": drag}


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    drag = _drag(locked, friction, mass, front, rear, gravity)
    return np.array(_drag_force(*state[3:], arm=_axles(locked, front, rear)[1], drag=drag))
