"""The exponent is not divided by the mass.

fails: range_is_where_it_lands
"""

_right_range = horizontal_range


def horizontal_range(speed, angle, *, mass, drag, gravity):
    if drag == 0:
        return _right_range(speed, angle, mass=mass, drag=drag, gravity=gravity)
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * mass / drag * -math.expm1(-drag * time)
