"""Where drag is little, flight time and range are of the first order in it: c v/(m g) = 0.01 leaves them four digits.

fails: flight_time_with_hardly_any_drag, range_with_hardly_any_drag
where: very little drag
"""

_right_time, _right_range = flight_time, horizontal_range


def flight_time(speed, angle, *, mass, drag, gravity):
    lift = drag * speed * math.sin(angle) / (mass * gravity)
    known = {"mass": mass, "drag": drag if lift >= 0.01 else 0.0, "gravity": gravity}
    return _right_time(speed, angle, **known) * (1 if lift >= 0.01 else 1 - lift / 3)


def horizontal_range(speed, angle, *, mass, drag, gravity):
    lift = drag * speed * math.sin(angle) / (mass * gravity)
    known = {"mass": mass, "drag": drag if lift >= 0.01 else 0.0, "gravity": gravity}
    return _right_range(speed, angle, **known) * (1 if lift >= 0.01 else 1 - 4 * lift / 3)
