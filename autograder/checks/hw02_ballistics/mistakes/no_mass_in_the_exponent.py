"""The mass is missing in the exponent of x alone.

fails: range_is_where_it_lands
suspect: the exponent not divided by the mass
"""

_right_range = horizontal_range


def horizontal_range(speed, angle, *, mass, drag, gravity):
    if drag == 0:
        return _right_range(speed, angle, mass=mass, drag=drag, gravity=gravity)
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed * math.cos(angle) * mass / drag * -math.expm1(-drag * time)
