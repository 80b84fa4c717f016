"""Near pi the axis comes from square roots of the diagonal: a small component loses half of its digits.

fails: axes_with_small_components_keep_their_digits
names: Only its small components are off
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    if angle < 3:
        return n, angle
    cosine = math.cos(angle)
    squares = (np.diag(R) - cosine) / (1 - cosine)
    return np.copysign(np.sqrt(np.clip(squares, 0, None)), n), angle
