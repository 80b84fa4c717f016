"""sqrt(g a / 3), whatever the inertias.

fails: critical_speed_parts_stable_from_unstable
suspect: the thin uniform disk's m a^2/4
"""


def critical_speed(*, mass, radius, inertia, gravity):
    return math.sqrt(gravity * radius / 3)
