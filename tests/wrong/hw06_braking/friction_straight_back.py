"""Friction only forward or backward.

fails: friction_opposes_the_sliding, equations_of_motion, simulate_brakes
suspect: friction straight back
"""


def _drag_force(speed, yaw_rate, *, arm, drag):
    return -drag * (speed / math.sqrt(speed * speed + 1e-300)), 0.0
