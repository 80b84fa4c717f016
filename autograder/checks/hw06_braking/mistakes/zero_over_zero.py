"""At rest the direction of friction is zero over zero; the friction should be zero.

fails: friction_in_any_motion_and_at_rest
names: friction_force returned NaN or infinity
"""


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    velocity = np.array([state[3], _axles(locked, front, rear)[1] * state[4]])
    with np.errstate(all="ignore"):
        return -drag * velocity / np.sqrt(velocity @ velocity)
