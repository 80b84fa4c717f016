"""In the critical speed m a^2 is missing beside C.

fails: critical_speed_parts_stable_from_unstable
"""


def critical_speed(*, mass, radius, inertia, gravity):
    return radius * math.sqrt(mass * gravity * radius * inertia[0]) / inertia[1]
