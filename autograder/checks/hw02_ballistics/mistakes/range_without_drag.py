"""The range lacks drag.

fails: range_is_where_it_lands
"""


def horizontal_range(speed, angle, *, mass, drag, gravity):
    return speed**2 * math.sin(2 * angle) / gravity
