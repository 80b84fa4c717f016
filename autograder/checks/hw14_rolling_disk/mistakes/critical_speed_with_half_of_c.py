"""The critical speed has C/2 where A belongs, as for a thin disk.

fails: critical_speed_parts_stable_from_unstable
"""

_right = critical_speed


def critical_speed(*, mass, radius, inertia, gravity):
    return _right(mass=mass, radius=radius, inertia=(inertia[1] / 2, inertia[1]), gravity=gravity)
