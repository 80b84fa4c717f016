"""The axes of hw14 by the direction across the track; diagnosis tries mistakes in these, which functions share."""

import numpy as np


def _frame(state):
    """Return (3, 3), the rows e1, e2, e3."""
    e1, across = np.array([[np.cos(state[2]), np.sin(state[2]), 0.0], [-np.sin(state[2]), np.cos(state[2]), 0.0]])
    c, s, vertical = np.cos(state[3]), np.sin(state[3]), np.array([0.0, 0.0, 1.0])
    return np.array([e1, c * across + s * vertical, c * vertical - s * across])
