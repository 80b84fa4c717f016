"""The equation for the best angle is divided by the drag, which may be zero.

fails: best_angle_is_45_degrees_without_drag
names: ZeroDivisionError for no drag
"""

with_drag = best_angle


def best_angle(speed, *, mass, drag, gravity):
    terminal = mass * gravity / drag
    return with_drag(speed / terminal, mass=1.0, drag=1.0, gravity=1.0)
