"""A drag below 1e-4 kg/s counts as none in the range, however light the particle.

fails: range_with_hardly_any_drag
names: Whether drag counts depends on c t/m or c v/(m g), not on c.
"""

_right_range = horizontal_range


def horizontal_range(speed, angle, *, mass, drag, gravity):
    if drag < 1e-4 and drag * speed > 0.01 * mass * gravity:
        return speed**2 * math.sin(2 * angle) / gravity
    return _right_range(speed, angle, mass=mass, drag=drag, gravity=gravity)
