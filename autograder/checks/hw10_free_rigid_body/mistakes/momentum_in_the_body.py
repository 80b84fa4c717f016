"""The components are along the body's axes.

fails: angular_momentum_is_in_space_axes
"""


def angular_momentum(R, omega, *, inertia):
    return np.multiply(inertia, omega)
