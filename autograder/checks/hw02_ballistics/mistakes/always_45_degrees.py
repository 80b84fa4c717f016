"""The best angle is always 45 degrees, which is right only without drag.

fails: best_angle_has_the_largest_range
"""


def best_angle(speed, *, mass, drag, gravity):
    return math.pi / 4
