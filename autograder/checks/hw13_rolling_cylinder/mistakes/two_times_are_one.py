"""With only two times the second is never reached.

fails: simulate_needs_no_dense_times
names: every row is the start
"""

import numpy as np

_right = simulate


def simulate(t, phi, phi_dot, **cylinder):
    found = np.array(_right(t, phi, phi_dot, **cylinder))
    return found if len(t) > 2 else found[[0, 0]]
