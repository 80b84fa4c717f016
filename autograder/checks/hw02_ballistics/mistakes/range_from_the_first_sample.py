"""The range is zero: the trajectory counts its times from the first.

fails: range_is_where_it_lands
"""

_right_trajectory = trajectory


def horizontal_range(speed, angle, **known):
    t = np.array([flight_time(speed, angle, **known)])
    return _right_trajectory(t - t[0], speed, angle, **known)[0, 0]
