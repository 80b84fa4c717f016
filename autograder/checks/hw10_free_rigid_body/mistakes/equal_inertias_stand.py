"""A body with three equal inertias is left in its attitude; it should turn with omega.

fails: special_bodies_move_too
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    return omegas, np.tile(R, (len(t), 1, 1)) if np.ptp(inertia) == 0 else rotations
