"""The locked axle's velocity to the side has its distance from G where its distance from the free axle belongs.

fails: friction_opposes_the_sliding
"""


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    free, arm = _axles(locked, front, rear)
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return np.array(_drag_force(*state[3:], arm=free + arm, drag=drag))
