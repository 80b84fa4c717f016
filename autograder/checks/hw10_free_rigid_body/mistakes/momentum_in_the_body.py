"""The angular momentum has components along the body's axes; they should be along the axes of space.

fails: angular_momentum_is_in_space_axes
"""


def angular_momentum(R, omega, *, inertia):
    return np.multiply(inertia, omega)
