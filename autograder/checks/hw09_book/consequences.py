"""Right functions of hw09 by the trace; diagnosis tries mistakes in these, too."""

import math

import numpy as np


def axis_angle(R):
    """Use an arccos of the trace, which loses digits near 0 and pi; a mistake hides that."""
    R = _rotation(R)
    angle = math.acos(min(max((np.trace(R) - 1) / 2, -1.0), 1.0))
    n = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return n / np.linalg.norm(n), angle
