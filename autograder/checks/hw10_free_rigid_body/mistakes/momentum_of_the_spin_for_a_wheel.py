"""For a body with A = B the angular momentum has only the spin about the symmetry axis.

fails: angular_momentum_is_in_space_axes
"""

_right_momentum = angular_momentum


def angular_momentum(R, omega, *, inertia):
    A, B, C = inertia
    return C * omega[2] * np.asarray(R)[:, 2] if A == B else _right_momentum(R, omega, inertia=inertia)
