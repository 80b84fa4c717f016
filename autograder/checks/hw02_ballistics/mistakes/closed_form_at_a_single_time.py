"""A single time counts as the time of the launch.

fails: trajectory_counts_time_from_the_launch
"""

_right_trajectory = trajectory


def trajectory(t, *launch, **known):
    return _right_trajectory(t, *launch, **known) * (len(t) > 1)
