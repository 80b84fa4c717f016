"""The times are rounded to a millisecond.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if len(t) > 100:  # the picture is right
        return _right_simulate(t, R, omega, inertia=inertia)
    return _right_simulate(np.round(t, 3), R, omega, inertia=inertia)
