"""A coefficient of friction below 0.05 is replaced by 0.05.

fails: simulate_glides_without_friction, simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, *, friction, gravity, **car):
    return _right(t, state, locked, friction=max(friction, 0.05), gravity=max(gravity, 0.1), **car)
