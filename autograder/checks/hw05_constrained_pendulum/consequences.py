"""Right functions of hw05 as students write them: a slip in these is sought, too."""

import numpy as np


def consistent_state(state, *, length):
    """Less the part of the velocity along the radius."""
    position, velocity = state[:2], state[2:]
    radius = position / np.linalg.norm(position)
    return np.concatenate([length * radius, velocity - (velocity @ radius) * radius])
