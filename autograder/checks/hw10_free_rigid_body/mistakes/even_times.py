"""The times are treated as evenly spaced.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
also: the times are treated as evenly spaced, with the first step for all
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    return _right_simulate(np.linspace(t[0], t[-1], len(t)), R, omega, inertia=inertia)
