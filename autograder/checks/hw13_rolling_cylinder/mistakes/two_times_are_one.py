"""Of two times the second is never reached.

fails: simulate_needs_no_dense_times
names: row 1 is the start again
"""

import numpy as np

_right = simulate


def simulate(t, phi, phi_dot, **cylinder):
    found = np.array(_right(t, phi, phi_dot, **cylinder))
    return found if len(t) > 2 else found[[0, 0]]
