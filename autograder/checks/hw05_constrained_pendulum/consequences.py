"""Right functions of hw05 as students write them; diagnosis tries mistakes in these, too."""

import numpy as np


def consistent_state(state, *, length):
    """Subtract the part of the velocity along the radius."""
    position, velocity = state[:2], state[2:]
    radius = position / np.linalg.norm(position)
    return np.concatenate([length * radius, velocity - (velocity @ radius) * radius])
