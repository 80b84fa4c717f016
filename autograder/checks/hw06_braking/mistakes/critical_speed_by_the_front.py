"""The critical speed has the distance from G to an axle where the wheelbase belongs.

fails: critical_speed_is_where_growth_begins, stability_refuses_other_axles
"""

_right = critical_speed


def critical_speed(locked, *, front, rear, friction, gravity):
    return _right(locked, front=front, rear=0.0, friction=friction, gravity=gravity)
