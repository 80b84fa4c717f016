"""The acceleration in simulate has length/gravity; it should have gravity/length.

fails: simulate_swings
"""

_right_simulate = simulate


def simulate(t, *state, length, gravity):
    return _right_simulate(t, *state, length=gravity, gravity=length) if gravity else _right_simulate(
        t, *state, length=length, gravity=gravity
    )
