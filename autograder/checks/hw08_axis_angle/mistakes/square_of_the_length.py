"""The length is the root of a sum of squares, which is 0 or infinite for 1e-200 and 1e200: scale the axis first.

fails: matrix_depends_on_the_direction_alone, vector_turns_by_every_angle
"""


def _unit(axis):
    if not (np.isfinite(axis).all() and np.any(axis)):
        raise ValueError("no axis")
    return axis / np.linalg.norm(axis)
