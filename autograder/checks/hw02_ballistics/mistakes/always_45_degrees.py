"""45 degrees hold without drag alone.

fails: best_angle_has_the_largest_range
"""


def best_angle(speed, *, mass, drag, gravity):
    return math.pi / 4
