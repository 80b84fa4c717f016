"""The sine is a root of 1 - cos^2, so every launch goes up.

fails: trajectory_is_the_motion
"""

_right_trajectory = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    upwards = math.acos(max(-1.0, min(1.0, math.cos(angle))))
    return _right_trajectory(t, speed, upwards, mass=mass, drag=drag, gravity=gravity)
