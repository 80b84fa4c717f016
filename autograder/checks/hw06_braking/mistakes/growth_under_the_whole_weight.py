"""The growth rate has friction under the whole weight; only the locked axle's load counts.

fails: growth_rate_is_the_slope
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    free, arm = _axles(locked, front, rear)
    turning = mass * free * speed - friction * mass * gravity * arm**2 / speed
    return turning / (yaw_inertia + mass * free**2)
