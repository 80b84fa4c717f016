"""You multiply in the wrong order; R(t) is R(t[0]) times the turn since then, as omega has body components.

fails: attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, turns = _right_simulate(t, np.eye(3), omega, inertia=inertia)
    return omegas, turns @ R
