"""A single time is taken for that of the launch. The range, which has its own, is right.

fails: trajectory_counts_time_from_the_launch
names: a single time
"""

_right_trajectory = trajectory


def trajectory(t, *launch, **known):
    return _right_trajectory(t, *launch, **known) * (len(t) > 1)
