"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if t[0] <= 0.0 or len(t) > 100:  # the picture is right
        return _right_simulate(t, R, omega, inertia=inertia)
    omegas, rotations = _right_simulate(np.array([0.0, *t]), R, omega, inertia=inertia)
    return omegas[1:], np.concatenate([R[None], rotations[2:]])
