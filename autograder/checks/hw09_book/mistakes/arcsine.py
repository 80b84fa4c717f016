"""The angle is the arcsine of half the size of R - R^T where it is not large.

fails: angles_near_pi_keep_their_digits
names: how flat is the cosine there
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    sine = np.linalg.norm([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    if angle > 2:
        return n, angle
    arcsine = math.asin(min(sine, 1.0))
    return n, arcsine if np.trace(R) >= 1 else math.pi - arcsine
