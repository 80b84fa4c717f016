"""A short axis is refused; only the zero axis has no direction.

fails: matrix_depends_on_the_direction_alone, vector_turns_by_every_angle
"""

_any_axis = _unit


def _unit(axis):
    if np.linalg.norm(axis) < 1e-8:
        raise ValueError("no axis")
    return _any_axis(axis)
