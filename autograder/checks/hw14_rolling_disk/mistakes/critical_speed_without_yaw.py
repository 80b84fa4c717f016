"""A and C are swapped in the critical speed.

fails: critical_speed_parts_stable_from_unstable
"""


_speed = critical_speed


def critical_speed(*, inertia, **disk):
    return _speed(inertia=inertia[::-1], **disk)
