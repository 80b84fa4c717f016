"""The inertias multiply the space components of omega.

fails: angular_momentum_is_in_space_axes
suspect: R omega times A, B, C
"""


def angular_momentum(R, omega, *, inertia):
    return np.multiply(inertia, R @ omega)
