"""The horizontal motion lacks drag, which acts on both components.

fails: range_is_where_it_lands
"""


def horizontal_range(speed, angle, **known):
    return speed * math.cos(angle) * flight_time(speed, angle, **known)
