"""This is the critical spin, not the speed.

fails: critical_speed_parts_stable_from_unstable
"""


_speed = critical_speed


def critical_speed(**disk):
    return _speed(**disk) / disk["radius"]
