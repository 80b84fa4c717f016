"""The drag is not divided by the mass in x, although it is in the flight time.

fails: range_is_where_it_lands
"""

_right_trajectory = trajectory


def horizontal_range(speed, angle, *, mass, drag, gravity):
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return _right_trajectory(np.array([time]), speed, angle, mass=1.0, drag=drag, gravity=gravity)[0, 0]
