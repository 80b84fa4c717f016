"""C^2 for C (C + m a^2) in the critical speed.

fails: critical_speed_parts_stable_from_unstable
suspect: m a^2 missing beside C
"""


def critical_speed(*, mass, radius, inertia, gravity):
    return radius * math.sqrt(mass * gravity * radius * inertia[0]) / inertia[1]
