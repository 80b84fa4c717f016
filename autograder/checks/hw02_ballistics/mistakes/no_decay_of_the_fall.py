"""The vertical velocity falls as freely as without drag.

fails: trajectory_is_the_motion
"""

_right_trajectory = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    states = np.array(_right_trajectory(t, speed, angle, mass=mass, drag=drag, gravity=gravity))
    states[:, 3] = speed * math.sin(angle) * np.exp(-drag / mass * t) - gravity * t
    return states
