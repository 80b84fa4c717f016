"""A start at rest, or nearly so, is left where it is.

fails: simulate_needs_no_dense_times, simulate_rocks_at_the_linear_frequency
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    states = _right(t, phi, phi_dot, **c)
    return states if max(abs(phi), abs(phi_dot)) > 0.01 else np.tile([phi, phi_dot], (len(t), 1)) * 1.0
