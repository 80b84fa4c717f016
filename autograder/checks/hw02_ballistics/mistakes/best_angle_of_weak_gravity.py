"""Launches where gravity is below 0.1 m/s^2 get the best angle of those without drag, however little pulls them.

fails: best_angle_is_45_degrees_without_drag
names: where gravity is weak
"""

_right_best_angle = best_angle


def best_angle(speed, *, mass, drag, gravity):
    if gravity < 0.1:
        return math.pi / 4
    return _right_best_angle(speed, mass=mass, drag=drag, gravity=gravity)
