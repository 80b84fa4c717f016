"""The range is the launch's horizontal speed times the flight time.

fails: range_is_where_it_lands
suspect: drag on the vertical component alone
"""


def horizontal_range(speed, angle, **known):
    return speed * math.cos(angle) * flight_time(speed, angle, **known)
