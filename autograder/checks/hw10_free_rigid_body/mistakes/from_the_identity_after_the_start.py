"""The rotations go on from the identity, not from the given R.

fails: attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, np.eye(3), omega, inertia=inertia)
    return omegas, np.concatenate([R[None], rotations[1:]])
