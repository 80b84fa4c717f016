"""Angles within 1e-8 of pi are given as pi.

fails: angles_near_pi_keep_their_digits
names: Angles near pi are given as pi
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return n, math.pi if angle > math.pi - 1e-8 else angle
