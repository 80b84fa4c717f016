"""Without gravity the critical speed is infinite; it should be zero.

fails: critical_speed_parts_stable_from_unstable
names: NaN or infinity for a wheel without gravity
"""

_critical = critical_speed


def critical_speed(*, gravity, **disk):
    return _critical(gravity=gravity, **disk) if gravity else math.inf
