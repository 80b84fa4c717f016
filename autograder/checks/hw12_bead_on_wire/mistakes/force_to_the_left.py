"""The force always points to the left; it should point to the middle.

fails: force_and_weight_make_the_acceleration
"""

_right = constraint_force


def constraint_force(x, v, **bead):
    along_x, along_y = _right(x, v, **bead)
    return np.array([-abs(along_x), along_y])
