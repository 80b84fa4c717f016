"""The range has x of unit mass at the right time.

fails: range_is_where_it_lands
suspect: the drag force not divided by the mass in x
"""

_right_trajectory = trajectory


def horizontal_range(speed, angle, *, mass, drag, gravity):
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return _right_trajectory(np.array([time]), speed, angle, mass=1.0, drag=drag, gravity=gravity)[0, 0]
