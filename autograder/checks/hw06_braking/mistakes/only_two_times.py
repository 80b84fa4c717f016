"""With two times only the start is given back, twice.

fails: simulate_needs_no_dense_times, simulate_glides_without_friction, simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    return states[[0, 0]] if len(t) == 2 else states
