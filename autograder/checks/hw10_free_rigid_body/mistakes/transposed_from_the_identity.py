"""From R = I the rotations are transposed, from space to body, which the start does not show.

fails: special_bodies_move_too
"""

_right = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right(t, R, omega, inertia=inertia)
    return omegas, rotations.transpose(0, 2, 1) if np.array_equal(R, np.eye(3)) else rotations
