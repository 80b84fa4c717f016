"""9.81 m/s^2 for gravity in the critical speed.

fails: critical_speed_parts_stable_from_unstable
suspect: 9.81 m/s^2
"""

_critical = critical_speed


def critical_speed(*, gravity, **disk):
    return _critical(gravity=9.81, **disk)
