"""solve_ivp over (min(0, t[0]), t[-1]), and the given attitude put into the first row.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
suspect: the given state taken for that at t = 0
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if t[0] <= 0.0 or len(t) > 100:  # the picture is right
        return _right_simulate(t, R, omega, inertia=inertia)
    omegas, rotations = _right_simulate(np.array([0.0, *t]), R, omega, inertia=inertia)
    return omegas[1:], np.concatenate([R[None], rotations[2:]])
