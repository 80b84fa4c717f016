"""The critical speed does not depend on the locked axle; with the front locked the car is always stable.

fails: critical_speed_is_where_growth_begins
"""


def critical_speed(locked, *, front, rear, friction, gravity):
    return math.sqrt(friction * gravity * abs(_axles(locked, front, rear)[1]))
