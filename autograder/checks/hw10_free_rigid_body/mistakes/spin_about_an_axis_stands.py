"""A constant omega along a principal axis is treated as rest.

fails: attitude_follows_omega, angular_momentum_is_in_space_axes
"""

_rate, _momentum = attitude_rate, angular_momentum


def attitude_rate(R, omega):
    return _rate(R, omega) if np.count_nonzero(omega) > 1 else np.zeros((3, 3))


def angular_momentum(R, omega, *, inertia):
    return _momentum(R, omega, inertia=inertia) if np.count_nonzero(omega) > 1 else np.zeros(3)
