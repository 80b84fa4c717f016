"""A and C are m a^2/4 and m a^2/2, as for a thin uniform disk, whatever is given.

fails: critical_speed_parts_stable_from_unstable
within: 1e-08
"""


def critical_speed(*, mass, radius, inertia, gravity):
    return math.sqrt(gravity * radius / 3)
