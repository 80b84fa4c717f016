"""A drag below 1e-4 kg/s counts as none, however light the particle.

fails: best_angle_is_45_degrees_without_drag
names: Whether drag counts depends on c t/m or c v/(m g), not on c.
"""

_right_best_angle = best_angle


def best_angle(speed, *, mass, drag, gravity):
    if drag < 1e-4 and drag * speed > 1e-5 * mass * gravity:
        return math.pi / 4
    return _right_best_angle(speed, mass=mass, drag=drag, gravity=gravity)
