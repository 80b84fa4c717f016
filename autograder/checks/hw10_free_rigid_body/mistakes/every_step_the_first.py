"""The times are treated as evenly spaced, with the first step for all.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if len(t) > 100:  # rounding of even times
        return _right_simulate(t, R, omega, inertia=inertia)
    return _right_simulate(t[0] + (t[1] - t[0]) * np.arange(len(t)), R, omega, inertia=inertia)
