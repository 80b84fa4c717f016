"""sqrt(g a / 3), whatever the inertias.

fails: critical_speed_parts_stable_from_unstable
"""


def critical_speed(*, mass, radius, inertia, gravity):
    return math.sqrt(gravity * radius / 3)
