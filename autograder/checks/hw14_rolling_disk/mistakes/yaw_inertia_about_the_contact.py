"""The inertia about the contact stands where the yaw has A: the contact force has no moment about e2.

fails: critical_speed_parts_stable_from_unstable
"""


def critical_speed(*, mass, radius, inertia, gravity):
    A, C = inertia
    rolling = mass * radius**2
    return radius * math.sqrt(mass * gravity * radius * (A + rolling) / (C * (C + rolling)))
