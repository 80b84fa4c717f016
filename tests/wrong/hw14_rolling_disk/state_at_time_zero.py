"""simulate_euler takes the given state as that at t = 0.

fails: euler_simulation_follows_the_motion
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    before, after = np.asarray(t)[t < 0], np.asarray(t)[t > 0]
    if len(before):
        return np.array([state] * len(t))
    return _simulate(np.concatenate([[0.0], after]), state, **disk)[1:]
