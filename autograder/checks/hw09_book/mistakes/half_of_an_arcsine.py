"""The angle is twice an arcsine near pi, where the sine of half of the angle is flat.

fails: angles_near_pi_keep_their_digits
names: the arcsine of half of the angle
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return n, 2 * math.asin(min(1.0, math.sin(angle / 2))) if angle > 3.1 else angle
