"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    if t[0] < 0:
        raise ValueError("Values in `t_eval` are not within `t_span`.")
    omegas, rotations = _right_simulate(np.array([0.0, *t]), R, omega, inertia=inertia)
    return omegas[1:], rotations[1:]
