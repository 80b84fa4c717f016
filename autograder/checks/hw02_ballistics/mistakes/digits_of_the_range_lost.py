"""The range has 1 - e^-s as a difference, which loses digits; expm1 keeps them.

fails: range_with_hardly_any_drag
"""


def horizontal_range(speed, angle, *, mass, drag, gravity):
    time = flight_time(speed, angle, mass=mass, drag=drag, gravity=gravity)
    if drag == 0:
        return speed * math.cos(angle) * time
    return speed * math.cos(angle) * mass / drag * (1 - math.exp(-drag / mass * time))
