"""A small speed added to the locked axle's, against a division by zero, where it is slow too.

fails: friction_opposes_the_sliding, equations_of_motion
unnamed: how small the added speed is, nobody can tell from what is lost
"""


def _drag_force(speed, yaw_rate, *, arm, drag):
    sliding = _sliding_speed(speed, yaw_rate, arm) + 3e-7
    return -drag * (speed / sliding), -drag * (arm * yaw_rate / sliding)
