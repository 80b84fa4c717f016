"""The given state is taken for that at t = 0.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    before = t[0] - abs(t[0])
    omegas, rotations = _right_simulate(np.concatenate([[before], t]), R, omega, inertia=inertia)
    return omegas[1:], rotations[1:]
