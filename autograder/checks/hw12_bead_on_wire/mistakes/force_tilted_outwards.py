"""The normal is tilted to the wrong side; it should be along (-2 c x, 1).

fails: force_and_weight_make_the_acceleration
"""

_right = constraint_force


def constraint_force(x, v, **bead):
    along_x, along_y = _right(x, v, **bead)
    return np.array([-along_x, along_y])
