"""The times are counted from the first; the launch is at t = 0.

fails: trajectory_counts_time_from_the_launch
"""

from_launch = trajectory


def trajectory(t, speed, angle, **known):
    return from_launch(t - t[0], speed, angle, **known)
