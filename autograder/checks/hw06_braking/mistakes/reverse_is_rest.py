"""A car that goes straight back is treated as stopped, because its speed is not positive.

fails: simulate_needs_no_dense_times, simulate_glides_without_friction, mechanics_refuses_other_axles
"""

_right = simulate


def simulate(t, state, locked, **car):
    if state[3] <= 0 and state[4] == 0:
        states = np.tile(state, (len(t), 1))
        states[1:, 3:] = 0.0
        return states
    return _right(t, state, locked, **car)
