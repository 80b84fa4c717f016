"""The best angle without drag is taken for that with drag.

fails: best_angle_has_the_largest_range
suspect: 45 degrees always
"""


def best_angle(speed, *, mass, drag, gravity):
    return math.pi / 4
