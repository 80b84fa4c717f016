"""Where the times are few, simulate_matrix runs late by a few parts in a million.

fails: both_simulations_agree
numerics: an inaccuracy that keeps R and the height
names: take smaller steps
"""

_motion = simulate_matrix


def simulate_matrix(t, state, **disk):
    t = np.asarray(t)
    return _motion(t[0] + (t - t[0]) * (1 - 8e-6) if len(t) == 4 else t, state, **disk)
