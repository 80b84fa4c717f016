"""angular_momentum leaves out R.

fails: angular_momentum_is_in_space_axes
suspect: body components
"""


def angular_momentum(R, omega, *, inertia):
    return np.multiply(inertia, omega)
