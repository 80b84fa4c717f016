"""The angle is reduced with a pi of nine digits.

fails: vector_turns_by_the_right_hand_rule
names: nearly right: some number in it has too few digits
numerics: nine digits of pi
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    return _right_rotate(r, axis, np.mod(angle, 2 * 3.14159265))
