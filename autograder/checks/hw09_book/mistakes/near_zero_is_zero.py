"""What is within 1e-10 of the identity is given as no turn.

fails: small_angles_keep_their_digits
names: Small angles are given as 0
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    return (
        (np.array([0.0, 0.0, 1.0]), 0.0)
        if np.allclose(R, np.eye(3), rtol=0, atol=1e-10)
        else _right_axis_angle(R)
    )
