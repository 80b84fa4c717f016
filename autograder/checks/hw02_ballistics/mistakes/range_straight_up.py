"""A launch straight up gets the range of one at 45 degrees.

fails: range_is_where_it_lands
"""

_right_range = horizontal_range


def horizontal_range(speed, angle, *, mass, drag, gravity):
    right = _right_range(speed, angle, mass=mass, drag=drag, gravity=gravity)
    return speed**2 / gravity if angle == math.pi / 2 else right
