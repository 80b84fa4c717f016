"""Below a tenth of the terminal speed the drag counts as none.

fails: best_angle_is_45_degrees_without_drag
names: 45 degrees are for no drag
"""

_right_best_angle = best_angle


def best_angle(speed, *, mass, drag, gravity):
    if drag * speed < 0.1 * mass * gravity:
        return math.pi / 4
    return _right_best_angle(speed, mass=mass, drag=drag, gravity=gravity)
