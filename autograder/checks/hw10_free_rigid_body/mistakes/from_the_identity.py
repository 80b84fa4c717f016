"""The rotations start with the identity, not with the given R.

fails: attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    return _right_simulate(t, np.eye(3), omega, inertia=inertia)
