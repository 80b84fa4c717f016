"""The flight time is twice the time to the top; the way down takes longer than the way up.

fails: flight_ends_at_launch_height, range_is_where_it_lands
"""


def flight_time(speed, angle, *, mass, drag, gravity):
    if drag == 0:
        return 2 * speed * math.sin(angle) / gravity
    return 2 * mass / drag * math.log1p(drag * speed * math.sin(angle) / (mass * gravity))
