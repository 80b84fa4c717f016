"""At a low speed the best angle is a series of first order in the drag.

fails: best_angle_is_45_degrees_without_drag
numerics: the next term of the series
"""

_right_best_angle = best_angle


def best_angle(speed, *, mass, drag, gravity):
    swiftness = drag * speed / (mass * gravity)
    if swiftness < 0.01:
        return math.pi / 4 - math.sqrt(2) / 6 * swiftness
    return _right_best_angle(speed, mass=mass, drag=drag, gravity=gravity)
