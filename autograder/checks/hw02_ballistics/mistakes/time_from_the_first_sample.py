"""The closed form counts the time from the first sample.

fails: trajectory_counts_time_from_the_launch
names: times that do not begin at 0
"""

from_launch = trajectory


def trajectory(t, speed, angle, **known):
    return from_launch(t - t[0], speed, angle, **known)
