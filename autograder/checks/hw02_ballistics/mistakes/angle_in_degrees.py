"""The angle is treated as degrees; it is in radians.

fails: trajectory_is_the_motion, both_paths_are_drawn
"""

in_radians = trajectory


def trajectory(t, speed, angle, **known):
    return in_radians(t, speed, np.radians(angle), **known)
