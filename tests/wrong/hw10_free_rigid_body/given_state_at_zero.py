"""The given state is taken for that at t = 0.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
suspect: the given state taken for that at t = 0
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(np.array([0.0, t[0]]), R, omega, inertia=inertia)
    return _right_simulate(t, rotations[-1], omegas[-1], inertia=inertia)
