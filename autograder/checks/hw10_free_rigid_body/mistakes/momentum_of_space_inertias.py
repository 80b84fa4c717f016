"""R omega is multiplied by A, B, C, which belong to body axes.

fails: angular_momentum_is_in_space_axes
"""


def angular_momentum(R, omega, *, inertia):
    return np.multiply(inertia, R @ omega)
