"""Where c v/(m g) is below 1e-4 the drag counts as none.

fails: flight_time_with_hardly_any_drag, range_with_hardly_any_drag
names: very little drag is not none
numerics: how little drag is none
"""

_right_time, _right_range = flight_time, horizontal_range


def flight_time(speed, angle, *, mass, drag, gravity):
    if drag * speed < 1e-4 * mass * gravity:
        return 2 * speed * math.sin(angle) / gravity
    return _right_time(speed, angle, mass=mass, drag=drag, gravity=gravity)


def horizontal_range(speed, angle, *, mass, drag, gravity):
    if drag * speed < 1e-4 * mass * gravity:
        return speed**2 * math.sin(2 * angle) / gravity
    return _right_range(speed, angle, mass=mass, drag=drag, gravity=gravity)
