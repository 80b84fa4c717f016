"""The critical spin instead of the speed.

fails: critical_speed_parts_stable_from_unstable
suspect: the critical spin for the speed
"""


_speed = critical_speed


def critical_speed(**disk):
    return _speed(**disk) / disk["radius"]
