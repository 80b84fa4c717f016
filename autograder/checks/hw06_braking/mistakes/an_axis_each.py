"""Friction has its full size along each of the car's axes; it should oppose the locked axle's velocity.

fails: friction_opposes_the_sliding
"""


def friction_force(state, locked, *, mass, front, rear, friction, gravity):
    size = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    forward, turning = np.sign(state[3:])
    return np.array([-size * forward, -size * (turning if locked == "front" else -turning)])
