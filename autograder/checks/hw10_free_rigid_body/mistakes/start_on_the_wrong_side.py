"""The turn since the start is multiplied with the attitude at the start as if it were in space components.

fails: attitude_follows_the_motion, rim_paths_are_drawn
suspect: the given R on the wrong side
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, turns = _right_simulate(t, np.eye(3), omega, inertia=inertia)
    return omegas, turns @ R
