"""The gravity is 9.81 m/s^2, whatever is given.

fails: critical_speed_parts_stable_from_unstable
"""

_critical = critical_speed


def critical_speed(*, gravity, **disk):
    return _critical(gravity=9.81, **disk)
