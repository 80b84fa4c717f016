"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    way = -1 if t[0] < 0 else 1  # backwards it is the motion with omega reversed
    omegas, rotations = _right_simulate(np.array([0.0, abs(t[0])]), R, way * omega, inertia=inertia)
    return _right_simulate(t, rotations[-1], way * omegas[-1], inertia=inertia)
