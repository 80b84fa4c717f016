"""The matrices are transposed: they go from space to body, and should go from body to space.

fails: attitude_follows_the_motion, rim_paths_are_drawn
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    return omegas, rotations.transpose(0, 2, 1)
