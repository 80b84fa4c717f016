"""The rows are at the times in ascending order.

fails: trajectory_counts_time_from_the_launch
"""

_right_trajectory = trajectory


def trajectory(t, *launch, **known):
    return _right_trajectory(np.sort(t), *launch, **known)
