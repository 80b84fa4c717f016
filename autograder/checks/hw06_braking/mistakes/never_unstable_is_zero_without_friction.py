"""Without friction the result is 0, even with the front locked, where the car is never unstable.

fails: critical_speed_is_where_growth_begins
"""

_right = critical_speed


def critical_speed(locked, *, front, rear, friction, gravity):
    found = _right(locked, front=front, rear=rear, friction=friction, gravity=gravity)
    return found if friction * gravity else 0.0
