"""Friction has the direction of small angles and its full size along the car.

fails: friction_opposes_the_sliding
"""


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    arm = _axles(locked, front, rear)[1]
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return -drag * np.array([np.sign(state[3]), arm * state[4] / abs(state[3])])
