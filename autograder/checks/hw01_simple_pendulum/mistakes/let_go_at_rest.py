"""The motion leaves out omega at the start.

fails: simulate_swings
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, **rod):
    return _right_simulate(t, theta0, 0.0, **rod)
