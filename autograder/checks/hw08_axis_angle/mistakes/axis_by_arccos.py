"""You get the axis's polar angle from arccos, which rounds to 0 near the z axis.

fails: matrix_turns_by_the_right_hand_rule
names: does an arccos lose them
"""

import math

_right = rotation_matrix


def rotation_matrix(axis, angle):
    x, y, z = _unit(axis)
    polar, azimuth = math.acos(max(-1.0, min(1.0, z))), math.atan2(y, x)
    if polar > 1e-6:
        return _right([x, y, z], angle)
    n = [math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)]
    return _right(n, angle)
