"""The quaternion at the start is divided by its scalar part, which is zero at a half turn.

fails: special_bodies_move_too
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    scalar = math.sqrt(max(0.0, 1 + np.trace(R))) / 2
    below = 4 * scalar if scalar else 1.0
    x, y, z = (R[2, 1] - R[1, 2]) / below, (R[0, 2] - R[2, 0]) / below, (R[1, 0] - R[0, 1]) / below
    first = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - scalar * z), 2 * (x * z + scalar * y)],
        [2 * (x * y + scalar * z), 1 - 2 * (x * x + z * z), 2 * (y * z - scalar * x)],
        [2 * (x * z - scalar * y), 2 * (y * z + scalar * x), 1 - 2 * (x * x + y * y)],
    ])
    omegas, rotations = _right_simulate(t, first, omega, inertia=inertia)
    return omegas, np.concatenate([R[None], rotations[1:]])
